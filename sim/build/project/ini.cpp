#include "sim/build/project/ini.h"

#include <algorithm>
#include <cctype>
#include <sstream>

#include "sim/base/error.h"
#include "sim/base/file.h"
#include "sim/base/utf8.h"
#include "sim/build/project/files.h"

namespace robosim::project {
namespace {

constexpr const char* kBlanks = " \t\r\n";

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

/// Removes a comment, which starts the line or follows a blank.
std::string without_comment(const std::string& line) {
  for (std::size_t i = 0; i < line.size(); ++i)
    if ((line[i] == ';' || line[i] == '#') && (i == 0 || line[i - 1] == ' ' || line[i - 1] == '\t'))
      return line.substr(0, i);
  return line;
}

}  // namespace

IniFile::IniFile(const std::filesystem::path& path) {
  const std::string content = read_file(path, kMostProjectFile_bytes);
  std::istringstream lines{std::string(without_byte_order_mark(content))};
  std::string section;
  IniValue* open = nullptr;
  int number = 0;
  for (std::string raw; std::getline(lines, raw);) {
    ++number;
    const std::string line = without_comment(raw);
    const std::string text = trimmed(line);
    if (text.empty()) continue;
    if (open && (line[0] == ' ' || line[0] == '\t')) {
      open->text += (open->text.empty() ? "" : "\n") + text;
      continue;
    }
    open = nullptr;
    const auto refuse = [&](const std::string& what) {
      throw InputError({path.string(), number},
                       what + ": expected [SECTION] or KEY = VALUE, got “" + text + "”");
    };
    if (text[0] == '[') {
      if (text.back() != ']') refuse("a section without ] at its end");
      section = trimmed(text.substr(1, text.size() - 2));
      if (!has(section)) order_.push_back(section);
      values_[section];
      continue;
    }
    const std::size_t at = text.find_first_of("=:");
    if (at == std::string::npos) refuse("a line without =");
    if (section.empty()) refuse("a line before the first section");
    std::string key = trimmed(text.substr(0, at));
    std::transform(key.begin(), key.end(), key.begin(), [](unsigned char c) { return std::tolower(c); });
    open = &values_[section][key];
    *open = {trimmed(text.substr(at + 1)), number};
  }
}

const IniValue* IniFile::find(const std::string& section, const std::string& key) const {
  const auto in = values_.find(section);
  if (in == values_.end()) return nullptr;
  const auto value = in->second.find(key);
  return value == in->second.end() ? nullptr : &value->second;
}

}  // namespace robosim::project
