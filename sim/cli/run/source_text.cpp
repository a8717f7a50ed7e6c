#include "sim/cli/run/source_text.h"

#include <algorithm>
#include <cctype>
#include <deque>
#include <regex>
#include <sstream>
#include <string_view>

#include "sim/base/error.h"
#include "sim/base/file.h"
#include "sim/build/project.h"

namespace robosim::cli {
namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMostNamed = 12, kMostWriters = 6, kMostWithoutValue = 4;
constexpr std::size_t kMostSource_bytes = std::size_t{1} << 20, kMostInAll_bytes = std::size_t{8} << 20;
/// Limits a line's length, because std::regex uses stack for each character and time for each possible match.
constexpr std::size_t kLongestLine = 300;

std::string content_or_nothing(const fs::path& path) {
  try {
    return read_file(path, kMostSource_bytes);
  } catch (const InputError&) {
    return "";
  }
}

bool matches(const std::string& line, std::smatch& parts, const std::regex& pattern) {
  return line.size() <= kLongestLine && std::regex_match(line, parts, pattern);
}
bool matches(const std::string& line, const std::regex& pattern) {
  std::smatch parts;
  return matches(line, parts, pattern);
}

bool is_of_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

std::string trimmed(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \t");
  return begin == text.npos ? "" : text.substr(begin, text.find_last_not_of(" \t\r") + 1 - begin);
}

std::string without_comment(const std::string& line) { return line.substr(0, line.find("//")); }

/// Returns the words of a line that may be names, in order.
std::vector<std::string> names_in(const std::string& line) {
  std::vector<std::string> names;
  for (std::size_t at = 0; at < line.size();) {
    std::size_t end = at;
    while (end < line.size() && is_of_word(line[end])) ++end;
    if (end > at && !std::isdigit(static_cast<unsigned char>(line[at])))
      names.push_back(line.substr(at, end - at));
    at = end == at ? at + 1 : end;
  }
  return names;
}

bool names(const std::string& line, const std::string& name) {
  const std::vector<std::string> all = names_in(line);
  return std::find(all.begin(), all.end(), name) != all.end();
}

/// Returns the constants of a line: `const int A = 1, B[] = {2};` declares A and B; `#define C 3` declares C.
/// Skips indented constants, which belong to functions and classes.
std::set<std::string> constants_of(const std::string& text) {
  const std::vector<std::string> names = names_in(text);
  if (text.starts_with("#define") && names.size() > 1) return {names[1]};
  std::set<std::string> constants;
  if (!text.starts_with("const") && !text.starts_with("static const")) return constants;
  for (std::size_t equals = text.find('='); equals != text.npos; equals = text.find('=', equals + 1)) {
    std::size_t end = text.find_last_not_of(" \t", equals == 0 ? 0 : equals - 1);
    if (end != text.npos && text[end] == ']') end = text.rfind('[', end) - 1;
    if (end == text.npos || !is_of_word(text[end])) continue;
    std::size_t begin = end;
    while (begin > 0 && is_of_word(text[begin - 1])) --begin;
    constants.insert(text.substr(begin, end + 1 - begin));
  }
  return constants;
}

/// Returns the object that a line declares: `Servo arm(9);` declares arm; `int turn(int by);` is a function.
std::optional<std::string> object_of(const std::string& text) {
  static const std::regex object(
      R"((?:[A-Za-z_][\w:]*(?:<(?:[^;()<>]|<[^;()<>]*>)*>)?\s+)+(\w+)\s*[({](.+)[)}]\s*;\s*)");
  static const std::regex parameter(R"((?:^|[(,])\s*(?:\w+\s+)*\w[\w:<>]*[\s*&]+\w+\s*(?:=[^,]*)?(?=,|$))");
  std::smatch parts;
  if (!matches(text, parts, object) || text.starts_with("return") || text.starts_with("extern"))
    return std::nullopt;
  const std::string between = parts[2];
  if (std::regex_search(between, parameter)) return std::nullopt;
  return parts[1];
}

/// Returns the variables that a line declares without a value: `int a, b;` in a function declares two.
std::set<std::string> without_value(const std::string& line) {
  static const std::regex declaration(
      R"(\s+(?:volatile\s+)?(?:(?:unsigned|signed|long|short)\s+)*(?:u?int\d+_t|int|long|short|unsigned|char|bool|boolean|byte|word|float|double|size_t)\s+(\w+(?:\s*,\s*\w+)*)\s*;\s*)");
  std::smatch parts;
  if (!matches(line, parts, declaration)) return {};
  const std::vector<std::string> names = names_in(parts[1]);
  return {names.begin(), names.end()};
}

bool opens_function(const std::string& line) {
  static const std::regex function(R"(.*\)[^;()]*\{\s*)"),
      statement(R"(\s*\}?\s*(?:if|else|for|while|switch|do)\b.*)");
  return matches(line, function) && !matches(line, statement);
}

/// Returns whether a line writes a variable: `count = 1`, `count += 1`, `count++` and `++count`.
bool writes(const std::string& line, const std::string& name) {
  if (line.size() > kLongestLine || line.find(name) == line.npos) return false;
  return std::regex_search(
      line, std::regex("(?:^|\\W)" + name + R"((?:\s*\[[^\]]*\])?\s*(?:[-+*/%&|^]|<<|>>)?=(?!=)|\b)" + name +
                       R"(\s*(?:\+\+|--)|(?:\+\+|--)\s*)" + name + "\\b"));
}

/// Finds the first of these lines that names the variable. Returns whether this line only assigns a value to
/// the variable: `sum = 0;` and `read(&sum);`, but not `sum += 1;`.
bool assigns_first(const std::vector<std::string>& lines, std::size_t begin, std::size_t end,
                   const std::string& name) {
  for (std::size_t i = begin; i < std::min(end, lines.size()); ++i) {
    const std::string text = without_comment(lines[i]);
    if (!names(text, name)) continue;
    if (text.size() > kLongestLine) return false;
    const std::size_t at = text.find('=');
    return std::regex_search(
               text, std::regex("&\\s*" + name + "\\b|\\b" + name + R"((\s*\[[^\]]*\])?\s*=(?!=))")) &&
           (at == text.npos || !names(text.substr(at), name));
  }
  return false;
}

/// Returns the function that contains the line `at`, counted from 0; empty if unknown.
std::string function_at(const std::vector<std::string>& lines, std::size_t at) {
  static const std::regex head(R"((?:[A-Za-z_][\w:<>]*[\s*&]+)*([A-Za-z_]\w*)\s*\(.*\{.*)");
  for (std::size_t i = at + 1; i-- > 0;) {
    const std::string line = without_comment(lines[i]);
    if (line.empty() || std::isspace(static_cast<unsigned char>(line[0]))) continue;
    std::smatch parts;
    return matches(line, parts, head) ? parts[1].str() : "";
  }
  return "";
}

}  // namespace

