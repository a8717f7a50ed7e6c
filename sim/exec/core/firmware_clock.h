// Converts between the firmware's clock and the world's clock. The two clocks are equal until drift() is
// called. At the last call of drift(), the firmware's clock showed f0, and the world's clock showed w0. Times
// in whole nanoseconds are converted by:
//   firmware = f0 + ceil((world - w0) (1 + ppm / 10^6))
//   world    = w0 + floor((firmware - f0) / (1 + ppm / 10^6))
// This rounding ensures that world(f) >= w if and only if f >= firmware(w).
#pragma once

#include "hal/board/sim_time.h"

namespace robosim::exec {

class FirmwareClock {
 public:
  /// Makes the firmware's clock too fast by `ppm` parts per million, from the time `world` on. The clock does
  /// not jump.
  void drift(int ppm, SimTime world) {
    firmware_0_ = to_firmware(world);
    world_0_ = world;
    rate_ = kMillion + ppm;
  }

  SimTime to_firmware(SimTime world) const {
    if (rate_ == kMillion) return shifted(world, firmware_0_ - world_0_);
    if (world == kNever) return kNever;
    const SimTime d = world - world_0_;
    return firmware_0_ + d / kMillion * rate_ + (d % kMillion * rate_ + kMillion - 1) / kMillion;
  }
  /// Converts to the world's time. Inline, since it is called several times in each tick.
  [[gnu::always_inline]] SimTime to_world(SimTime firmware) const {
    if (rate_ == kMillion) return shifted(firmware, world_0_ - firmware_0_);
    if (firmware == kNever) return kNever;
    const SimTime d = firmware - firmware_0_;
    return world_0_ + d / rate_ * kMillion + d % rate_ * kMillion / rate_;
  }

 private:
  static constexpr SimTime kMillion = 1'000'000;
  static SimTime shifted(SimTime t, SimTime by) { return t == kNever ? kNever : t + by; }

  SimTime rate_ = kMillion;  // nanoseconds of the firmware's clock in a millisecond of the world
  SimTime world_0_ = 0;
  SimTime firmware_0_ = 0;
};

}  // namespace robosim::exec
