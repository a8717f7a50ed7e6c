// A loop() that is called out of itself, and does not come back.
//
//   void goTo(int n) { drive(n); for (;;) loop(); }      each destination begins a loop() in the last one
//
// Each call takes a return address, saved registers and local variables of the stack, for ever. The chip has
// 2 KB: after some calls, which may take a minute or a week, the stack reaches the variables, a threshold or
// a pointer is overwritten, and the sketch goes astray or starts again.
//
//   nested_loop   three loop() are open at once, each in the one before
//
// One loop() within another is none: some wait for a button that way, and come back.
// What it cannot see: other functions that call themselves; a loop() that the compiler has made a jump of.
//
// Mended by return: main() calls loop() again and again.
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
  std::vector<std::uint16_t> open_;  ///< the stack pointer at the beginning of each, the outermost first
  std::size_t deepest_ = 0;
  Detected seen_;
};

}  // namespace robosim::exec::avr
