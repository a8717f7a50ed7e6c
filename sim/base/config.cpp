#include "sim/base/config.h"

#define TOML_EXCEPTIONS 0
#define TOML_ENABLE_FORMATTERS 0
#include <fmt/format.h>
#if __has_include(<toml++/impl/preprocessor.hpp>)
#include <toml++/impl/preprocessor.hpp>  // 3.4
#else
#include <toml++/impl/preprocessor.h>
#endif
// toml++ 3.3 asserts that a table header's first character begins a key, and two lines later answers the
// opposite with an error. The assertion would abort where assertions are on, and be undefined behaviour in
// clang's releases.
#undef TOML_ASSERT_ASSUME
#define TOML_ASSERT_ASSUME(expr) static_assert(true)
#include <toml++/toml.h>

#include <algorithm>

namespace robosim {
namespace {

struct Origin {
  const std::string& file;
  int line_offset;

  Place at(const toml::source_position& p) const {
    return {file, static_cast<int>(p.line) + line_offset, static_cast<int>(p.column)};
  }
};

ConfigValue convert(const toml::node& node, const Origin& origin);

ConfigValue convert_table(const toml::table& table, const Origin& origin) {
  ConfigValue value;
  value.kind = ConfigValue::Kind::table;
  struct Member {
    toml::source_position position;
    std::string key;
    ConfigValue value;
  };
  std::vector<Member> members;
  for (auto&& [key, node] : table)
    members.push_back({key.source().begin, std::string(key.str()), convert(node, origin)});
  std::stable_sort(members.begin(), members.end(), [](const Member& a, const Member& b) {
    return std::pair(a.position.line, a.position.column) < std::pair(b.position.line, b.position.column);
  });
  for (Member& member : members) value.members.emplace_back(std::move(member.key), std::move(member.value));
  return value;
}

ConfigValue convert(const toml::node& node, const Origin& origin) {
  ConfigValue value;
  const Place place = origin.at(node.source().begin);
  if (const auto* table = node.as_table()) {
    value = convert_table(*table, origin);
  } else if (const auto* array = node.as_array()) {
    value.kind = ConfigValue::Kind::array;
    for (const toml::node& item : *array) value.items.push_back(convert(item, origin));
  } else if (const auto* string = node.as_string()) {
    value.kind = ConfigValue::Kind::string;
    value.string = string->get();
  } else if (const auto* integer = node.as_integer()) {
    value.kind = ConfigValue::Kind::integer;
    value.integer = integer->get();
    value.number = static_cast<double>(value.integer);
  } else if (const auto* number = node.as_floating_point()) {
    value.kind = ConfigValue::Kind::number;
    value.number = number->get();
  } else if (const auto* boolean = node.as_boolean()) {
    value.kind = ConfigValue::Kind::boolean;
    value.boolean = boolean->get();
  } else {
    throw InputError(place,
                     "dates and times have no meaning here; allowed are strings, numbers, true and false");
  }
  value.place = place;
  return value;
}

[[noreturn]] void wrong_kind(const ConfigValue& value, const char* key, const std::string& wanted) {
  throw InputError(value.place, fmt::format("{} is {}; it must be {}", key, to_string(value.kind), wanted));
}

std::string bounds(double least, double most) { return fmt::format("from {:g} to {:g}", least, most); }

// Where the first character beyond ASCII stands outside strings and comments, if any. No such character is
// TOML, and toml++ 3.3 does not survive some of them (U+FB26 to U+FEFE run into its "unreachable" code).
std::size_t find_stray_character(std::string_view text) {
  std::size_t i = text.starts_with("\xEF\xBB\xBF") ? 3 : 0;  // a byte order mark is allowed
  while (i < text.size()) {
    const char c = text[i];
    if (static_cast<unsigned char>(c) >= 0x80) return i;
    if (c == '#') {
      i = std::min(text.find('\n', i), text.size());
    } else if (c == '"' || c == '\'') {
      const std::string_view three = c == '"' ? "\"\"\"" : "\'\'\'";
      const bool lines = text.substr(i).starts_with(three);
      i += lines ? 3 : 1;
      while (i < text.size() &&
             (lines ? !text.substr(i).starts_with(three) : text[i] != c && text[i] != '\n'))
        i += c == '"' && text[i] == '\\' ? 2 : 1;
      i = std::min(i + (lines ? 3 : 1), text.size());
      for (int more = 0; lines && more < 2 && i < text.size() && text[i] == c; ++more) ++i;  // """a"""" is a"
    } else {
      ++i;
    }
  }
  return std::string_view::npos;
}

void refuse_stray_character(std::string_view text, const std::string& file, int first_line) {
  const std::size_t stray = find_stray_character(text);
  if (stray == std::string_view::npos) return;
  const std::string_view before = text.substr(0, stray);
  const auto line = std::count(before.begin(), before.end(), '\n');
  const std::size_t line_begin = before.rfind('\n') + 1;  // 0 on the first line
  throw InputError({file, first_line + static_cast<int>(line), static_cast<int>(stray - line_begin) + 1},
                   "not valid TOML: outside quotes and comments only ASCII characters are allowed");
}

}  // namespace

const ConfigValue* ConfigValue::find(std::string_view key) const {
  for (const auto& [name, value] : members)
    if (name == key) return &value;
  return nullptr;
}

const char* to_string(ConfigValue::Kind kind) {
  switch (kind) {
    case ConfigValue::Kind::boolean:
      return "true or false";
    case ConfigValue::Kind::integer:
      return "a whole number";
    case ConfigValue::Kind::number:
      return "a number";
    case ConfigValue::Kind::string:
      return "a string";
    case ConfigValue::Kind::array:
      return "an array";
    case ConfigValue::Kind::table:
      return "a table";
  }
  return "";
}

ConfigValue parse_toml(std::string_view text, const std::string& file, int first_line) {
  refuse_stray_character(text, file, first_line);
  const Origin origin{file, first_line - 1};
  const toml::parse_result result = toml::parse(text, file);
  if (!result) {
    const toml::parse_error& error = result.error();
    throw InputError(origin.at(error.source().begin), "not valid TOML: " + std::string(error.description()));
  }
  ConfigValue value = convert_table(result.table(), origin);
  value.place = {file, first_line, 1};
  return value;
}

const std::string& as_string(const ConfigValue& value, const char* key) {
  if (value.kind != ConfigValue::Kind::string) wrong_kind(value, key, "a string");
  return value.string;
}

bool as_boolean(const ConfigValue& value, const char* key) {
  if (value.kind != ConfigValue::Kind::boolean) wrong_kind(value, key, "true or false");
  return value.boolean;
}

std::int64_t as_integer(const ConfigValue& value, const char* key, std::int64_t least, std::int64_t most) {
  if (value.kind != ConfigValue::Kind::integer) wrong_kind(value, key, "a whole number");
  if (value.integer < least || value.integer > most)
    throw InputError(value.place,
                     fmt::format("{} is {}; it must be from {} to {}", key, value.integer, least, most));
  return value.integer;
}

double as_quantity(const ConfigValue& value, const char* key, Dimension dimension, double least,
                   double most) {
  double si = value.number;
  const bool bare = value.kind == ConfigValue::Kind::integer || value.kind == ConfigValue::Kind::number;
  if (value.kind == ConfigValue::Kind::string) {
    const auto parsed = parse_quantity(value.string, dimension);
    if (!parsed)
      throw InputError(value.place, fmt::format("{} is \"{}\"; it must be a number with a unit: {}", key,
                                                value.string, unit_names(dimension)));
    si = *parsed;
  } else if (!bare) {
    wrong_kind(value, key, "a quantity such as \"20 mm\"");
  } else if (dimension != Dimension::ratio) {
    throw InputError(value.place,
                     fmt::format("{} is {:g} without a unit; write it as a string with one of {}", key, si,
                                 unit_names(dimension)));
  }
  if (!(si >= least && si <= most))
    throw InputError(value.place,
                     fmt::format("{} is {:g} in SI units; it must be {}", key, si, bounds(least, most)));
  return si;
}

TableReader::TableReader(const ConfigValue& table, std::string what) : table_(table), what_(std::move(what)) {
  if (table.kind != ConfigValue::Kind::table) wrong_kind(table, what_.c_str(), "a table");
}

const ConfigValue* TableReader::find(const char* key) {
  known_.emplace_back(key);
  return table_.find(key);
}

const ConfigValue& TableReader::require(const char* key) {
  if (const ConfigValue* value = find(key)) return *value;
  throw InputError(table_.place, fmt::format("{} lacks the key {}", what_, key));
}

std::string TableReader::string(const char* key, std::string fallback) {
  const ConfigValue* value = find(key);
  return value ? as_string(*value, key) : fallback;
}

bool TableReader::boolean(const char* key, bool fallback) {
  const ConfigValue* value = find(key);
  return value ? as_boolean(*value, key) : fallback;
}

std::int64_t TableReader::integer(const char* key, std::int64_t fallback, std::int64_t least,
                                  std::int64_t most) {
  const ConfigValue* value = find(key);
  return value ? as_integer(*value, key, least, most) : fallback;
}

double TableReader::quantity(const char* key, Dimension dimension, double fallback, double least,
                             double most) {
  const ConfigValue* value = find(key);
  return value ? as_quantity(*value, key, dimension, least, most) : fallback;
}

std::string TableReader::choice(const char* key, std::string fallback,
                                const std::vector<std::string>& allowed) {
  const ConfigValue* value = find(key);
  if (!value) return fallback;
  const std::string& chosen = as_string(*value, key);
  if (std::find(allowed.begin(), allowed.end(), chosen) == allowed.end())
    throw InputError(value->place, fmt::format("{} is \"{}\"; allowed are {}", key, chosen, one_of(allowed)));
  return chosen;
}

void TableReader::finish() const {
  for (const auto& [key, value] : table_.members) {
    if (std::find(known_.begin(), known_.end(), key) != known_.end()) continue;
    throw InputError(value.place,
                     fmt::format("unknown key {} in {}; known are {}", key, what_, one_of(known_)));
  }
}

}  // namespace robosim
