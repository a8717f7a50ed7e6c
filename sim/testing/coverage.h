// Collects the line coverage of a sketch by its tests, in the folder that the environment variable
// ROBOSIM_COVERAGE names (docs/howto/coverage.md).
#pragma once

#include <string>

#include "sim/build/sketch.h"

namespace robosim::testing {

/// Returns the coverage folder if lines are counted on this target, else "".
std::string coverage_folder(const std::string& target);

/// Creates the folder, and returns a new file in it for a run's counters.
std::string new_counter_file(const std::string& folder);

/// Adds the counters of a run to the folder, and removes their file. Runs with equal descriptions count once.
void keep_coverage(const std::string& folder, const std::string& counters, const build::Request& request,
                   const build::Image& image, const std::string& description);

}  // namespace robosim::testing
