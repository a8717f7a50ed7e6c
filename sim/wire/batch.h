// Packs many events into one binary batch. Some events occur hundreds of times per simulated second. Writing
// them as one JSON line each would take several times as long as the run.
//
// A batch is a sequence of events. Each begins with eight bytes: kind, robot's number, pin's number, a byte
// `other`, and a signed number of four bytes. Unless noted below, this number is the time in nanoseconds
// since the previous event that has a time, starting at 0. Numbers are little-endian; doubles are IEEE 754.
//
//   't'  base of the next event's time, in nanoseconds (eight bytes); robot, pin and the rest are 0
//   'n'  a pin's name, of length `other`; precedes the pin's first event in each batch
//   's'  a sample; the number is the count of readings. Then t_us (eight bytes), and as doubles x, y, yaw,
//        speed, cross_track, left, right, both wheels, and the readings. If `other` is 1, sine and cosine
//        of the yaw replace the yaw
//   'p'  a pin; `other` is 0 for input, 1 for input_pullup or 2 for output, plus 4 if high, 8 with PWM, 16
//        with a tone, 32 with a source. Then the duty cycle (a double), the frequency of the tone, if any,
//        and the number of the source, if any (four bytes each)
//   'l'  a level that was read; `other` is 0 or 1
//   'v'  volts that were read, a double
//   'b'  a serial byte, which replaces the pin's number; `other` is 1 if the firmware sent it, else 0
//   'd'  announces that the robot's pin events have sources (lines of the sketch); precedes everything else
//   'c'  a source, numbered from 1; the pin's number is the length of the function's name, `other` is the
//        length of the file's name, and the number is the line. Then the two names
//
// Batches carry no columns (columns.h). If a caller requests batches and columns, BatchReader computes the
// columns.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/wire/run_columns.h"
#include "sim/wire/run_request.h"
#include "sim/wire/stream.h"

namespace robosim::wire {

/// Returns whether all frequent events that the request subscribes to come in batches.
bool comes_in_batches(const RunRequest& request);

/// Memory for waiting events. Two processes may share it, so that it survives the writer's process.
struct BatchMemory {
  static constexpr std::size_t kRoom_bytes = 65'536;
  std::atomic<std::uint32_t> used{0};
  char bytes[kRoom_bytes];
};

/// Packs events.
class BatchWriter {
 public:
  static constexpr std::size_t kMostName = 255;
  /// The largest number of used bytes with which one more event certainly fits.
  static constexpr std::size_t kFull_bytes = BatchMemory::kRoom_bytes - 16'384;

  static constexpr int kHigh = 4, kPwm = 8, kTone = 16, kSource = 32;  ///< bits of `other` in a 'p'

  struct Head {
    char kind;
    std::uint8_t agent, pin, other;
    std::int32_t number;
  };
  static_assert(sizeof(Head) == 8);

  explicit BatchWriter(BatchMemory* memory = nullptr)
      : own_(memory ? nullptr : new BatchMemory), memory_(memory ? memory : own_.get()) {}

  /// Adds an event. Returns false if the event is not a sample or byte, or is too long for a batch.
  bool add(const Event& event);
  bool add(const Sample& sample);
  /// Adds a sample with a heading, from which the reader computes the yaw. `numbers` contains a Sample's x,
  /// y, sine and cosine of the yaw, speed, cross-track error, motors and wheels.
  bool add_sample(int agent, std::int64_t t_us, const std::array<double, 10>& numbers,
                  const std::vector<double>& readings) {
    return add_sample(agent, t_us, kWithHeading, numbers, readings);
  }
  /// Adds a PinChange, LevelSeen, VoltsSeen or SerialByte. `pin` is any number that identifies the pin within
  /// its robot. `mode` is 0 for input, 1 for input_pullup, 2 for output. `source` is a source's number, 0 =
  /// none. `agent` must be less than kMostAgents. A name must have at most kMostName bytes.
  void add_pin(int agent, std::int64_t t_ns, std::uint8_t pin, const char* name, int mode, bool level,
               bool pwm, double duty, std::uint32_t tone_hz, int source = 0) {
    begin_at_pin(agent, t_ns, pin, name);
    const int flags = mode | (level ? kHigh : 0) | (pwm ? kPwm : 0) | (tone_hz != 0 ? kTone : 0) |
                      (source != 0 ? kSource : 0);
    BatchMemory& memory = *memory_;
    char* to = put(put_head(at(memory), 'p', agent, pin, flags, step_to(t_ns)), duty);
    if (tone_hz != 0) to = put(to, tone_hz);
    if (source != 0) to = put(to, static_cast<std::uint32_t>(source));
    end(memory, to);
  }
  void add_level(int agent, std::int64_t t_ns, std::uint8_t pin, const char* name, bool level) {
    begin_at_pin(agent, t_ns, pin, name);
    BatchMemory& memory = *memory_;
    end(memory, put_head(at(memory), 'l', agent, pin, level, step_to(t_ns)));
  }
  void add_volts(int agent, std::int64_t t_ns, std::uint8_t pin, const char* name, double volts) {
    begin_at_pin(agent, t_ns, pin, name);
    BatchMemory& memory = *memory_;
    end(memory, put(put_head(at(memory), 'v', agent, pin, 0, step_to(t_ns)), volts));
  }
  void add_byte(int agent, std::int64_t t_ns, std::uint8_t value, bool sent);
  /// Returns whether an event of `pin` at `t_ns` needs neither a 't' nor an 'n' before it. Most events need
  /// neither.
  bool follows(int agent, std::int64_t t_ns, std::uint8_t pin) const {
    return is_named(number_of(agent, pin)) && is_near(t_ns);
  }
  /// Announces that the robot's pin events will have sources, which are lines of the sketch.
  void add_sources(int agent);
  /// Adds the robot's next source. Names are truncated to kMostName bytes.
  void add_source(int agent, const SourceLine& line);

