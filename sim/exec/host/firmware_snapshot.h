// A snapshot of all state of firmware: its variables, heap and stack. Registers that calls preserve are saved
// on the stack (hal/host/clock.cpp). Free-running clocks are not included (host::Image::clockwork_begin).
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
  /// Returns whether all state equals that of the snapshot.
  bool is_like(Memory heap, Memory stack) const;

  // These variants use only the part of the heap that malloc() has used. They compare settings (image.h) only
  // if the settings may have changed since the last call that returned true. An image can therefore have only
  // one such snapshot.
  void take(host::FirmwareState& state, Memory stack);
  bool is_like(host::FirmwareState& state, Memory stack) const;

 private:
  bool all_but_settings_are_like(Memory heap, Memory stack) const;

  struct Part {
    Memory memory;
    std::vector<std::byte> copy = {};
  };
  std::vector<Part> variables_;  ///< without the settings
  Part settings_;
  std::vector<std::byte> heap_, stack_;
};

}  // namespace robosim::exec
