// Asks the questions of a session: each has its own page, and is answered by a line or a key.
#include <fmt/format.h>

#include "sim/base/utf8.h"
#include "sim/view/play/session.h"

namespace robosim::play {
namespace {

using Kind = terminal::Press::Kind;

constexpr std::size_t kLongestAnswer = 1000;

}  // namespace

terminal::Press Session::read(const Body& body, const std::vector<terminal::Page::Line>& footer) {
  for (;;) {
    std::vector<terminal::Page::Line> lines;
    if (!error_.empty()) lines.push_back({error_, terminal::Ink::bad});
    lines.insert(lines.end(), footer.begin(), footer.end());
    terminal::Page page(console_.size(), console_.look(), lines);
    body(page);
    console_.show(page.finish());
    const terminal::Press press = console_.wait(-1);
    if (press.kind == Kind::end) throw SessionQuit{};
    if (press.kind == Kind::interrupt) throw SessionQuit{true};
    if (press.kind == Kind::nothing) continue;
    return press;
  }
}

std::string Session::ask(const Body& body, const std::string& question,
                         const std::function<void(int)>& arrow) {
  std::string typed;
  const std::string cursor = console_.is_live() ? "_" : "";
  for (;;) {
    const terminal::Press press = read(body, {{question + " " + typed + cursor, terminal::Ink::strong}});
    switch (press.kind) {
      case Kind::enter:
        error_.clear();
        if (typed == "q" || typed == "quit") throw SessionQuit{};
        return typed;
      case Kind::erase:
        erase_last_character(typed);
        break;
      case Kind::character:
        if (typed.size() < kLongestAnswer) typed += press.character;
        break;
      case Kind::up:
        if (arrow) arrow(-1);
        break;
      case Kind::down:
        if (arrow) arrow(+1);
        break;
      default:
        break;
    }
  }
}

}  // namespace robosim::play
