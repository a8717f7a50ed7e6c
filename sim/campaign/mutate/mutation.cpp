#include "sim/campaign/mutate/mutation.h"

#include <fmt/format.h>

namespace robosim::mutate {
namespace {

std::string shown(const std::string& text) {
  std::string line = text.substr(0, text.find('\n'));
  if (line.size() > 60) line = line.substr(0, 57) + "…";
  return line.size() < text.size() && line.find("…") == std::string::npos ? line + " …" : line;
}

}  // namespace

std::string where(const Mutation& mutation) {
  return fmt::format("{}:{}", mutation.edits.front().file, mutation.line);
}

std::string what(const Mutation& mutation) {
  const bool lost = mutation.now.find_first_not_of(' ') == std::string::npos;
  return lost ? fmt::format("`{}` left out", shown(mutation.was))
              : fmt::format("`{}` for `{}`", shown(mutation.now), shown(mutation.was));
}

std::string described(const Mutation& mutation) {
  return fmt::format("{}  {}: {}", where(mutation), mutation.kind, what(mutation));
}

std::string changed(std::string text, const std::vector<Edit>& edits) {
  for (auto edit = edits.rbegin(); edit != edits.rend(); ++edit)
    text.replace(edit->from, edit->to - edit->from, edit->now);
  return text;
}

}  // namespace robosim::mutate
