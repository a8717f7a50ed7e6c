// Converts the results of the fits to keys of a robot file.
#pragma once

#include <string>
#include <vector>

#include "sim/campaign/calibrate/drive_fit.h"
#include "sim/campaign/calibrate/sweep_fit.h"
#include "sim/robot/description.h"

namespace robosim::calibrate {

/// A key of [chassis], [motors] or a [[part]], with its value and uncertainty.
struct Figure {
  std::string table;  ///< "chassis", "motors", or the part's name
  bool of_part = false;
  std::string key;
  std::vector<Found> found;        ///< one value, or one per element; SI
  std::vector<std::string> of;     ///< names of the elements, if each has a value
  const char* unit = "";           ///< unit in the file; "" = a share
  double scale = 1.0;              ///< size of the unit, in SI
  double before = 0.0;             ///< value in the file (first element of an array), SI
  double least = 0.0, most = 0.0;  ///< value ± spread must be within these limits; SI
  std::string remark;              ///< "" or the assumption behind the value
  double against = 0.0;            ///< the uncertainty is relative to this value, SI; 0 = to the value itself
};

/// Returns the spread to write, SI: twice the standard deviation.
double spread_of(const Found&);

/// Returns the uncertainty of a value, relative to that value, or to `against` if `against` is not 0.
double unsureness(const Figure&, const Found&);
/// Returns the relative uncertainty of the least certain value.
double least_sure(const Figure&);

/// Returns whether robot files may contain the value.
bool is_possible(const Figure&);

/// Returns the value with its uncertainty: "2.31 mm ± 0.08 mm".
std::string shown(const Figure&, const Found&);

/// Returns TOML: { value = "2.31 mm", spread = "0.08 mm" }, or a list of such tables.
std::string toml_value(const Figure&);

/// Values with a larger relative uncertainty, unsureness(), are not written to the robot file.
constexpr double kMostSpread = 0.5;

std::vector<Figure> figures_of(const SweepFit&, const robot::Description&);
std::vector<Figure> figures_of(const DriveFit&, const robot::Description&);
Figure supply_figure(Found supply, const robot::Description&);

}  // namespace robosim::calibrate
