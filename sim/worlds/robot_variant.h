// One of the robots that a robot file's figures with a spread stand for.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sim/worlds/die.h"

namespace robosim::worlds {

/// A number that differs from robot to robot.
struct Figure {
  std::string table;  ///< "chassis"; or "part S"
  std::string key;    ///< "track"; or "at 0", "at 1": the first and second item of `at`
  double value = 0.0;
  double spread = 0.0;  ///< in the same unit
  std::string unit;     ///< "mm"; "" = none
};

/// The figures of a robot file with a spread, in its order, and the places of its floor sensors, give or take
/// `mounting_mm`. Values or spreads that are not numbers with the same unit are left out.
std::vector<Figure> figures_of(std::string_view robot_file, const std::string& name, double mounting_mm);

struct RobotVariant {
  static constexpr int kLevels = 10;
  std::vector<int> levels;  ///< of each figure: −kLevels is value − spread, 0 is as in the file

  std::vector<RobotVariant> smaller() const;
  /// As a robot file; `base` itself if nothing is different.
  std::string file(const std::string& base, const std::vector<Figure>& figures) const;
};
RobotVariant assemble(const std::vector<Figure>& figures, const Die& die);

}  // namespace robosim::worlds
