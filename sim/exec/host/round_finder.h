// Whether firmware goes round for ever, as far as it knows: a basic block finds the stack, the variables and
// the heap as the same block has left them before. Registers that outlive a call lie on the stack
// (hal/host/clock.cpp).
#pragma once

#include "sim/exec/host/kept_state.h"

namespace robosim::exec {

class RoundFinder {
 public:
  using Memory = KeptState::Memory;

  /// Variables and `heap` are what firmware keeps, but for its stack.
  RoundFinder(const LoadedImage& image, Memory heap) : state_(image), heap_(heap) {}

  /// Forgets what it has seen: something else than firmware has run.
  void begin();
  /// Whether this has been seen before; `place` names the block.
  bool sees(const void* place, Memory stack);

 private:
  KeptState state_;
  Memory heap_;
  // One state is remembered, and given up for a later one after 1, 2, 4 … blocks (Brent, 1980: An improved
  // Monte Carlo factorization algorithm, section 2).
  const void* place_ = nullptr;
  int power_ = 1, since_ = 0;
};

}  // namespace robosim::exec
