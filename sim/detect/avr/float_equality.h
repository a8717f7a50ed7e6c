// Detects a comparison (== or !=) of a float with a constant that the float passes but never equals.
//
//   while (angle != 90.0) angle += 0.7;      // 89.6, 90.3, …: the loop does not end
//
// A float cannot store most decimal fractions exactly, and a measured or accumulated value rarely equals a
// number exactly. The sum of ten times 0.1 is 1.0000001. A finding is a comparison in the sketch with these
// properties:
//
//   - it ran at least 10 times, with a constant on one side, and its two sides were never equal;
//   - the other side was below the constant at one time and above it at another: the value has passed it;
//   - if the constant is 0, the value did not come closer to 0 in 20 consecutive comparisons. This exempts
//     `if (error != 0) correct();`, where a control error changes its sign repeatedly.
//
// A comparison that detects a change (x != last) has no constant side, and is not a finding. To fix the
// sketch, use >= or <=, or fabs(a - b) < 0.5, or count in integers.
//
// On the chip, a comparison of floats calls a libgcc function and tests the function's result for 0. The
// floats are in registers (avr-gcc's ABI: R22 to R25 and R18 to R21). Sketches on the host are not examined,
// because a comparison is an ordinary instruction there. Comparisons that the compiler has already evaluated
// are not examined either.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/detect/avr/chip_detector.h"

namespace robosim::detect::avr {

class FloatEquality final : public ChipDetector {
 public:
  explicit FloatEquality(const RunningProgram& program);

  void visited(std::uint32_t pc, Cycle at) override;
  std::vector<Detected> found(SimTime) const override;

 private:
  /// A comparison in the program, and the results of the comparison so far.
  struct Comparison {
    std::uint32_t pc = 0;
    std::uint32_t left = 0, right = 0;  ///< bits of the first compared floats
    bool left_varies = false, right_varies = false;
    bool met = false;  ///< not a finding: the sides were once equal or not finite, or both vary
    std::int64_t times = 0;
    float before = 0.0f;  ///< right side minus left side in the last comparison
    bool has_passed = false;
    int away = 0;           ///< consecutive comparisons in which the value did not come closer
    SimTime found_at = -1;  ///< negative = not found yet
  };

  static float constant(const Comparison& one);

  const Machine& machine_;
  const DebugInfo& debug_;
  std::vector<Comparison> comparisons_;  ///< sorted by pc
};

}  // namespace robosim::detect::avr
