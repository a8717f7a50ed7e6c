#include "tests/system/console_blocks.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace robosim::test {

namespace {

constexpr std::string_view kAnything = "…";

std::string without_blanks_at_end(std::string line) {
  line.erase(line.find_last_not_of(" \t\r") + 1);
  return line;
}

std::string_view trimmed(std::string_view line) {
  return line.substr(std::min(line.find_first_not_of(' '), line.size()));
}

std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> lines;
  std::istringstream stream{std::string(text)};
  for (std::string line; std::getline(stream, line);) lines.push_back(without_blanks_at_end(line));
  while (!lines.empty() && lines.back().empty()) lines.pop_back();
  while (!lines.empty() && lines.front().empty()) lines.erase(lines.begin());
  return lines;
}

/// Returns whether `line` is `pattern`, in which each `…` stands for any text.
bool fits(std::string_view pattern, std::string_view line) {
  const std::size_t first = pattern.find(kAnything);
  if (first == pattern.npos) return pattern == line;
  if (!line.starts_with(pattern.substr(0, first))) return false;
  pattern.remove_prefix(first + kAnything.size());
  for (std::size_t at = first; at <= line.size(); ++at)
    if (fits(pattern, line.substr(at))) return true;
  return false;
}

/// Returns whether the lines from `line` on match those from `pattern` on. A line `…` stands for any number
/// of lines.
bool fit(const std::vector<std::string>& patterns, std::size_t pattern, const std::vector<std::string>& lines,
         std::size_t line) {
  for (; pattern < patterns.size(); ++pattern, ++line) {
    if (trimmed(patterns[pattern]) == kAnything) {
      for (std::size_t at = line; at <= lines.size(); ++at)
        if (fit(patterns, pattern + 1, lines, at)) return true;
      return false;
    }
    if (line >= lines.size() || !fits(patterns[pattern], lines[line])) return false;
  }
  return line == lines.size();
}

/// The words after ```console.
struct Info {
  bool is_run = true;
  int status = 0, gcc = 0;
};

/// Reads the words. Throws std::invalid_argument.
Info read_info(const std::string& text) {
  if (text.starts_with(" not run: ")) return {false};
  Info info;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    int* const value = word == "status" ? &info.status : word == "gcc" ? &info.gcc : nullptr;
    if (!value || !(words >> *value))
      throw std::invalid_argument("expected 'gcc N', 'status N' or 'not run: REASON', got console" + text);
  }
  return info;
}

}  // namespace

ConsolePage read_console_blocks(std::string_view markdown) {
  constexpr std::string_view kFence = "```", kConsole = "```console", kPrompt = "$ ",
                             kSetup = "<!-- setup: ", kSetupEnd = " -->";
  enum class In { text, console, shown, other } in = In::text;
  ConsolePage page;
  std::istringstream stream{std::string(markdown)};
  int number = 0;
  Info info;
  std::size_t begin = 0;
  for (std::string line; std::getline(stream, line);) {
    ++number;
    if (line.starts_with(kFence)) {
      if (in != In::text) {
        if (in == In::console && page.commands.size() > begin) page.commands.back().status = info.status;
        in = In::text;
      } else if (line.starts_with(kConsole)) {
        begin = page.commands.size();
        info = read_info(line.substr(kConsole.size()));
        in = info.is_run ? In::console : In::shown;
      } else {
        in = In::other;
      }
    } else if (in == In::text && line.starts_with(kSetup) && line.ends_with(kSetupEnd)) {
      line = line.substr(kSetup.size(), line.size() - kSetup.size() - kSetupEnd.size());
      page.commands.push_back({number, line, "", 0, 0, true});
    } else if (in == In::other && line.starts_with(kPrompt)) {
      page.outside.push_back(number);
    } else if (in == In::console && line.starts_with(kPrompt)) {
      page.commands.push_back({number, line.substr(kPrompt.size()), "", 0, info.gcc, false});
    } else if (in == In::console && page.commands.size() > begin) {
      page.commands.back().output += line + "\n";
    }
  }
  return page;
}

bool shows(std::string_view expected, std::string_view actual) {
  const std::vector<std::string> patterns = lines_of(expected);
  return patterns.empty() || fit(patterns, 0, lines_of(actual), 0);
}

}  // namespace robosim::test
