// What was found, as keys of a robot file.
#pragma once

#include <string>
#include <vector>

#include "sim/calibrate/drive_fit.h"
#include "sim/calibrate/sweep_fit.h"
#include "sim/robot/description.h"

namespace robosim::calibrate {

/// A key of [chassis], [motors] or a [[part]], with its value and how far it may be off.
struct Figure {
  std::string table;  ///< "chassis", "motors", or the part's name
  bool of_part = false;
  std::string key;
  std::vector<Found> found;        ///< one, or one of each element; SI
  std::vector<std::string> of;     ///< the elements' names, if there is one of each
  const char* unit = "";           ///< as it is written; "" = a share
  double scale = 1.0;              ///< of the unit, in SI
  double before = 0.0;             ///< what the file had (of an array the first element's), SI
  double least = 0.0, most = 0.0;  ///< what robot files may have, spread included; SI
  std::string remark;              ///< "" or what it depends on
  double against = 0.0;  ///< what sureness is a share of, SI: from white to black; 0 = the value itself
};

/// Twice the standard deviation: what is written as spread, SI. At least what the last figure written stands
/// for.
double spread_of(const Found&);

/// How far a value may be off, as a share of it (or of `against`).
double unsureness(const Figure&, const Found&);
/// Of the one that is least sure.
double least_sure(const Figure&);

/// Whether robot files may have it.
bool is_possible(const Figure&);

/// "2.31 mm ± 0.08 mm".
std::string shown(const Figure&, const Found&);

/// As TOML: { value = "2.31 mm", spread = "0.08 mm" }, or a list of them.
std::string toml_value(const Figure&);

/// Figures that are less sure than this, twice the standard deviation against the value, are not written.
constexpr double kMostSpread = 0.5;

std::vector<Figure> figures_of(const SweepFit&, const robot::Description&);
std::vector<Figure> figures_of(const DriveFit&, const robot::Description&);
Figure supply_figure(Found supply, const robot::Description&);

}  // namespace robosim::calibrate