std::string SourceText::line(const result::SourceLine& where) {
  const std::vector<std::string>& lines = lines_of(where.file);
  const auto number = static_cast<std::size_t>(where.line);
  return number == 0 || number > lines.size() ? "" : trimmed(lines[number - 1]);
}

std::string SourceText::declaration(const result::SourceLine& where) {
  std::string text = trimmed(without_comment(line(where)));
  constexpr std::string_view kDefine = "#define ";
  if (text.starts_with(kDefine)) text = trimmed(text.substr(kDefine.size()));
  if (text.ends_with(';')) text.pop_back();
  return text;
}

bool SourceText::says_nothing(const result::SourceLine& where) {
  const std::string text = line(where);
  return !text.empty() &&
         (text.find_first_not_of("{}; ") == text.npos || opens_function(without_comment(text)));
}

void SourceText::explain(std::vector<result::Cause>& chain) {
  had_.clear();
  std::deque<result::SourceLine> lines;
  for (result::Cause& cause : chain) {
    if (cause.lines.empty()) continue;
    const auto behind_the_first = std::next(cause.lines.begin());
    cause.lines.erase(std::remove_if(behind_the_first, cause.lines.end(),
                                     [&](const result::SourceLine& where) { return says_nothing(where); }),
                      cause.lines.end());
    for (const result::SourceLine& where : cause.lines)
      if (had_.insert({where.file, where.line}).second) lines.push_back(where);
  }
  std::vector<result::Cause> more = {writers_in(lines), without_value_in(lines), named_in(lines)};
  for (result::Cause& cause : more)
    if (!cause.lines.empty()) chain.push_back(std::move(cause));
}

