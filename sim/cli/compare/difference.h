// What can be said of the difference that a comparison has found.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

#include "sim/cli/compare/compare_report.h"

namespace robosim::cli {

/// Whether a robot's sketch has used something that this lane's target lacks.
bool lacks_something(const ComparedLane& lane);

/// Fills in what a side lacks of the chip, where the sketch had used that there before the difference, of a
/// robot in two lanes. Not where the difference has a named cause, or the checks have found one.
void find_lacks(Compared& compared, std::size_t robot, const std::array<std::size_t, 2>& lanes);

/// Where the text of a side begins to differ from that of the other.
std::size_t first_difference(const Compared& compared, std::size_t side, const std::string& text);

/// When the difference has shown, at the latest: a place to which a side has not come it may come to later.
std::int64_t shows_by(const Compared& compared);

}  // namespace robosim::cli
