// Many events in one line: what happens hundreds of times in a simulated second would, as JSON lines of its
// own, take several times as long as the run.
//
// One behind the other, each begins with a byte that says what it is, a byte with the robot's number, and
// eight with its time. Numbers are little-endian, doubles as IEEE 754 has them; a pin's name is a byte with
// its length, and its characters.
//
//   's'  (t_us) x, y, yaw, speed, cross_track, left, right, the wheels' two: doubles; how many readings (two
//        bytes), and each of them, a double
//   'p'  (t_ns) the pin; a byte 0 input, 1 input_pullup, 2 output; a byte, 1 high + 2 PWM; duty, a double;
//        tone_hz (four bytes)
//   'l'  (t_ns) the pin; a byte, 0 or 1
//   'v'  (t_ns) the pin; volts, a double
//   'b'  (t_ns) the byte; a byte, 1 sent by the firmware, 0 received
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "sim/wire/stream.h"

namespace robosim::wire {

/// Packs events.
class BatchWriter {
 public:
  /// False for what has no place in a batch: another kind of event, or one with more to say.
  bool add(const Event& event);
  std::size_t size() const { return bytes_.size(); }
  /// Of the first event that waits, and of the last.
  std::int64_t since_ns() const { return since_ns_; }
  std::int64_t latest_ns() const { return latest_ns_; }
  /// What waits; then nothing does.
  Batch take();

 private:
  std::string bytes_;
  std::int64_t since_ns_ = 0, latest_ns_ = 0;
};

/// The events that were packed, in their order. Throws RunnerError for what is no batch; by then it may have
/// told some.
void unpack(const Batch& batch, const OnEvent& on_event);

}  // namespace robosim::wire