void SourceText::add(result::Cause& cause, const result::SourceLine& where, std::size_t most) {
  if (cause.lines.size() < most && had_.insert({where.file, where.line}).second) cause.lines.push_back(where);
}

/// Returns the interrupt handlers that write the `volatile` variables in these lines, and the lines that
/// install these handlers.
result::Cause SourceText::writers_in(const std::deque<result::SourceLine>& chain) {
  result::Cause writers{0.0, "an interrupt handler writes", {}};
  std::set<std::string> done;
  for (const result::SourceLine& where : chain)
    for (const std::string& name : names_in(without_comment(line(where)))) {
      const std::vector<std::string>& lines = lines_of(where.file);
      const auto declares = [&](const std::string& text) {
        return text.starts_with("volatile") && names(text, name);
      };
      if (!done.insert(where.file + '/' + name).second || std::none_of(lines.begin(), lines.end(), declares))
        continue;
      const std::size_t before = writers.lines.size();
      for (std::size_t i = 0; i < lines.size(); ++i)
        if (!declares(lines[i]) && writes(without_comment(lines[i]), name))
          add_handler(writers, where.file, i, function_at(lines, i));
      if (writers.lines.size() > before) writers.text += (before > 0 ? ", " : " ") + name;
    }
  return writers;
}

void SourceText::add_handler(result::Cause& writers, const std::string& file, std::size_t at,
                             const std::string& function) {
  const std::vector<std::string>& lines = lines_of(file);
  std::vector<int> attached;
  for (std::size_t k = 0; k < lines.size(); ++k)
    if (names(lines[k], "attachInterrupt") && names(without_comment(lines[k]), function))
      attached.push_back(static_cast<int>(k) + 1);
  if (attached.empty() && function != "ISR") return;
  add(writers, {function, file, static_cast<int>(at) + 1}, kMostWriters);
  for (const int number : attached) add(writers, {"", file, number}, kMostWriters);
}

result::Cause SourceText::without_value_in(const std::deque<result::SourceLine>& chain) {
  result::Cause found{0.0, "declared without a value", {}};
  for (const result::SourceLine& where : chain) {
    const std::vector<std::string>& lines = lines_of(where.file);
    const std::vector<std::string> used = names_in(without_comment(line(where)));
    for (auto i = static_cast<std::size_t>(where.line) - 1; i-- > 0 && i < lines.size();) {
      const std::string text = without_comment(lines[i]);
      const std::set<std::string> declared = without_value(text);
      if (std::any_of(used.begin(), used.end(), [&](const std::string& name) {
            return declared.contains(name) &&
                   !assigns_first(lines, i + 1, static_cast<std::size_t>(where.line), name);
          }))
        add(found, {"", where.file, static_cast<int>(i) + 1}, kMostWithoutValue);
      if (opens_function(text) || (!text.empty() && text[0] == '}')) break;
    }
  }
  return found;
}

result::Cause SourceText::named_in(std::deque<result::SourceLine> chain) {
  result::Cause named{0.0, kNamed, {}};
  for (; !chain.empty(); chain.pop_front()) {
    const result::SourceLine where = chain.front();
    const std::vector<std::string> used = names_in(without_comment(line(where)));
    for (const std::string& name : used) {
      const std::string file = file_that_declares(name, where.file);
      const auto& declared = declarations_in(file);
      for (auto [at, end] = declared.equal_range(name); at != end; ++at) {
        const std::size_t before = named.lines.size();
        add(named, {"", file, at->second}, kMostNamed);
        if (named.lines.size() > before) chain.push_back(named.lines.back());
      }
    }
  }
  return named;
}

/// Returns the file that declares a name: `file` itself, or the only file in its folder that declares it.
/// Returns `file` if there is no such file, or more than one.
std::string SourceText::file_that_declares(const std::string& name, const std::string& file) {
  if (declarations_in(file).contains(name)) return file;
  std::string found = file;
  for (const std::string& other : beside(file))
    if (declarations_in(other).contains(name)) {
      if (found != file) return file;
      found = other;
    }
  return found;
}

