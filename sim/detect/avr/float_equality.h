// Detects a comparison (== or !=) of a float with a constant that the float passes but never equals.
//
//   while (angle != 90.0) angle += 0.7;      // 89.6, 90.3, …: the loop does not end
//
// Most decimal fractions have no exact float, and measured or accumulated values rarely hit a number exactly:
// 0.1, added up ten times, is 1.0000001. A finding is a comparison in the sketch that
//
//   - ran at least 10 times, with a constant on one side, and never found equal values;
//   - found the other side both below and above the constant, which proves that the value has passed it;
//   - if the constant is 0, found the value moving away from 0 in 20 consecutive comparisons. A sketch
//     that skips a step while an error is 0 is harmless.
//
// A comparison that detects a change (x != last) is therefore not a finding. To fix the sketch, use >= or <=,
// or fabs(a - b) < 0.5, or count in integers.
//
// On the chip, such a comparison calls a libgcc function and tests the result for 0. The arguments are in
// registers (avr-gcc's ABI: R22 to R25 and R18 to R21). Not examined: sketches on the host, where a
// comparison is an ordinary instruction, and comparisons that the compiler has evaluated itself.
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
  /// A comparison in the program, and its results so far.
  struct Comparison {
    std::uint32_t pc = 0;
    std::uint32_t left = 0, right = 0;  ///< bits of the first compared floats
    bool left_varies = false, right_varies = false;
    bool met = false;  ///< the floats were equal once, or both vary, or one is not finite
    std::int64_t times = 0;
    float before = 0.0f;  ///< right - left in the last comparison
    bool has_passed = false;
    int away = 0;           ///< consecutive comparisons in which the value moved away
    SimTime found_at = -1;  ///< negative = not found yet
  };

  static float constant(const Comparison& one);

  const Machine& machine_;
  const DebugInfo& debug_;
  std::vector<Comparison> comparisons_;  ///< by pc
};

}  // namespace robosim::detect::avr
