// The results, as keys of a robot file.
#pragma once

#include <string>
#include <vector>

#include "sim/calibrate/drive_fit.h"
#include "sim/calibrate/sweep_fit.h"
#include "sim/robot/description.h"

namespace robosim::calibrate {

/// A key of [chassis], [motors] or a [[part]], with its value and uncertainty.
struct Figure {
  std::string table;  ///< "chassis", "motors", or the part's name
  bool of_part = false;
  std::string key;
  std::vector<Found> found;        ///< one, or one per element; SI
  std::vector<std::string> of;     ///< the elements' names, if there is one for each
  const char* unit = "";           ///< in the file; "" = a share
  double scale = 1.0;              ///< of the unit, in SI
  double before = 0.0;             ///< the file's value (of an array the first element's), SI
  double least = 0.0, most = 0.0;  ///< the limits of robot files, including spread; SI
  std::string remark;              ///< "" or its dependency
  double against = 0.0;            ///< what uncertainty is relative to, SI: white to black; 0 = the value
};

/// Returns twice the standard deviation, which is written as spread, SI. It is at least the value of the last
/// written digit.
double spread_of(const Found&);

/// Returns the uncertainty of a value, as a share of it (or of `against`).
double unsureness(const Figure&, const Found&);
/// Returns that of the least certain one.
double least_sure(const Figure&);

/// Returns whether robot files may contain it.
bool is_possible(const Figure&);

/// Returns "2.31 mm ± 0.08 mm".
std::string shown(const Figure&, const Found&);

/// Returns TOML: { value = "2.31 mm", spread = "0.08 mm" }, or a list of them.
std::string toml_value(const Figure&);

/// Values with a larger uncertainty than this, twice the standard deviation over the value, are not written.
constexpr double kMostSpread = 0.5;

std::vector<Figure> figures_of(const SweepFit&, const robot::Description&);
std::vector<Figure> figures_of(const DriveFit&, const robot::Description&);
Figure supply_figure(Found supply, const robot::Description&);

}  // namespace robosim::calibrate
