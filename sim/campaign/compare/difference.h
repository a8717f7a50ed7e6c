// Examines a difference that a comparison has found.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

#include "sim/campaign/compare/compared.h"

namespace robosim::campaign {

/// Returns whether a robot's sketch has used a feature that the target lacks.
bool lacks_something(const ComparedTarget& target_run);

/// Finds the chip features that one of two target runs lacks, if the robot's sketch used them before the
/// difference. Stores them in `compared`. Finds nothing if the difference has a named cause, or if a run with
/// sanitizers has found a cause.
void find_lacks(Compared& compared, std::size_t robot, const std::array<std::size_t, 2>& target_runs);

/// Returns the index at which a side's text begins to differ from the other side's.
std::size_t first_difference(const Compared& compared, std::size_t side, const std::string& text);

/// Returns the time by which the difference shows. If only one side has reached a place, adds time in which
/// the other side may still arrive.
std::int64_t shows_by(const Compared& compared);

}  // namespace robosim::campaign
