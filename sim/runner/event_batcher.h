// Collects the frequent events of a run, and passes them to a listener in batches (wire/batch.h). The order
// of all events stays the same.
#pragma once

#include <cstdint>
#include <functional>
#include <utility>

#include "hal/board/board.h"
#include "hal/board/sim_time.h"
#include "sim/run/simulation.h"
#include "sim/wire/batch.h"

namespace robosim::runner {

/// Receives events.
using Tell = std::function<void(wire::Event)>;

/// Batches that another process reads from shared memory. If `first` is null, there is no shared memory, and
/// Tell receives the batches.
struct SharedBatches {
  wire::BatchMemory* first = nullptr;
  /// Hands the present batch to the other process. Returns the next batch, which is empty.
  std::function<wire::BatchMemory*()> hand_on = {};
};

class EventBatcher {
 public:
  explicit EventBatcher(Tell tell, SharedBatches shared = {})
      : tell_(std::move(tell)), hand_on_(std::move(shared.hand_on)), waiting_(shared.first) {}
  void tell(wire::Event event);
  // Variants of tell() for the most frequent events.
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
  /// Returns whether an event of this pin at `t` can be appended without a record of its time or name.
  bool follows(int agent, SimTime t, Pin pin) const { return waiting_.follows(agent, t, pin); }
  /// Announces that the robot's pin events will have source lines.
  void sources(int agent) { waiting_.add_sources(agent); }
  void source(int agent, const result::SourceLine& line) { waiting_.add_source(agent, line); }
  /// Passes on all waiting events.
  void flush();

 private:
  /// The longest delay of an event, in simulated time. The limit lets an observer of a slow run see progress.
  /// Each flush costs as much as a few hundred events.
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
