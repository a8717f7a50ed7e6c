// Detects firmware that loops for ever. This is proved if a basic block begins with the same stack, variables
// and heap as at an earlier time. The stack contains the registers that calls preserve (hal/host/clock.cpp).
#pragma once

#include "sim/exec/host/firmware_snapshot.h"

namespace robosim::exec {

class StateCycleDetector {
 public:
  using Memory = FirmwareSnapshot::Memory;

  /// `image` and `heap` contain the firmware's variables and heap. sees() receives the stack.
  StateCycleDetector(const LoadedImage& image, Memory heap) : state_(image), heap_(heap) {}

  /// Drops the recorded state. Call it after code other than firmware has run.
  void begin();
  /// Returns whether the present state equals the recorded state. `place` identifies the basic block.
  bool sees(const void* place, Memory stack);

 private:
  FirmwareSnapshot state_;
  Memory heap_;
  // Records only one state, and replaces it by the present state after 1, 2, 4 … blocks. Source: Brent, 1980:
  // An improved Monte Carlo factorization algorithm, section 2.
  const void* place_ = nullptr;
  int power_ = 1, since_ = 0;
};

}  // namespace robosim::exec
