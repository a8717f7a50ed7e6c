// Stores a copy of the firmware's state, and compares it with the present state. The state consists of
// variables, heap and stack. The stack contains the registers that calls preserve (hal/host/clock.cpp). The
// state of running clocks is not included (host::Image::clockwork_begin).
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
  /// Returns whether the present state equals the stored state.
  bool is_like(Memory heap, Memory stack) const;

  // These variants use only the part of the heap that malloc() has used. They compare the settings (image.h)
  // only if the settings may have changed since take() or the last call that returned true. Therefore only
  // one snapshot of an image may use these variants.
  void take(host::FirmwareState& state, Memory stack);
  bool is_like(host::FirmwareState& state, Memory stack) const;

 private:
  bool all_but_settings_are_like(Memory heap, Memory stack) const;

  struct Part {
    Memory memory;
    std::vector<std::byte> copy = {};
  };
  std::vector<Part> variables_;  ///< variables, without the settings and running clocks
  Part settings_;
  std::vector<std::byte> heap_, stack_;
};

}  // namespace robosim::exec
