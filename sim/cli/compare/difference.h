// Facts about a difference that a comparison has found.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

#include "sim/cli/compare/compare_report.h"

namespace robosim::cli {

/// Returns whether a robot's sketch has used a feature that this target run's target lacks.
bool lacks_something(const ComparedTarget& target_run);

/// For a robot in two target runs: sets the chip features that a side lacks, if the sketch had used them
/// before the difference. Skipped if the difference has a named cause, or the checks have found one.
void find_lacks(Compared& compared, std::size_t robot, const std::array<std::size_t, 2>& target_runs);

/// Returns where the text of a side begins to differ from that of the other.
std::size_t first_difference(const Compared& compared, std::size_t side, const std::string& text);

/// Returns when the difference has shown, at the latest: a side may reach a missing place later.
std::int64_t shows_by(const Compared& compared);

}  // namespace robosim::cli
