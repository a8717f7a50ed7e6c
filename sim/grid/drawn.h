// Figures of a map with a spread, as in slope = { value = "15 deg", spread = "2 deg" }: each seed has its
// own.
#pragma once

#include <cstdint>
#include <string>

#include "sim/base/figure.h"

namespace robosim::grid {

/// Who draws them.
struct Draw {
  std::uint64_t seed = 0;
  Profile profile = Profile::ideal;  ///< which draws nothing: the map is exactly its file
};

/// The figures of one table, which `table` names: "[[hill]] 2".
class Figures {
 public:
  Figures(Draw draw, std::string table) : draw_(draw), table_(std::move(table)) {}

  /// What the seed makes of it. `key` tells it from the table's others.
  double drawn(const Number& number, const std::string& key) const {
    if (draw_.profile == Profile::ideal) return number.value;
    return number.drawn(draw_.profile, NoiseStream(draw_.seed, 0, table_, key));
  }
  /// Throws InputError if its whole range is not within the bounds.
  double read(const ConfigValue& value, const char* key, Dimension dimension, double least,
              double most) const {
    return drawn(as_figure(value, key, dimension, least, most), key);
  }

 private:
  Draw draw_;
  std::string table_;
};

}  // namespace robosim::grid
