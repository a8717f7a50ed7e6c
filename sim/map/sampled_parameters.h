// Map parameters that have a spread, such as slope = { value = "15 deg", spread = "2 deg" }. A different
// value is sampled for each seed.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "sim/base/parameter.h"
#include "sim/base/vec.h"

namespace robosim::map {

/// The seed and profile for which values are sampled.
struct Draw {
  std::uint64_t seed = 0;
  Profile profile = Profile::ideal;  ///< `ideal` samples nothing and uses the file's values
  bool* differs = nullptr;           ///< set to true if another seed would give another value; may be null
};

/// Reads the parameters of one table; `table` is its name, such as "[[hill]] 2".
class SampledParameters {
 public:
  SampledParameters(Draw draw, std::string table) : draw_(draw), table_(std::move(table)) {}

  /// Returns the value sampled for the seed. `key` distinguishes the parameters of a table.
  double drawn(const Parameter& number, const std::string& key) const {
    if (draw_.profile == Profile::ideal) return number.value;
    if (draw_.differs && number.in(draw_.profile).spread != 0.0) *draw_.differs = true;
    return number.drawn(draw_.profile, NoiseStream(draw_.seed, 0, table_, key));
  }
  double read(TableReader& table, const char* key, Dimension dimension, double usual, double least,
              double most) const {
    return drawn(read_parameter(table, key, dimension, {usual, 0.0}, least, most), key);
  }
  /// Reads a value. Throws InputError if the value with its spread exceeds the bounds.
  double read(const ConfigValue& value, const char* key, Dimension dimension, double least,
              double most) const {
    return drawn(as_parameter(value, key, dimension, least, most), key);
  }
  /// Reads an array of two values.
  Vec2 read_pair(const ConfigValue& value, const char* key, Dimension dimension, double least,
                 double most) const {
    return drawn({as_parameter(value.items[0], key, dimension, least, most),
                  as_parameter(value.items[1], key, dimension, least, most)},
                 key);
  }
  Vec2 drawn(const std::array<Parameter, 2>& pair, const std::string& key) const {
    return {drawn(pair[0], key + " x"), drawn(pair[1], key + " y")};
  }

 private:
  Draw draw_;
  std::string table_;
};

}  // namespace robosim::map
