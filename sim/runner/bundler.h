// Between who tells what happens in a run and who hears it: what there is much of goes on many at a time
// (wire/batch.h), and in its order with all else.
#pragma once

#include <cstdint>
#include <functional>
#include <utility>

#include "hal/board/board.h"
#include "hal/board/sim_time.h"
#include "sim/run/simulation.h"
#include "sim/wire/batch.h"

namespace robosim::runner {

/// Who hears of what happens.
using Tell = std::function<void(wire::Event)>;

/// Where events wait that another process reads from there. Empty = nobody does: they are told.
struct SharedBatches {
  wire::BatchMemory* first = nullptr;
  /// What waits in the last one goes on; gives the next, which is empty.
  std::function<wire::BatchMemory*()> hand_on = {};
};

class Bundler {
 public:
  explicit Bundler(Tell tell, SharedBatches shared = {})
      : tell_(std::move(tell)), hand_on_(std::move(shared.hand_on)), waiting_(shared.first) {}
  void tell(wire::Event event);
  // The same as events; these there are most of.
  void sample(int agent, const run::Sample& sample);
  void pin(int agent, SimTime t, Pin pin, const char* name, const PinDrive& drive, int source) {
    waiting_.add_pin(agent, t, pin, name, static_cast<int>(drive.mode), drive.level, drive.pwm, drive.duty,
                     drive.tone_hz, source);
    look();
  }
  void level(int agent, SimTime t, Pin pin, const char* name, bool level) {
    waiting_.add_level(agent, t, pin, name, level);
    look();
  }
  void volts(int agent, SimTime t, Pin pin, const char* name, double volts) {
    waiting_.add_volts(agent, t, pin, name, volts);
    look();
  }
  /// Whether one of these three, of that pin at that time, can go on behind what waits as it is.
  bool follows(int agent, SimTime t, Pin pin) const { return waiting_.follows(agent, t, pin); }
  /// Pins of the robot will have sources, and one of these.
  void sources(int agent) { waiting_.add_sources(agent); }
  void source(int agent, const wire::SourceLine& line) { waiting_.add_source(agent, line); }
  /// Tells what waits.
  void flush();

 private:
  /// How late an event may be: for who watches a slow run. Each time costs as much as some hundred events.
  static constexpr SimTime kLongest = 1 * kSecond;

  [[gnu::always_inline]] void look() {
    if (waiting_.size() >= wire::BatchWriter::kFull_bytes || waiting_.latest_ns() - flushed_ns_ >= kLongest)
      flush();
  }

  Tell tell_;
  std::function<wire::BatchMemory*()> hand_on_;
  wire::BatchWriter waiting_;
  SimTime flushed_ns_ = 0;
};

}  // namespace robosim::runner
