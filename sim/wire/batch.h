// Many events at once: what happens hundreds of times in a simulated second would, as JSON lines of its own,
// take several times as long as the run.
//
// One behind the other, each begins with a byte that says what it is, a byte with the robot's number, and
// eight with its time. Numbers are little-endian, doubles as IEEE 754 has them; a name is a byte with its
// length, and its characters.
//
//   's'  (t_us) x, y, yaw, speed, cross_track, left, right, the wheels' two: doubles; how many readings (two
//        bytes), and each of them, a double
//   'p'  (t_ns) the pin; a byte 0 input, 1 input_pullup, 2 output; a byte, 1 high + 2 PWM; duty, a double;
//        tone_hz (four bytes)
//   'l'  (t_ns) the pin; a byte, 0 or 1
//   'v'  (t_ns) the pin; volts, a double
//   'b'  (t_ns) the byte; a byte, 1 sent by the firmware, 0 received
//   'c'  (0) columns: how many new sources (two bytes), of each the names of function and file and the line
//        (four bytes); how many streams (two bytes), of each its name, its count of rows (eight bytes), how
//        many columns it has (two bytes), a byte: 1 if their specs follow, each a name, the scale, a double,
//        and a byte for the order; and of each column how many bytes (four) and these
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "sim/wire/stream.h"

namespace robosim::wire {

/// Packs events.
class BatchWriter {
 public:
  /// False for what has no place in a batch: another kind of event, or one with more to say.
  bool add(const Event& event);
  bool add(const Sample& sample);
  bool add(const Columns& columns);
  /// The same as PinChange, LevelSeen, VoltsSeen and SerialByte without `source`. `mode`: 0 input, 1
  /// input_pullup, 2 output. The robot's number must be less than kMostAgents, a name no longer than
  /// kMostName.
  void add_pin(int agent, std::int64_t t_ns, std::string_view pin, int mode, bool level, bool pwm,
               double duty, std::uint32_t tone_hz);
  void add_level(int agent, std::int64_t t_ns, std::string_view pin, bool level);
  void add_volts(int agent, std::int64_t t_ns, std::string_view pin, double volts);
  void add_byte(int agent, std::int64_t t_ns, std::uint8_t value, bool sent);
  static constexpr std::size_t kMostName = 255;

  std::size_t size() const { return bytes_.size(); }
  /// Of the first event that waits, and of the last; columns have no time.
  std::int64_t since_ns() const { return since_ns_; }
  std::int64_t latest_ns() const { return latest_ns_; }
  /// What waits; then nothing does.
  Batch take();

 private:
  void happened(std::int64_t t_ns);

  std::string bytes_;
  std::int64_t since_ns_ = 0, latest_ns_ = 0;
};

/// The events that were packed, in their order. Throws RunnerError for what is no batch; by then it may have
/// told some.
void unpack(std::string_view bytes, const OnEvent& on_event);

}  // namespace robosim::wire