  std::size_t size() const { return memory_->used.load(std::memory_order_relaxed); }
  /// Returns the time of the last event.
  std::int64_t latest_ns() const { return latest_ns_; }
  /// Returns and clears the waiting events.
  Batch take();
  /// Leaves the waiting events in place for another reader. The next batch is made in `memory`, which must be
  /// empty.
  void go_on_in(BatchMemory& memory) {
    memory_ = &memory;
    begin_batch();
  }

 private:
  static constexpr int kWithYaw = 0, kWithHeading = 1;
  template <std::size_t N>
  bool add_sample(int agent, std::int64_t t_us, int heading, const std::array<double, N>& numbers,
                  const std::vector<double>& readings);
  void begin_batch() {
    from_ns_ = 0;
    ++batch_;
  }
  template <class T>
  static char* put(char* to, const T& value) {
    std::memcpy(to, &value, sizeof value);
    return to + sizeof value;
  }
  static char* put(char* to, std::string_view text) {
    if (!text.empty()) std::memcpy(to, text.data(), text.size());
    return to + text.size();
  }
  static char* put_head(char* to, char kind, int agent, std::uint8_t pin, int other, std::int32_t number) {
    return put(to,
               Head{kind, static_cast<std::uint8_t>(agent), pin, static_cast<std::uint8_t>(other), number});
  }
  // Accesses a memory through a local reference. Otherwise the compiler must assume that a write into the
  // memory changes memory_ itself.
  static char* at(BatchMemory& memory) { return memory.bytes + memory.used.load(std::memory_order_relaxed); }
  static void end(BatchMemory& memory, const char* end) {
    memory.used.store(static_cast<std::uint32_t>(end - memory.bytes), std::memory_order_release);
  }
  char* at() { return at(*memory_); }
  void end(const char* to) { end(*memory_, to); }
  void begin_at_pin(int agent, std::int64_t t_ns, std::uint8_t pin, const char* name) {
    const std::size_t number = number_of(agent, pin);
    if (!is_named(number)) name_pin(number, name);
    begin_at(t_ns);
  }
  void begin_at(std::int64_t t_ns) {
    if (!is_near(t_ns)) count_from(t_ns);
  }
  static std::size_t number_of(int agent, std::uint8_t pin) {
    return static_cast<std::size_t>(agent) << 8 | pin;
  }
  bool is_named(std::size_t number) const { return number < named_in_.size() && named_in_[number] == batch_; }
  bool is_near(std::int64_t t_ns) const {
    const std::int64_t step = t_ns - from_ns_;
    return step == static_cast<std::int32_t>(step);
  }
  std::int32_t step_to(std::int64_t t_ns) {
    const auto step = static_cast<std::int32_t>(t_ns - from_ns_);
    from_ns_ = latest_ns_ = t_ns;
    return step;
  }
  void name_pin(std::size_t number, const char* name);
  void count_from(std::int64_t t_ns);

  std::unique_ptr<BatchMemory> own_;
  BatchMemory* memory_;
  std::int64_t from_ns_ = 0, latest_ns_ = 0;
  std::vector<std::uint32_t> named_in_;  ///< per robot and pin: last batch that contains the pin's name
  std::uint32_t batch_ = 1;
};

/// Reads a run's batches.
class BatchReader {
 public:
  explicit BatchReader(const RunRequest& request);
  BatchReader(BatchReader&&) noexcept;
  BatchReader& operator=(BatchReader&&) noexcept;
  ~BatchReader();

  /// Prepares for a robot's events. Must be called for each robot.
  void begin(const Started& started);
  /// Reports the packed events in their order, if the request subscribes to them. Also reports columns every
  /// kColumnsEvery_ns. Throws RunnerError for an invalid batch, possibly after it has reported some events.
  void read(std::string_view bytes, const OnEvent& on_event);
  /// Reports the waiting columns.
  void finish(const OnEvent& on_event);

 private:
  class Unpacker;
  struct Robot;

  Robot& robot(int agent);
  void tell_columns(int agent, const OnEvent& on_event);

  bool tells_pins_, tells_inputs_;
  std::int64_t samples_every_us_, columns_every_us_;
  std::vector<std::unique_ptr<Robot>> robots_;
};

}  // namespace robosim::wire