const std::vector<std::string>& SourceText::beside(const std::string& file) {
  const std::string folder = fs::path(file).parent_path().string();
  const auto [known, fresh] = beside_.try_emplace(folder);
  if (!fresh) return known->second;
  for (const fs::path& path : paths_of(file)) {
    std::error_code none;
    if (!fs::exists(path, none)) continue;
    for (const fs::directory_entry& entry : fs::directory_iterator(path.parent_path(), none))
      if (const std::string end = entry.path().extension(); end == ".h" || end == ".hpp" || end == ".ino")
        known->second.push_back((fs::path(folder) / entry.path().filename()).string());
    break;
  }
  std::sort(known->second.begin(), known->second.end());
  return known->second;
}

const std::multimap<std::string, int>& SourceText::declarations_in(const std::string& file) {
  const auto [known, fresh] = declarations_.try_emplace(file);
  if (!fresh) return known->second;
  const std::vector<std::string>& lines = lines_of(file);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string text = without_comment(lines[i]);
    if (trimmed(text).starts_with("static const"))
      for (const std::string& name : constants_of(trimmed(text)))
        known->second.emplace(name, static_cast<int>(i) + 1);
    if (text.empty() || std::isspace(static_cast<unsigned char>(text[0]))) continue;
    for (const std::string& name : constants_of(text)) known->second.emplace(name, static_cast<int>(i) + 1);
    if (const auto object = object_of(text)) known->second.emplace(*object, static_cast<int>(i) + 1);
  }
  return known->second;
}

SourceText::SourceText(fs::path sketch, std::vector<fs::path> folders, bool trusted)
    : folders_(std::move(folders)), trusted_(trusted) {
  std::error_code none;
  const fs::path real = fs::canonical(sketch, none);
  folders_.insert(folders_.begin(), std::move(sketch));
  // A library's example uses the library that contains it: LIBRARY/examples/SKETCH.
  if (trusted && real.parent_path().filename() == "examples")
    folders_.push_back(real.parent_path().parent_path());
}

const std::vector<std::string>& SourceText::lines_of(const std::string& file) {
  const auto [known, fresh] = files_.try_emplace(file);
  if (!fresh) return known->second;
  for (const fs::path& path : paths_of(file)) {
    const std::string content = read_bytes_ < kMostInAll_bytes ? content_or_nothing(path) : "";
    read_bytes_ += content.size();
    std::istringstream in(content);
    for (std::string text; std::getline(in, text);) known->second.push_back(text);
    if (!known->second.empty()) break;
  }
  return known->second;
}

// Skips missing files. A sketch can claim any file name with #line. Therefore also skips files outside of the
// area that build::reach_of() permits, even if a link leads to them. The area of an untrusted sketch is its
// folder. Of a library's path, the image contains only "libraries/NAME/...".
std::vector<fs::path> SourceText::paths_of(const fs::path& file) const {
  std::vector<fs::path> paths;
  if (file.is_absolute() || std::find(file.begin(), file.end(), "..") != file.end()) return paths;
  const auto add = [&](const fs::path& folder, const fs::path& within) {
    std::error_code none;
    const fs::path real = fs::canonical(folder, none);
    const bool is_narrow = !trusted_ && folder == folders_.front();
    if (!none && build::lies_in(folder / within, is_narrow ? real : build::reach_of(real)))
      paths.push_back(folder / within);
  };
  for (const fs::path& folder : folders_) add(folder, file);
  if (!file.string().starts_with("libraries/")) return paths;
  const fs::path within_all = file.lexically_relative("libraries");
  fs::path within_one;
  for (auto part = std::next(within_all.begin()); part != within_all.end(); ++part) within_one /= *part;
  for (const fs::path& folder : folders_) {
    add(folder, within_all);
    add(folder, within_one);
  }
  if (*within_all.begin() == "LineKit") add(data_folder() / "firmware", within_one);
  return paths;
}

}  // namespace robosim::cli
