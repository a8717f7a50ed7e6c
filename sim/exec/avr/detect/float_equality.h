// Finds a float that is compared by == or != with a value that it passes and never meets.
//
//   while (angle != 90.0) angle += 0.7;      // 89.6, 90.3, …: the loop does not end
//
// Most decimal fractions have no exact float, and measured or accumulated values rarely hit a number exactly:
// 0.1, added up ten times, is 1.0000001. A finding is a comparison in the sketch that
//
//   - was made at least 10 times, with a constant value on one side, and was never equal;
//   - saw the other side both below and above that value, so the value has passed it;
//   - if the constant is 0: saw the value move away from it for 20 consecutive comparisons. Skipping a step
//     while an error is 0 is harmless.
//
// So detecting a change (x != last) is not a finding. To fix it, use >= or <=, or fabs(a - b) < 0.5, or count
// in integers.
//
// On the chip such a comparison is a call of a libgcc function, followed by a test of its result for 0. The
// arguments are in registers (avr-gcc's ABI: R22 to R25 and R18 to R21). Not examined: the host, where it
// is an ordinary instruction, and comparisons that the compiler has evaluated itself.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/exec/avr/detect/detector.h"
#include "sim/exec/avr/machine.h"

namespace robosim::exec::avr {

class FloatEquality final : public Detector {
 public:
  FloatEquality(Machine& machine, const Program& program);

  void visited(std::uint32_t pc, robosim::avr::Cycle at) override;
  std::vector<Detected> found() const override;

 private:
  /// A comparison in the program.
  struct Comparison {
    std::uint32_t pc = 0;
    std::uint32_t left = 0, right = 0;  ///< bits of the floats of the first comparison
    bool left_varies = false, right_varies = false;
    bool met = false;  ///< was equal once, or must not be examined
    std::int64_t times = 0;
    float before = 0.0f;  ///< right - left of the last comparison
    bool has_passed = false;
    int away = 0;           ///< consecutive comparisons since it passed
    SimTime found_at = -1;  ///< below 0: not found yet
  };

  static float constant(const Comparison& one);

  const Machine& machine_;
  const DebugInfo& debug_;
  std::vector<Comparison> comparisons_;  ///< by pc
};

}  // namespace robosim::exec::avr
