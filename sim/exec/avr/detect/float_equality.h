// A float that is compared by == or != with a value which it passes, and never meets.
//
//   while (angle != 90.0) angle += 0.7;      89.6, 90.3, …: the loop does not end
//
// Most decimal fractions are no floats, and what is measured or added up comes close to a number, seldom to
// it: 0.1, added up ten times, is 1.0000001. What is found is a comparison of the sketch's which
//
//   was made 10 times or more, with a constant value on one side, and never found both equal
//   saw the other side on both sides of that value: it has passed it
//   is with 0: and ran away from it for 20 comparisons on end, for who only spares himself a step where an
//   error is 0 misses nothing
//
// So what watches for a change (x != last) is no finding. Mended by >= or <=, by fabs(a - b) < 0.5, or by
// counting in integers.
//
// On the chip such a comparison is a call of a function of libgcc, whose arguments lie in registers
// (avr-gcc's ABI: R22 to R25 and R18 to R21), and a test of its result for 0 behind it. On the host it is an
// instruction among others, and not looked at. Nor are comparisons that the compiler has done itself.
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
  /// One in the program.
  struct Comparison {
    std::uint32_t pc = 0;
    std::uint32_t left = 0, right = 0;  ///< the first time, bits of floats
    bool left_varies = false, right_varies = false;
    bool met = false;  ///< once, or never to be looked at
    std::int64_t times = 0;
    float before = 0.0f;  ///< right - left, last time
    bool has_passed = false;
    int away = 0;           ///< comparisons on end since it passed
    SimTime found_at = -1;  ///< below 0: not yet
  };

  static float constant(const Comparison& one);

  const Machine& machine_;
  const DebugInfo& debug_;
  std::vector<Comparison> comparisons_;  ///< by pc
};

}  // namespace robosim::exec::avr
