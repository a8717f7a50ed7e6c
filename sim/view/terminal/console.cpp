#include "sim/view/terminal/console.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <ctime>

#include "sim/base/error.h"
#include "sim/base/wall_clock.h"

namespace robosim::terminal {
namespace {

using Kind = Press::Kind;

constexpr int kLook_ms = 200;  // longest delay until a signal is noticed

}  // namespace

ScreenConsole::ScreenConsole(Look look, std::function<bool()> stopped)
    : look_(look), stopped_(std::move(stopped)) {
  screen_.emplace(STDIN_FILENO, STDOUT_FILENO, look_);
}

bool ScreenConsole::is_too_small() {
  const TerminalSize now = size();
  return now.columns < kLeast.columns || now.rows < kLeast.rows;
}

void ScreenConsole::show(const Frame& frame) {
  if (!is_too_small()) return screen_->show(frame);
  const TerminalSize now = size();
  Frame small(now.columns, now.rows);
  small.put(0, 0, "Too small: enlarge", Ink::bad);
  small.put(0, 1, fmt::format("{} x {} to {} x {}", now.columns, now.rows, kLeast.columns, kLeast.rows));
  small.put(0, 2, "q quits", Ink::faint);
  screen_->show(small);
}

Press ScreenConsole::wait(int timeout_ms) {
  const bool was_small = is_too_small();
  do {
    if (stopped_()) return {Kind::interrupt};
    const bool small = is_too_small();
    if (small) show(Frame(0, 0));
    const Press press =
        screen_->wait_press(timeout_ms < 0 || small ? kLook_ms : std::min(timeout_ms, kLook_ms));
    screen_->take_resized();
    if (stopped_()) return {Kind::interrupt};
    if (press.kind == Kind::end || (small && press == Press{Kind::character, 'q'})) return {Kind::end};
    if (!was_small) return press;
  } while (is_too_small());
  return {};
}

std::int64_t ScreenConsole::now_us() { return wall_us(); }

void ScreenConsole::lend(const std::function<void()>& use) {
  screen_.reset();
  try {
    use();
  } catch (...) {
    screen_.emplace(STDIN_FILENO, STDOUT_FILENO, look_);
    throw;
  }
  screen_.emplace(STDIN_FILENO, STDOUT_FILENO, look_);
}

LineConsole::LineConsole(int input, int output, Look look) : input_(input), output_(output), look_(look) {
  look_.colour = false;
}

void LineConsole::flush() {
  std::string text = to_text(pending_, look_);
  text.erase(text.find_last_not_of('\n') + 1);
  text += '\n';
  if (text == shown_) return;
  shown_ = text;
  text += '\n';
  for (std::string_view rest = text; !rest.empty();) {
    const ssize_t n = ::write(output_, rest.data(), rest.size());
    if (n > 0) rest.remove_prefix(static_cast<std::size_t>(n));
    if (n < 0 && errno != EINTR) throw InputError("the standard output cannot be written");
  }
}

Press LineConsole::wait(int timeout_ms) {
  if (timeout_ms >= 0) return {};
  for (;;) {
    const Press press = take_press(bytes_);
    if (press.kind != Kind::nothing) return press;
    if (ended_) {
      flush();
      return {Kind::end};
    }
    if (!in_line_) flush();
    // Reads byte by byte, so that further input is left to the next reader.
    char c = 0;
    const ssize_t n = ::read(input_, &c, 1);
    if (n == 1 && c != '\r') bytes_ += c;
    if (n == 1) in_line_ = c != '\n';
    if (n == 0 || (n < 0 && errno != EINTR)) {
      ended_ = true;
      bytes_ = in_line_ ? "\n" : "";  // completes the last line
    }
  }
}

void LineConsole::lend(const std::function<void()>& use) { use(); }

}  // namespace robosim::terminal
