#include "sim/build/prototypes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include "sim/base/file.h"
#include "sim/build/lexing.h"
#include "sim/build/messages.h"
#include "sim/build/process.h"
#include "sim/build/source.h"
#include "sim/build/tokens.h"
#include "sim/build/toolchain.h"

namespace robosim::build {
namespace fs = std::filesystem;

namespace {

/// The largest distance, in characters, from the beginning of a function's line to the end of its parameters.
/// Without this limit, the search for one function could read the whole text of a large sketch.
constexpr std::size_t kLongestList = 64 * 1024;

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (;;) {
    const std::size_t at = text.find(separator);
    parts.push_back(text.substr(0, at));
    if (at == std::string_view::npos) return parts;
    text.remove_prefix(at + 1);
  }
}

int to_int(std::string_view text) {
  int value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

// Reads a line marker, and removes the escapes of the file name.
bool parse_marker(std::string_view line, int& number, std::string& file) {
  const auto marker = line_marker(line);
  if (!marker) return false;
  number = marker->line;
  file.clear();
  for (std::size_t i = 0; i < marker->file.size(); ++i) {
    if (marker->file[i] == '\\' && i + 1 < marker->file.size()) ++i;
    file += marker->file[i];
  }
  return true;
}

// Removes `using`, which ctags includes in a function's type after `using namespace std;`.
std::string without_using(std::string type) {
  constexpr std::string_view kUsing = "using ";
  return type.starts_with(kUsing) ? type.substr(kUsing.size()) : type;
}

// Blanks the default arguments of the parameter list that begins at `open`, and returns the original list.
// Returns an empty text if the list does not end within kLongestList.
std::string take_defaults(std::string& source, std::size_t open) {
  int depth = 0;
  std::size_t default_at = 0;
  std::vector<std::pair<std::size_t, std::size_t>> defaults;
  for (CodeScanner scan(source, open); !scan.done() && scan.at() - open < kLongestList; scan.step()) {
    const char c = scan.peek();
    if (c == '(' || c == '[' || c == '{') ++depth;
    if (c == ')' || c == ']' || c == '}') --depth;
    if (c == '=' && depth == 1 && !default_at) default_at = scan.at();
    if (default_at && (depth == 0 || (c == ',' && depth == 1))) {
      defaults.emplace_back(default_at, scan.at());
      default_at = 0;
    }
    if (depth == 0) {
      std::string list = source.substr(open, scan.at() + 1 - open);
      for (const auto& [from, to] : defaults)
        for (std::size_t i = from; i < to; ++i)
          if (source[i] != '\n') source[i] = ' ';
      return list;
    }
  }
  return {};
}

std::string one_line(std::string text) {
  std::string clean;
  for (CodeScanner scan(text, 0); !scan.done();) {
    const std::size_t from = scan.at();
    scan.step();
    const std::string piece = text.substr(from, scan.at() - from);
    const bool comment = piece.size() > 1 && piece[0] == '/';
    clean += comment || piece == "\n" ? " " : piece;
  }
  return clean;
}

using LineStarts = std::map<std::pair<std::string, int>, std::size_t>;

/// Returns where each line of each .ino file begins in a source with #line directives.
LineStarts line_starts(const std::string& joined) {
  LineStarts starts;
  std::string file;
  int line = 0;
  for (std::size_t at = 0; at < joined.size();) {
    const std::size_t end = std::min(joined.find('\n', at), joined.size());
    const std::string_view text(joined.data() + at, end - at);
    if (text.substr(0, 6) != "#line " || !parse_marker(text, line, file)) starts[{file, line++}] = at;
    at = end + 1;
  }
  return starts;
}

/// Returns where the parameter list of `name` begins, at or after `from`.
std::size_t parameter_list(const std::string& source, const std::string& name, std::size_t from) {
  const auto in_word = [&](std::size_t at) {
    return at < source.size() && (std::isalnum(static_cast<unsigned char>(source[at])) || source[at] == '_');
  };
  const std::string_view near = std::string_view(source).substr(0, from + kLongestList);
  for (std::size_t at = near.find(name, from); at != near.npos; at = near.find(name, at + 1)) {
    const std::size_t open = source.find_first_not_of(" \t\n", at + name.size());
    if ((at == 0 || !in_word(at - 1)) && open != std::string::npos && source[open] == '(') return open;
  }
  return std::string::npos;
}

/// Returns the ranges of `extern "C" { ... }` blocks, from brace to brace.
std::vector<std::pair<std::size_t, std::size_t>> c_blocks(std::string source) {
  std::vector<std::pair<std::size_t, std::size_t>> blocks;
  std::size_t extern_at = std::string::npos;
  int depth = 0;
  for (CodeScanner scan(source, 0); !scan.done(); scan.step()) {
    if (source.compare(scan.at(), 6, "extern") == 0) extern_at = scan.at();
    if (scan.peek() == '{') {
      // Uses each `extern` for one brace only. Otherwise each later brace would copy all text since that
      // `extern`.
      const std::size_t from = std::exchange(extern_at, std::string::npos);
      std::string head = from == std::string::npos ? "" : source.substr(from, scan.at() - from);
      head.erase(std::remove_if(head.begin(), head.end(), [](unsigned char c) { return std::isspace(c); }),
                 head.end());
      if (depth == 0 && head == "extern\"C\"") {
        blocks.emplace_back(scan.at(), source.size());
      } else {
        ++depth;
      }
    } else if (scan.peek() == '}') {
      if (depth > 0)
        --depth;
      else if (!blocks.empty() && blocks.back().second == source.size())
        blocks.back().second = scan.at();
    }
  }
  return blocks;
}

bool inside(const std::vector<std::pair<std::size_t, std::size_t>>& ranges, std::size_t at) {
  return std::any_of(ranges.begin(), ranges.end(),
                     [&](const auto& range) { return at > range.first && at < range.second; });
}

/// Returns whether the variable's value mentions a function, as in `&blink` and `(blink)`.
bool mentions_function(const Tag& variable, const std::set<std::string>& functions) {
  const std::string& code = variable.code;
  for (std::size_t at = code.find_first_of("&("); at != std::string::npos;
       at = code.find_first_of("&(", at + 1)) {
    std::size_t end = at + 1;
    while (end < code.size() && (std::isalnum(static_cast<unsigned char>(code[end])) || code[end] == '_'))
      ++end;
    const bool is_whole = code[at] == '&' || (end < code.size() && code[end] == ')');
    if (is_whole && functions.contains(code.substr(at + 1, end - at - 1))) return true;
  }
  return false;
}

std::string template_head(const std::string& joined, std::size_t at) {
  // ctags reports the line of the name; the declaration may begin on an earlier line.
  std::size_t from = joined.rfind("template", joined.find('\n', at));
  if (from == std::string::npos) return {};
  const std::size_t end = joined.find('{', at);
  return end == std::string::npos ? std::string() : one_line(joined.substr(from, end - from));
}

}  // namespace

std::string own_lines(const std::string& preprocessed, const std::vector<std::string>& inos) {
  const std::set<std::string> wanted(inos.begin(), inos.end());
  std::string result;
  std::string file;
  bool own = false;
  for (const std::string_view line : split(preprocessed, '\n')) {
    int number = 0;
    if (parse_marker(line, number, file)) {
      own = wanted.count(file) != 0;
      if (own) result += fmt::format("#line {} {}\n", number, c_literal(file));
    } else if (own) {
      result += line;
      result += '\n';
    }
  }
  return result;
}

std::vector<Tag> parse_tags(const std::string& listing) {
  std::vector<Tag> tags;
  for (const std::string_view row : split(listing, '\n')) {
    const std::vector<std::string_view> parts = split(row, '\t');
    if (parts.size() < 4) continue;
    Tag tag;
    tag.name = parts[0];
    tag.file = fs::path(parts[1]).filename().string();
    const std::size_t code = row.find("\t/^");
    const std::size_t code_end = row.rfind("$/;\"");
    if (code == std::string_view::npos || code_end == std::string_view::npos || code_end < code) continue;
    tag.code = row.substr(code + 3, code_end - code - 3);
    for (const std::string_view part : split(row.substr(code_end + 4), '\t')) {
      const std::size_t colon = part.find(':');
      if (colon == std::string_view::npos) continue;
      const std::string_view field = part.substr(0, colon);
      const std::string value(part.substr(colon + 1));
      if (field == "kind") tag.kind = value;
      if (field == "line") tag.line = to_int(value);
      if (field == "signature") tag.signature = value;
      if (field == "returntype") tag.type = without_using(value);
      if (field == "class" || field == "struct" || field == "namespace" || field == "union")
        tag.scope = value;
    }
    tags.push_back(std::move(tag));
  }
  return tags;
}

std::string insert_prototypes(const std::string& joined, const std::string& own,
                              const std::vector<Tag>& tags) {
  std::string source = joined;
  std::string expanded = own;
  const LineStarts starts = line_starts(joined);
  const LineStarts own_starts = line_starts(own);
  const auto c_functions = c_blocks(own);
  std::set<std::string> declared;
  std::set<std::string> functions;
  for (const Tag& tag : tags) {
    if (tag.kind == "prototype") declared.insert(tag.type + tag.name + tag.signature);
    if (tag.kind == "function" && tag.scope.empty()) functions.insert(tag.name);
  }

  std::string prototypes;
  std::size_t insert_at = std::string::npos;
  std::pair<std::string, int> insert_line;
  for (const Tag& tag : tags) {
    const auto start = starts.find({tag.file, tag.line});
    const auto own_start = own_starts.find({tag.file, tag.line});
    if (start == starts.end() || own_start == own_starts.end() || !tag.scope.empty()) continue;
    const bool function = tag.kind == "function";
    if (!function && !(tag.kind == "variable" && mentions_function(tag, functions))) continue;
    if (start->second < insert_at) {
      insert_at = start->second;
      insert_line = start->first;
    }
    if (!function || tag.type.empty() || tag.code.find("(*" + tag.name) != std::string::npos) continue;
    // Detects repeated declarations by their text, like Arduino's builder.
    if (!declared.insert(tag.type + tag.name + tag.signature).second) continue;

    std::string text;
    if (tag.type.rfind("template", 0) == 0) {
      text = template_head(own, own_start->second);
      if (text.empty() || text.find('=') != std::string::npos) continue;
    } else {
      std::string parameters = tag.signature;
      if (parameters.find('=') != std::string::npos) {
        const std::size_t here = parameter_list(source, tag.name, start->second);
        const std::size_t there = parameter_list(expanded, tag.name, own_start->second);
        if (here == std::string::npos || there == std::string::npos) continue;
        parameters = one_line(take_defaults(expanded, there));
        if (parameters.empty() || take_defaults(source, here).empty()) continue;
      }
      if (tag.code.find("extern \"C\"") != std::string::npos || inside(c_functions, own_start->second))
        text += "extern \"C\" ";
      // Searches only before the name: void loop() { static int n; … } may be on one line.
      if (tag.code.substr(0, tag.code.find(tag.name)).find("static ") != std::string::npos) text += "static ";
      text += tag.type + ' ' + tag.name + parameters;
    }
    prototypes += fmt::format("#line {} {}\n{};\n", tag.line, c_literal(tag.file), text);
  }
  if (prototypes.empty()) return source;
  prototypes += fmt::format("#line {} {}\n", insert_line.second, c_literal(insert_line.first));
  return source.insert(insert_at, prototypes);
}

std::string add_prototypes(const std::string& joined, const std::string& preprocessed,
                           const std::vector<std::string>& inos, const fs::path& work) {
  const std::string own = own_lines(preprocessed, inos);
  write_file(work / "own.cpp", own);
  const CommandResult ctags =
      run_within({}, {{{find_ctags().string(), "-u", "--language-force=c++", "-f", "-", "--c++-kinds=svpf",
                        "--fields=KSTtzns", "--line-directives", "own.cpp"},
                       work,
                       {},
                       work}})[0];
  if (ctags.status != 0) check_machine("arduino-ctags", ctags.output);
  if (ctags.status != 0)
    throw CompileError(
        "arduino-ctags, which lists the sketch's functions, cannot read the sketch: expected C++, got " +
        (ctags.status > 128 ? fmt::format("signal {}", ctags.status - 128) : ctags.output));
  return insert_prototypes(joined, own, parse_tags(ctags.output));
}

}  // namespace robosim::build
