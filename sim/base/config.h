// Parses TOML to a small tree, in which each value stores its place for messages. Only config.cpp includes
// the TOML library, because compiling this library requires 450 MB of memory.
#pragma once

#include <cstdint>
#include <list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sim/base/error.h"
#include "sim/base/units.h"

namespace robosim {

struct ConfigValue {
  enum class Kind { boolean, integer, number, string, array, table };

  Kind kind = Kind::table;
  bool boolean = false;
  std::int64_t integer = 0;
  double number = 0.0;  ///< also set for integers
  std::string string;
  std::vector<ConfigValue> items;  ///< items of an array
  /// Members of a table, in the file's order. Stored as a list, because clang 14 rejects a vector of pairs
  /// with an incomplete type.
  std::list<std::pair<std::string, ConfigValue>> members;
  Place place;

  /// Returns the member named `key`, or null.
  const ConfigValue* find(std::string_view key) const;
};

/// Returns the name of a kind for messages: "a string".
const char* to_string(ConfigValue::Kind kind);

/// Parses TOML. Throws InputError for invalid TOML. Also throws for more than 256 KiB, 1000 keys in a table,
/// 8 parts in a key (a.b.c has 3) or 16 nested brackets. `first_line` is the line of the file at which `text`
/// starts; front matter may start later than on line 1.
ConfigValue parse_toml(std::string_view text, const std::string& file, int first_line = 1);

/// Reads one table key by key, and rejects keys that the caller has not read.
///
///   TableReader reader(table, "[motors]");
///   const double gear = reader.quantity("gear", Dimension::ratio, 48.0);
///   reader.finish();  // throws on unknown keys, and names the known keys
class TableReader {
 public:
  /// `what` names the table in messages. Throws InputError if `table` is not a table.
  TableReader(const ConfigValue& table, std::string what);

  /// Returns the value of `key`, or null, and marks `key` as known.
  const ConfigValue* find(const char* key);
  /// Returns the value of `key`; throws InputError if the key is missing.
  const ConfigValue& require(const char* key);

  // These functions return `fallback` for a missing key, and throw InputError for a value of the wrong kind.
  std::string string(const char* key, std::string fallback);
  bool boolean(const char* key, bool fallback);
  std::int64_t integer(const char* key, std::int64_t fallback, std::int64_t least, std::int64_t most);
  /// Reads a quantity in SI units, with inclusive bounds in SI units.
  double quantity(const char* key, Dimension dimension, double fallback, double least, double most);
  /// Reads a string that is one of `allowed`.
  std::string choice(const char* key, std::string fallback, const std::vector<std::string>& allowed);

  /// Throws InputError for the first unknown key that resembles a missing known key. Call this when a
  /// required key is missing, after all keys were read: the user may have misspelt the required key.
  void refuse_misspelt() const;
  /// Throws InputError for the first key that was never read.
  void finish() const;

  const ConfigValue& table() const { return table_; }

 private:
  bool knows(const std::string& key) const;

  const ConfigValue& table_;
  std::string what_;
  std::vector<std::string> known_;
};

/// Returns the string in `value`; throws InputError, with the name `key`, for other kinds.
const std::string& as_string(const ConfigValue& value, const char* key);
/// Returns the SI value of a quantity string, or of a bare number for ratios. Throws InputError outside the
/// inclusive bounds.
double as_quantity(const ConfigValue& value, const char* key, Dimension dimension, double least, double most);

/// The unit in which a quantity is written; a bare number has no unit.
struct WrittenUnit {
  double si = 1.0;   ///< one unit, in SI units
  std::string name;  ///< "mm"; empty = none
};
WrittenUnit unit_of(const ConfigValue& value, Dimension dimension);
std::int64_t as_integer(const ConfigValue& value, const char* key, std::int64_t least, std::int64_t most);
bool as_boolean(const ConfigValue& value, const char* key);

}  // namespace robosim
