// Plots measured and fitted values as a picture (.svg): the edges of each part's sensors, and each drive.
#pragma once

#include <string>

#include "sim/calibrate/calibrate.h"

namespace robosim::calibrate {

/// Equal calibrations give equal bytes.
std::string plot(const Calibration&);

}  // namespace robosim::calibrate
