// Detects a loop() that calls itself, directly or indirectly, without returning.
//
//   void goTo(int n) { drive(n); for (;;) loop(); }      each destination starts another nested loop()
//
// Each call pushes a return address, saved registers and local variables, which are never popped. An
// ATmega328P has 2 KB of RAM. After minutes or days, the stack therefore reaches the variables. The stack
// then overwrites a threshold or a pointer, and the sketch misbehaves or restarts.
//
//   nested_loop   three calls of loop() are active at once, each within the previous call
//
// One nested call is not a finding, because some sketches call loop() once while they wait for a button.
// Other recursive functions are not detected. Calls of loop() that the compiler has replaced by jumps are not
// detected either.
//
// To fix the sketch, return from loop(), because main() calls loop() repeatedly.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sim/detect/avr/chip_detector.h"

namespace robosim::detect::avr {

class NestedLoop final : public ChipDetector {
 public:
  explicit NestedLoop(const RunningProgram& program);

  void visited(std::uint32_t pc, Cycle at) override;
  std::vector<Detected> found(SimTime) const override;

 private:
  const RunningProgram program_;
  std::vector<std::uint16_t> open_;  ///< stack pointers at the start of the active calls, outermost first
  std::size_t deepest_ = 0;
  Detected seen_;
};

}  // namespace robosim::detect::avr
