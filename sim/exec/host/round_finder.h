// Whether firmware goes round for ever, as far as it knows: a basic block finds the stack, the variables and
// the heap as the same block has left them before. Registers that outlive a call lie on the stack
// (hal/host/clock.cpp).
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "sim/exec/host/image_file.h"

namespace robosim::exec {

class RoundFinder {
 public:
  using Memory = std::span<const std::byte>;

  /// Variables and `heap` are what firmware keeps, but for its stack.
  RoundFinder(const LoadedImage& image, Memory heap);

  /// Forgets what it has seen: something else than firmware has run.
  void begin();
  /// Whether this has been seen before; `place` names the block.
  bool sees(const void* place, Memory stack);

 private:
  void take(const void* place, Memory stack);
  bool is_taken(const void* place, Memory stack) const;

  std::vector<Memory> kept_;
  // One state is remembered, and given up for a later one after 1, 2, 4 … blocks (Brent, 1980: An improved
  // Monte Carlo factorization algorithm, section 2).
  const void* place_ = nullptr;
  std::vector<std::byte> stack_;
  std::vector<std::vector<std::byte>> copies_;
  int power_ = 1, since_ = 0;
};

}  // namespace robosim::exec
