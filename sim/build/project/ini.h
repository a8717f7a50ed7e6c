// Reads .ini files by the rules of Python's configparser, which PlatformIO uses: sections, `key = value`,
// values that continue in indented lines, comments after ; and #.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace robosim::project {

struct IniValue {
  std::string text;  ///< the value's lines without surrounding blanks
  int line = 0;
};

class IniFile {
 public:
  /// Reads a file. Throws InputError for an invalid line.
  explicit IniFile(const std::filesystem::path& path);

  const std::vector<std::string>& sections() const { return order_; }
  bool has(const std::string& section) const { return values_.count(section) != 0; }
  /// Returns the value; null if it is missing.
  const IniValue* find(const std::string& section, const std::string& key) const;

 private:
  std::vector<std::string> order_;
  std::map<std::string, std::map<std::string, IniValue>> values_;
};

}  // namespace robosim::project
