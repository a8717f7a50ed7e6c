// Which lines of a sketch ran in its tests: $ROBOSIM_COVERAGE, docs/coverage.md.
#pragma once

#include <string>

#include "sim/build/sketch.h"

namespace robosim::testing {

/// The folder, if runs on this target are counted; else "".
std::string coverage_folder(const std::string& target);

/// A new file in the folder for a run's counters; makes the folder.
std::string new_counter_file(const std::string& folder);

/// Adds a run to the folder, and removes its counters. Equal descriptions are one run.
void keep_coverage(const std::string& folder, const std::string& counters, const build::Request& request,
                   const build::Image& image, const std::string& description);

}  // namespace robosim::testing
