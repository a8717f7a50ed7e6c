// Describes a run for its recording.
#pragma once

#include <string>

#include "sim/launch/fleet.h"
#include "sim/launch/launch.h"
#include "sim/record/recorder.h"

namespace robosim::campaign {

/// Returns the description of a run for recordings. `version` is the runner's version.
record::RecordedRun recorded(const launch::Prepared& run, const std::string& version);
record::RecordedRun recorded(const launch::Fleet& fleet, const launch::PreparedFleet& run,
                             const std::string& version);

}  // namespace robosim::campaign
