// One of the robots that a robot file with spreads describes.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sim/worlds/random_source.h"

namespace robosim::worlds {

/// A parameter that varies between robots.
struct Figure {
  std::string table;  ///< "chassis"; or "part S"
  std::string key;    ///< "track"; or "at 0", "at 1": the first and second item of `at`
  double value = 0.0;
  double spread = 0.0;  ///< in the same unit
  std::string unit;     ///< "mm"; "" = none
};

/// Returns the parameters of a robot file with a spread, in its order. Adds the places of its floor sensors,
/// plus or minus `mounting_mm`. Skips values or spreads that are not numbers with the same unit.
std::vector<Figure> figures_of(std::string_view robot_file, const std::string& name, double mounting_mm);

struct RobotVariant {
  static constexpr int kLevels = 10;
  std::vector<int> levels;  ///< of each parameter: −kLevels is value − spread, 0 is the file's value

  std::vector<RobotVariant> smaller() const;
  /// Returns the text of a robot file; `base` itself if nothing differs.
  std::string file(const std::string& base, const std::vector<Figure>& figures) const;
};
RobotVariant assemble(const std::vector<Figure>& figures, const RandomSource& rng);

}  // namespace robosim::worlds
