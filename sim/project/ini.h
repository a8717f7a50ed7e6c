// .ini files as Python's configparser reads them, and PlatformIO with it: sections, `key = value`, values
// that go on in indented lines, comments behind ; and #.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace robosim::project {

struct IniValue {
  std::string text;  ///< its lines without blanks around them
  int line = 0;
};

class IniFile {
 public:
  /// Throws InputError for a line that is neither.
  explicit IniFile(const std::filesystem::path& path);

  const std::vector<std::string>& sections() const { return order_; }
  bool has(const std::string& section) const { return values_.count(section) != 0; }
  /// Null if there is none.
  const IniValue* find(const std::string& section, const std::string& key) const;

 private:
  std::vector<std::string> order_;
  std::map<std::string, std::map<std::string, IniValue>> values_;
};

}  // namespace robosim::project
