// Line coverage of a sketch by its tests: $ROBOSIM_COVERAGE, docs/howto/coverage.md.
#pragma once

#include <string>

#include "sim/build/sketch.h"

namespace robosim::testing {

/// Returns the folder, if runs on this target are counted; else "".
std::string coverage_folder(const std::string& target);

/// Returns a new file in the folder for a run's counters; creates the folder.
std::string new_counter_file(const std::string& folder);

/// Adds a run to the folder, and removes its counters. Equal descriptions count as one run.
void keep_coverage(const std::string& folder, const std::string& counters, const build::Request& request,
                   const build::Image& image, const std::string& description);

}  // namespace robosim::testing
