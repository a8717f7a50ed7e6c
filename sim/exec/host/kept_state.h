// All that firmware keeps, as it was at one moment: its variables, heap and stack. Registers that outlive a
// call lie on the stack (hal/host/clock.cpp). Clocks that go on by themselves are left out
// (host::Image::clockwork_begin).
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "sim/exec/host/image_file.h"

namespace robosim::exec {

class KeptState {
 public:
  using Memory = std::span<const std::byte>;

  explicit KeptState(const LoadedImage& image);

  void take(Memory heap, Memory stack);
  /// Whether all is now as it was taken.
  bool is_like(Memory heap, Memory stack) const;

 private:
  std::vector<Memory> variables_;
  std::vector<std::vector<std::byte>> copies_;
  std::vector<std::byte> heap_, stack_;
};

/// What malloc has given, in whole pages: a sketch may write a little past the end of its own.
KeptState::Memory used_heap(const host::FirmwareState& state);

}  // namespace robosim::exec
