// Compares the motors of two histories.
#pragma once

#include <array>
#include <optional>

#include "sim/campaign/analysis/alignment.h"
#include "sim/campaign/analysis/compare.h"

namespace robosim::analysis {

/// Returns the first manoeuvre of `side` (0 or 1) that the other side does not make.
std::optional<Difference> missing_manoeuvre(const std::array<const History*, 2>& sides, std::size_t side,
                                            const Clocks& clocks);

/// Returns the first period in which one side drives faster on average. Each period lies between two events
/// that both sides have.
std::optional<Difference> speed_difference(const std::array<const History*, 2>& sides, const Clocks& clocks);

}  // namespace robosim::analysis
