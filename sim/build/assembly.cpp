#include "sim/build/assembly.h"

#include <algorithm>
#include <vector>

namespace robosim::build {
namespace {

constexpr std::string_view kFunction = "robosim_endless_loop";

std::string_view trim(std::string_view text) {
  constexpr std::string_view kSpace = " \t\r";
  const std::size_t from = text.find_first_not_of(kSpace);
  if (from == std::string_view::npos) return {};
  return text.substr(from, text.find_last_not_of(kSpace) - from + 1);
}

// Returns true for a line without an instruction: an empty line, a directive, or a comment. gcc's marks
// before and after an asm(), such as #APP, are also comments.
bool says_nothing(std::string_view line) {
  return line.empty() || line[0] == '.' || line[0] == '#' || line[0] == '@' || line.substr(0, 2) == "//";
}

struct Jump {
  std::string_view call;    ///< the call that replaces the instruction
  std::string_view target;  ///< empty if the instruction is not an unconditional jump
};

Jump jump_of(std::string_view line) {
  const std::size_t space = line.find_first_of(" \t");
  if (space == std::string_view::npos) return {};
  const std::string_view word = line.substr(0, space);
  if (word == "jmp") return {"call", trim(line.substr(space))};
  if (word == "b") return {"bl", trim(line.substr(space))};
  return {};
}

/// Removes the first line from `text`, and returns the line without its line feed.
std::string_view take_line(std::string_view& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return line;
}

/// Returns the source location in `// 7 "Boot.ino" 1` or `@ 7 "Boot.ino" 1`, without the leading `//` or `@`.
/// Returns an empty text for any other line.
std::string_view place_of_asm(std::string_view line) {
  const std::size_t sign = line.substr(0, 3) == "// " ? 2 : line.substr(0, 2) == "@ " ? 1 : 0;
  if (sign == 0 || line.size() < sign + 6) return {};
  const std::string_view place = line.substr(sign);
  const bool number = place[1] >= '0' && place[1] <= '9';
  const std::string_view end = place.substr(place.size() - 3);
  return number && (end == "\" 1" || end == "\" 2") ? place : std::string_view();
}

}  // namespace

std::string changed_for_host(std::string_view assembly, QuotientByZero quotient) {
  std::string result;
  result.reserve(assembly.size() + assembly.size() / 8);
  std::vector<std::string_view> labels;  // labels directly before the next instruction
  int divisions = 0;
  while (!assembly.empty()) {
    const std::string_view whole = take_line(assembly);
    const std::string_view line = trim(whole);
    if (const std::string_view place = place_of_asm(whole); !place.empty()) {
      result.append("#").append(place).append("\n");
      continue;
    }
    const bool label = !line.empty() && line[0] == whole[0] && line.back() == ':';
    if (label) {
      labels.push_back(line.substr(0, line.size() - 1));
    } else if (!says_nothing(line)) {
      const Jump jump = jump_of(line);
      const bool endless =
          !jump.target.empty() && std::find(labels.begin(), labels.end(), jump.target) != labels.end();
      labels.clear();
      if (endless) {
        result.append("\t").append(jump.call).append("\t").append(kFunction).append("\n");
        continue;
      }
      if (const std::string division = division_of_chip(line, quotient, divisions); !division.empty()) {
        result.append(division);
        ++divisions;
        continue;
      }
    }
    result.append(whole).append("\n");
  }
  return result;
}

}  // namespace robosim::build
