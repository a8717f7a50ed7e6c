// Writes the results of `robosim test` as JUnit XML, for CI servers.
#pragma once

#include <string>
#include <vector>

#include "sim/campaign/check/check_result.h"

namespace robosim::campaign {

/// Returns a test suite for each sketch, with a test case for each check. Measurements become properties
/// of the test case. A failure contains the sketch's output (system-out). All times are simulated, so that
/// equal results give equal bytes.
std::string junit_xml(const std::vector<SketchResult>& sketches);

}  // namespace robosim::campaign
