// Describes one of the robots that a robot file with spreads allows.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sim/campaign/random_worlds/random_source.h"

namespace robosim::random_worlds {

/// A parameter that varies between robots.
struct Figure {
  std::string table;  ///< "chassis", or "part S"
  std::string key;    ///< "track"; or "at 0", "at 1": the first and second item of `at`
  double value = 0.0;
  double spread = 0.0;  ///< in the unit of `value`
  std::string unit;     ///< "mm"; "" = none
};

/// Returns the parameters with a spread in a robot file, in the file's order. Adds the positions of the
/// robot's floor sensors, with the spread `mounting_mm`. Skips parameters whose value or spread is not a
/// number in the same unit.
std::vector<Figure> figures_of(std::string_view robot_file, const std::string& name, double mounting_mm);

struct RobotVariant {
  static constexpr int kLevels = 10;
  std::vector<int> levels;  ///< per parameter: −kLevels is value − spread, 0 is the file's value

  std::vector<RobotVariant> smaller() const;
  /// Returns the text of the variant's robot file, based on the robot `base`. Returns only `base` if nothing
  /// differs.
  std::string file(const std::string& base, const std::vector<Figure>& figures) const;
};
RobotVariant assemble(const std::vector<Figure>& figures, const RandomSource& rng);

}  // namespace robosim::random_worlds
