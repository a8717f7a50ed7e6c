// YAML files as other tools write them, by libyaml: looked into, never turned into something of ours, so that
// anchors that stand for each other a million times cost nothing.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace robosim::project {

class YamlFile;

/// A value of a file; lives as long as that. One that is not there has no text, no members and no items.
class YamlValue {
 public:
  bool is_there() const { return node_ != nullptr; }
  int line() const;  ///< counted from 1; 0 = not there
  /// Of a scalar; empty for anything else.
  std::string text() const;
  /// Of a mapping.
  YamlValue operator[](const std::string& key) const;
  std::vector<std::pair<std::string, YamlValue>> members() const;
  /// Of a list.
  std::vector<YamlValue> items() const;

 private:
  friend YamlFile;
  YamlValue(const YamlFile* file, const void* node) : file_(file), node_(node) {}
  const YamlFile* file_;
  const void* node_;
};

class YamlFile {
 public:
  /// Throws InputError for a file that is no YAML, with the line.
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
