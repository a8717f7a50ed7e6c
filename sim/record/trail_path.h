// A trail as few straight pieces, each of one colour. An implementation detail of record_svg.cpp.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "sim/record/record_svg.h"

namespace robosim::record {

/// How many colours a speed is shown by.
inline constexpr int kSpeedColours = 9;
/// "#5402a3": from dark (slow) to light (fast), in steps that also the colour-blind tell apart. `number`
/// counts from 0.
std::string speed_colour(int number);

/// A stretch of the trail in one colour; the indices of its first and last point.
struct Stretch {
  std::size_t first, last;
  int colour;
};
/// Stretches meet at their ends, unless the robot was carried in between.
std::vector<Stretch> stretches(const std::vector<SvgRecorder::Point>& trail, double fastest_mm_s);

/// The points to draw so that no other is more than `tolerance_mm` off.
std::vector<std::size_t> corners(const std::vector<SvgRecorder::Point>& trail, std::size_t first,
                                 std::size_t last, double tolerance_mm);

}  // namespace robosim::record
