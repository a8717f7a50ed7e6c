// A snapshot of all state of firmware: its variables, heap and stack. Registers that outlive a call lie on
// the stack (hal/host/clock.cpp). Free-running clocks are not included (host::Image::clockwork_begin).
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "sim/exec/host/image_file.h"

namespace robosim::exec {

class FirmwareSnapshot {
 public:
  using Memory = std::span<const std::byte>;

  explicit FirmwareSnapshot(const LoadedImage& image);

  void take(Memory heap, Memory stack);
  /// Returns whether all state is equal to the snapshot.
  bool is_like(Memory heap, Memory stack) const;

  // Variants with malloc's allocations as the heap. Settings, as image.h defines them, are compared only if
  // they may have changed since the last call that returned true. So an image can have only one such
  // snapshot.
  void take(host::FirmwareState& state, Memory stack);
  bool is_like(host::FirmwareState& state, Memory stack) const;

 private:
  bool all_but_settings_are_like(Memory heap, Memory stack) const;

  struct Part {
    Memory memory;
    std::vector<std::byte> copy = {};
  };
  std::vector<Part> variables_;  ///< except the settings
  Part settings_;
  std::vector<std::byte> heap_, stack_;
};

}  // namespace robosim::exec
