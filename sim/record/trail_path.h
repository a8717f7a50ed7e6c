// Approximates a trail by a few straight pieces, each in one colour. Only record_svg.cpp uses these
// functions.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "sim/record/record_svg.h"

namespace robosim::record {

/// The number of colours for speeds.
inline constexpr int kSpeedColours = 9;
/// Returns a colour such as "#5402a3": from dark (slow) to light (fast). The steps are distinct for
/// colour-blind people, too. `number` counts from 0.
std::string speed_colour(int number);

/// A section of the trail in one colour, with the indices of its first and last point.
struct Stretch {
  std::size_t first, last;
  int colour;
};
/// Divides the trail into stretches. They meet at their ends, unless the robot was moved manually in between.
std::vector<Stretch> stretches(const std::vector<SvgRecorder::Point>& trail, double fastest_mm_s);

/// Returns the points to draw. No other point is more than `tolerance_mm` away from the drawn line.
std::vector<std::size_t> corners(const std::vector<SvgRecorder::Point>& trail, std::size_t first,
                                 std::size_t last, double tolerance_mm);

}  // namespace robosim::record
