#include "sim/cli/run/source_text.h"

#include <cctype>
#include <fstream>
#include <set>

namespace robosim::cli {
namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMostConstants = 6;

bool is_of_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

std::string trimmed(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \t");
  return begin == text.npos ? "" : text.substr(begin, text.find_last_not_of(" \t\r") + 1 - begin);
}

std::string without_comment(const std::string& line) { return line.substr(0, line.find("//")); }

/// Its words that may be names, in their order.
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

/// `const int A = 1, B[] = {2};` declares A and B, `#define C 3` C; those of functions and classes do not
/// count.
std::set<std::string> constants_of(const std::string& line) {
  const std::string text = without_comment(line);  // those of functions are indented
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

}  // namespace

std::string SourceText::line(const wire::SourceLine& where) {
  const std::vector<std::string>& lines = lines_of(where.file);
  const auto number = static_cast<std::size_t>(where.line);
  return number == 0 || number > lines.size() ? "" : trimmed(lines[number - 1]);
}

wire::Cause SourceText::constants_in(const std::vector<wire::Cause>& chain) {
  wire::Cause constants{0.0, "constants in these lines", {}};
  std::set<std::string> had;
  for (const wire::Cause& cause : chain)
    for (const wire::SourceLine& where : cause.lines)
      for (const std::string& name : names_in(without_comment(line(where)))) {
        if (!had.insert(name).second || constants.lines.size() >= kMostConstants) continue;
        const std::vector<std::string>& lines = lines_of(where.file);
        for (std::size_t i = 0; i < lines.size(); ++i)
          if (static_cast<int>(i) + 1 != where.line && constants_of(lines[i]).contains(name))
            constants.lines.push_back({"", where.file, static_cast<int>(i) + 1});
      }
  return constants;
}

const std::vector<std::string>& SourceText::lines_of(const std::string& file) {
  const auto [known, fresh] = files_.try_emplace(file);
  if (!fresh) return known->second;
  for (const fs::path& path : paths_of(file)) {
    std::ifstream in(path);
    for (std::string text; std::getline(in, text);) known->second.push_back(text);
    if (!known->second.empty()) break;
  }
  return known->second;
}

// Of a library's the image knows "libraries/NAME/..." only.
std::vector<fs::path> SourceText::paths_of(const fs::path& file) const {
  std::vector<fs::path> paths;
  for (const fs::path& folder : folders_) paths.push_back(folder / file);
  if (!file.string().starts_with("libraries/")) return paths;
  const fs::path within_all = file.lexically_relative("libraries");
  fs::path within_one;
  for (auto part = std::next(within_all.begin()); part != within_all.end(); ++part) within_one /= *part;
  for (const fs::path& folder : folders_)
    paths.insert(paths.end(), {folder / within_all, folder / within_one});
  return paths;
}

}  // namespace robosim::cli
