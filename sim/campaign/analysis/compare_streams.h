// Compares lines that firmware prints repeatedly, such as measurements a few times a second. The two sides
// print them at different moments, and a vibrating robot measures different values then. Each line is
// therefore compared with several lines that the other side prints at about the same time.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "sim/campaign/analysis/alignment.h"
#include "sim/campaign/analysis/compare.h"
#include "sim/campaign/analysis/line_text.h"

namespace robosim::analysis {

/// A line, and its index among all lines of its side.
struct Said {
  std::int64_t t_ns = 0;
  std::string text;
  LineText parts;
  std::size_t number = 0;
};

/// The lines of each side.
using Lanes = std::array<std::vector<Said>, 2>;

/// Returns whether lines of one form (line_text.h) that came at these times are a stream.
bool is_stream(const std::vector<std::int64_t>& came);

/// Compares the lines of one form, which are a stream on at least one side. Returns differences in their
/// rate, their presence at any time and their numbers: at most one of each kind and side.
std::vector<Difference> stream_differences(const std::string& form, const Lanes& lanes,
                                           const std::array<const History*, 2>& sides, const Clocks& clocks,
                                           const Tolerance& tolerance);

}  // namespace robosim::analysis
