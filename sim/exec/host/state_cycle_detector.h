// Detects firmware whose own state shows that it loops for ever: a basic block begins with the same stack,
// variables and heap as before. Registers that calls preserve are saved on the stack (hal/host/clock.cpp).
#pragma once

#include "sim/exec/host/firmware_snapshot.h"

namespace robosim::exec {

class StateCycleDetector {
 public:
  using Memory = FirmwareSnapshot::Memory;

  /// The firmware's state consists of the image's variables, `heap` and the stack.
  StateCycleDetector(const LoadedImage& image, Memory heap) : state_(image), heap_(heap) {}

  /// Drops the recorded state. Call it after code other than firmware has run.
  void begin();
  /// Returns whether this state was recorded before. `place` identifies the block.
  bool sees(const void* place, Memory stack);

 private:
  FirmwareSnapshot state_;
  Memory heap_;
  // Stores only one state, and replaces it by the present one after 1, 2, 4 … blocks. Source: Brent, 1980:
  // An improved Monte Carlo factorization algorithm, section 2.
  const void* place_ = nullptr;
  int power_ = 1, since_ = 0;
};

}  // namespace robosim::exec
