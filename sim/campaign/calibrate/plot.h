// Plots measured and fitted values as an SVG picture: the edges of each part's sensors, and each drive.
#pragma once

#include <string>

#include "sim/campaign/calibrate/calibrate.h"

namespace robosim::calibrate {

/// Returns the picture. Equal calibrations give equal bytes.
std::string plot(const Calibration&);

}  // namespace robosim::calibrate
