// Couples simulated time to wall time for a viewer. A run's result never depends on the pacing.
#pragma once

#include <algorithm>
#include <cstdint>

namespace robosim::terminal {

/// Both clocks count microseconds. The wall clock's origin does not matter.
class Pacer {
 public:
  /// `speed` is in simulated seconds per second of wall time; 0 = as fast as possible.
  explicit Pacer(double speed) : speed_(speed) {}

  double speed() const { return speed_; }
  bool paused() const { return paused_; }

  /// Returns the wall time to wait until `sim_us` is due; 0 = due now.
  std::int64_t wait_us(std::int64_t sim_us, std::int64_t wall_us) {
    if (speed_ <= 0.0) return 0;
    if (!running_) start(sim_us, wall_us);
    const double due =
        static_cast<double>(sim_us - sim_origin_) / speed_ - static_cast<double>(wall_us - wall_origin_);
    // A viewer that is too slow does not catch up later.
    if (due < -kLate_us) start(sim_us, wall_us);
    return due <= 0.0 ? 0 : static_cast<std::int64_t>(due);
  }

  void set_speed(double speed) {
    speed_ = speed;
    running_ = false;
  }
  /// Steps through 1/16 … 64 by factors of two. The step after 64 is "as fast as possible".
  void faster() { set_speed(speed_ <= 0.0 || speed_ * 2.0 > kFastest ? 0.0 : speed_ * 2.0); }
  void slower() { set_speed(speed_ <= 0.0 ? kFastest : std::max(speed_ / 2.0, kSlowest)); }
  void set_paused(bool paused) {
    paused_ = paused;
    running_ = false;
  }

 private:
  static constexpr double kSlowest = 1.0 / 16.0;
  static constexpr double kFastest = 64.0;
  static constexpr double kLate_us = 100'000.0;

  void start(std::int64_t sim_us, std::int64_t wall_us) {
    sim_origin_ = sim_us;
    wall_origin_ = wall_us;
    running_ = true;
  }

  double speed_;
  bool paused_ = false;
  bool running_ = false;
  std::int64_t sim_origin_ = 0, wall_origin_ = 0;
};

}  // namespace robosim::terminal
