// Detects a loop() that calls itself, directly or not, and does not return.
//
//   void goTo(int n) { drive(n); for (;;) loop(); }      each destination begins a loop() in the last one
//
// Each call takes a return address, saved registers and local variables from the stack, for ever. The chip
// has 2 KB. After some calls, which may take a minute or a week, the stack reaches the variables. A threshold
// or a pointer is overwritten, and the sketch misbehaves or restarts.
//
//   nested_loop   three loop() are open at once, each within the previous one
//
// One loop() within another is not a finding: some sketches wait for a button that way, and return. Not
// detected: other functions that call themselves; a loop() whose call the compiler has turned into a jump.
//
// Fix it by return: main() calls loop() repeatedly.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sim/exec/avr/detect/detector.h"
#include "sim/exec/avr/machine.h"

namespace robosim::exec::avr {

class NestedLoop final : public Detector {
 public:
  NestedLoop(Machine& machine, const Program& program);

  void visited(std::uint32_t pc, Cycle at) override;
  std::vector<Detected> found() const override;

 private:
  Machine& machine_;
  const Program program_;
  std::vector<std::uint16_t> open_;  ///< stack pointers at the beginning of each, the outermost first
  std::size_t deepest_ = 0;
  Detected seen_;
};

}  // namespace robosim::exec::avr
