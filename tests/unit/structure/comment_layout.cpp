#include "tests/unit/structure/comment_layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <sstream>
#include <string_view>

namespace robosim::structure {
namespace {

constexpr char kDrawn = '\1';  // replaces an arrow or a part of a frame
constexpr std::size_t kLeastIndent = 2;

/// Converts UTF-8 text to text with one char per character.
std::string in_columns(std::string_view text) {
  std::string columns;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    if ((byte & 0xC0) == 0x80) continue;
    // The characters U+2190 to U+25FF are arrows, operators, frames and shapes.
    const bool drawn = byte == 0xE2 && i + 1 < text.size() &&
                       static_cast<unsigned char>(text[i + 1]) >= 0x86 &&
                       static_cast<unsigned char>(text[i + 1]) <= 0x97;
    columns += drawn ? kDrawn : byte < 0x80 ? text[i] : 'x';
  }
  return columns;
}

/// Returns the position at which the comment at the end of a line begins, or npos.
std::size_t comment_at(std::string_view line) {
  char quote = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (quote != 0) {
      if (line[i] == '\\')
        ++i;
      else if (line[i] == quote)
        quote = 0;
    } else if (line[i] == '"') {
      quote = '"';
    } else if (line.substr(i, 2) == "//" && (i == 0 || line[i - 1] == ' ')) {
      return i;
    }
  }
  return line.npos;
}

/// A line of a comment, without its marker.
struct Line {
  std::string marker;      ///< indentation, and "//" or "///"; "" for code or an empty line
  std::string text;        ///< result of in_columns(), including the indentation
  std::size_t width = 0;   ///< width of the whole line
  std::size_t indent = 0;  ///< indentation of the text
  std::vector<std::pair<std::size_t, std::size_t>> gaps;  ///< gaps between cells: from, to (exclusive)

  bool has_cell_at(std::size_t column) const {
    return std::any_of(gaps.begin(), gaps.end(), [&](const auto& gap) { return gap.second == column; });
  }
};

Line read_line(const std::string& raw) {
  Line line;
  std::size_t begin = raw.find_first_not_of(' ');
  if (begin == raw.npos || raw.compare(begin, 2, "//") != 0) return line;
  const std::string columns = in_columns(raw);
  line.width = columns.size();
  begin = std::min(columns.find_first_not_of("/!<", begin), columns.size());
  line.text = columns.substr(begin);
  line.indent = line.text.find_first_not_of(' ');
  if (line.indent == line.text.npos) return line;
  line.marker = columns.substr(0, begin);
  for (std::size_t at = line.indent; (at = line.text.find("  ", at)) != line.text.npos;) {
    const std::size_t to = line.text.find_first_not_of(' ', at);
    if (to == line.text.npos) break;
    line.gaps.emplace_back(at, to);
    at = to;
  }
  return line;
}

std::size_t end_of_word(const Line& line, std::size_t from) {
  return std::min(line.text.find(' ', from), line.text.size());
}

bool has_open_bracket(const std::string& text) {
  int open = 0;
  for (const char c : text) {
    if (c == '(' || c == '[') ++open;
    if ((c == ')' || c == ']') && open > 0) --open;
  }
  return open > 0;
}

bool ends_with_operator(const std::string& text) {
  const std::string word = text.substr(text.rfind(' ') + 1);
  return text.back() == ',' || word.find_first_not_of("+-*/=<>|&") == word.npos;
}

/// Returns whether `line`, which starts at the column of the row's label, seems to be the rest of `row`.
/// `row` is the preceding line, and is full. `after` is the line after `line`, or null.
bool is_cut_off(const Line& row, const Line& line, const Line* after) {
  if (row.gaps.empty()) {
    // In an indented paragraph, a line of prose may leave a bracket open. In code and drawings, an open
    // bracket shows that a row was cut off.
    const bool is_code = line.text.back() == ';' || line.text.back() == '{';
    return line.gaps.empty() && has_open_bracket(row.text) &&
           (is_code || row.text.find(kDrawn) != row.text.npos);
  }
  const std::size_t column = row.gaps.back().second;
  if (line.gaps.empty()) {
    if (has_open_bracket(row.text) || ends_with_operator(row.text)) return true;
    if (line.text.size() >= column) return false;
    if (after && after->indent == column) return true;
    const bool ends_table = !after || after->indent < row.indent;
    const bool is_statement = line.text.back() == ';';
    return ends_table && !is_statement &&
           std::islower(static_cast<unsigned char>(line.text[line.indent])) != 0;
  }
  // A tool may have joined the end of `row` and the next row into `line`. If so, removing the first words
  // of `line` aligns the second cells of `line` and `row`.
  const auto [gap_from, gap_to] = line.gaps.front();
  if (row.has_cell_at(gap_to)) return false;
  for (std::size_t word = line.indent; (word = end_of_word(line, word)) < gap_from;) {
    ++word;
    if (gap_to - (word - line.indent) == row.gaps.front().second) return true;
  }
  return false;
}

/// Returns whether `line` starts before the last cell of `row`, and continues below this cell. `row` is the
/// preceding line.
bool starts_in_last_gap(const Line& row, const Line& line) {
  if (row.gaps.empty() || !line.gaps.empty()) return false;
  const auto [from, to] = row.gaps.back();
  const bool is_text = std::isalnum(static_cast<unsigned char>(line.text[line.indent])) != 0;
  return is_text && from <= line.indent && line.indent < to && line.text.size() > to;
}

template <typename Check>
void each_file(const Files& files, const Check& check) {
  for (const auto& [file, content] : files) {
    std::vector<std::string> lines;
    std::istringstream stream(content);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    check(file, lines);
  }
}

}  // namespace

std::vector<std::string> long_comments(const Files& files, std::size_t limit) {
  std::vector<std::string> found;
  each_file(files, [&](const std::string& file, const std::vector<std::string>& lines) {
    for (std::size_t i = 0; i < lines.size(); ++i) {
      if (lines[i].size() <= limit) continue;
      const std::size_t columns = in_columns(lines[i]).size();
      if (columns > limit && comment_at(lines[i]) != std::string::npos)
        found.push_back(fmt::format("{}:{}: a comment line has {} columns; at most {} are allowed", file,
                                    i + 1, columns, limit));
    }
  });
  return found;
}

std::vector<std::string> broken_rows(const Files& files, std::size_t limit) {
  std::vector<std::string> found;
  each_file(files, [&](const std::string& file, const std::vector<std::string>& raw) {
    std::vector<Line> lines;
    for (const std::string& line : raw) lines.push_back(read_line(line));
    for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
      const Line &row = lines[i], &line = lines[i + 1];
      if (row.marker.empty() || row.marker != line.marker || row.indent < kLeastIndent) continue;
      const bool is_after = i + 2 < lines.size() && lines[i + 2].marker == row.marker;
      const bool is_full = row.width + 1 + end_of_word(line, line.indent) - line.indent > limit;
      const bool is_broken = line.indent == row.indent
                                 ? is_full && is_cut_off(row, line, is_after ? &lines[i + 2] : nullptr)
                                 : starts_in_last_gap(row, line);
      if (!is_broken) continue;
      const std::size_t marker = row.marker.size() + 1,
                        column = row.gaps.empty() ? 0 : row.gaps.back().second;
      found.push_back(fmt::format(
          "{}:{}: the rest of a row starts at column {}: expected {}", file, i + 2, marker + line.indent,
          column == 0 ? "an indented line"
                      : fmt::format("column {}, below the row's last cell", marker + column)));
    }
  });
  return found;
}

}  // namespace robosim::structure
