// The results of `robosim test` as JUnit XML, as CI servers read it.
#pragma once

#include <string>
#include <vector>

#include "sim/cli/check/check_result.h"

namespace robosim::cli {

/// A test suite for each sketch, a test case for each check, with its figures as properties, and of a failure
/// what the sketch sent (system-out). All times are simulated, so that equal results give equal bytes.
std::string junit_xml(const std::vector<SketchResult>& sketches);

}  // namespace robosim::cli
