// Reads YAML files of other tools with libyaml. Values are read from libyaml's document, without a
// conversion. A file whose aliases would expand to a million values therefore costs nothing.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace robosim::project {

class YamlFile;

/// A value of a file, valid as long as the YamlFile exists. A missing value has no text, no members and no
/// items.
class YamlValue {
 public:
  bool is_there() const { return node_ != nullptr; }
  int line() const;  ///< counted from 1; 0 = missing
  /// Returns the text of a scalar; empty for anything else.
  std::string text() const;
  /// Returns a member of a mapping.
  YamlValue operator[](const std::string& key) const;
  std::vector<std::pair<std::string, YamlValue>> members() const;
  /// Returns the items of a list.
  std::vector<YamlValue> items() const;

 private:
  friend YamlFile;
  YamlValue(const YamlFile* file, const void* node) : file_(file), node_(node) {}
  const YamlFile* file_;
  const void* node_;
};

class YamlFile {
 public:
  /// Reads a file. Throws InputError for invalid YAML, with the line.
  explicit YamlFile(const std::filesystem::path& path);
  ~YamlFile();
  YamlFile(const YamlFile&) = delete;
  YamlFile& operator=(const YamlFile&) = delete;
  YamlValue root() const;

 private:
  friend YamlValue;
  struct Document;
  std::unique_ptr<Document> document_;
};

}  // namespace robosim::project
