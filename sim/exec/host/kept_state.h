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

  // The same with what malloc has given as the heap. What image.h calls settings is only looked at if it may
  // have changed since the last of these calls that gave true: there can be one such keeper of an image.
  void take(host::FirmwareState& state, Memory stack);
  bool is_like(host::FirmwareState& state, Memory stack) const;

 private:
  bool all_but_settings_are_like(Memory heap, Memory stack) const;

  struct Part {
    Memory memory;
    std::vector<std::byte> copy = {};
  };
  std::vector<Part> variables_;  ///< but for the settings
  Part settings_;
  std::vector<std::byte> heap_, stack_;
};

}  // namespace robosim::exec
