#include "sim/base/config_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace robosim {
namespace {

using Kind = ConfigValue::Kind;

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\')
      out += {'\\', c};
    else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F)
      out += fmt::format("\\u{:04X}", static_cast<unsigned>(c));
    else
      out += c;
  }
  return out + '"';
}

std::string key_text(const std::string& key) {
  const auto is_bare = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  };
  return !key.empty() && std::all_of(key.begin(), key.end(), is_bare) ? key : quoted(key);
}

std::string value_text(const ConfigValue& value) {
  std::string list;
  const auto add = [&](const std::string& item) { list += (list.empty() ? "" : ", ") + item; };
  switch (value.kind) {
    case Kind::boolean:
      return value.boolean ? "true" : "false";
    case Kind::integer:
      return std::to_string(value.integer);
    case Kind::number: {
      const std::string text = fmt::format("{}", value.number);
      return text.find_first_not_of("-0123456789") == text.npos ? text + ".0" : text;
    }
    case Kind::string:
      return quoted(value.string);
    case Kind::array:
      for (const ConfigValue& item : value.items) add(value_text(item));
      return "[" + list + "]";
    case Kind::table:
      for (const auto& [key, item] : value.members) add(key_text(key) + " = " + value_text(item));
      return list.empty() ? "{}" : "{ " + list + " }";
  }
  return {};
}

bool is_tables(const ConfigValue& value) {
  return value.kind == Kind::array && !value.items.empty() && value.items.front().kind == Kind::table;
}

class Writer {
 public:
  explicit Writer(const std::string& file) : file_(file) {}

  void key(const std::string& key, const ConfigValue& value) {
    const std::string line = key_text(key) + " = " + value_text(value);
    if (value.place.file == file_)
      text += line + '\n';
    else
      text += fmt::format("{:<{}}  # {}:{}\n", line, kColumn,
                          std::filesystem::path(value.place.file).filename().string(), value.place.line);
  }
  void keys(const ConfigValue& table) {
    for (const auto& [name, value] : table.members) key(name, value);
  }
  std::string text;

 private:
  static constexpr int kColumn = 56;  // column of comments

  const std::string& file_;
};

}  // namespace

std::string to_toml(const ConfigValue& tree, const std::string& file) {
  Writer out(file);
  for (const auto& [key, value] : tree.members)
    if (value.kind != Kind::table && !is_tables(value)) out.key(key, value);
  for (const auto& [key, value] : tree.members)
    if (value.kind == Kind::table) {
      out.text += fmt::format("\n[{}]\n", key_text(key));
      out.keys(value);
    }
  for (const auto& [key, value] : tree.members) {
    if (!is_tables(value)) continue;
    for (const ConfigValue& table : value.items) {
      out.text += fmt::format("\n[[{}]]\n", key_text(key));
      out.keys(table);
    }
  }
  return std::move(out.text);
}

}  // namespace robosim
