// Detects firmware that loops for ever, as far as its own state goes. A basic block then meets the stack,
// variables and heap that it has met before. Registers that outlive a call lie on the stack
// (hal/host/clock.cpp).
#pragma once

#include "sim/exec/host/firmware_snapshot.h"

namespace robosim::exec {

class StateCycleDetector {
 public:
  using Memory = FirmwareSnapshot::Memory;

  /// Variables and `heap` are the firmware's state, except its stack.
  StateCycleDetector(const LoadedImage& image, Memory heap) : state_(image), heap_(heap) {}

  /// Forgets the recorded state: code other than firmware has run.
  void begin();
  /// Returns whether this state was seen before; `place` identifies the block.
  bool sees(const void* place, Memory stack);

 private:
  FirmwareSnapshot state_;
  Memory heap_;
  // Stores one state, and replaces it by a later one after 1, 2, 4 … blocks. Source: Brent, 1980: An improved
  // Monte Carlo factorization algorithm, section 2.
  const void* place_ = nullptr;
  int power_ = 1, since_ = 0;
};

}  // namespace robosim::exec
