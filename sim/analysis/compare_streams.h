// Lines that firmware prints again and again: what it measures, a few times a second. Two sides print them at
// other moments, and a robot shakes: so each is held against what the other side says at about that time.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "sim/analysis/alignment.h"
#include "sim/analysis/compare.h"
#include "sim/analysis/line_text.h"

namespace robosim::analysis {

/// A line, and its number among all lines of its side.
struct Said {
  std::int64_t t_ns = 0;
  std::string text;
  LineText parts;
  std::size_t number = 0;
};

/// Of either side.
using Lanes = std::array<std::vector<Said>, 2>;

/// Whether lines of one form that came at these times are a stream.
bool is_stream(const std::vector<std::int64_t>& came);

/// What differs in the lines of one form that are a stream on one side at least: that one side has none, how
/// often they come, when they begin and end, and their numbers. At most one of each kind and side.
std::vector<Difference> stream_differences(const std::string& form, const Lanes& lanes,
                                           const std::array<const History*, 2>& sides, const Clocks& clocks,
                                           const Tolerance& tolerance);

}  // namespace robosim::analysis
