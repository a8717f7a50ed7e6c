// Records how a sketch used each pin in a run, from the run's events.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "hal/board/board_spec.h"
#include "sim/wire/messages.h"

namespace robosim::wiring {

struct PinFacts {
  bool driven = false;        ///< used as an output
  bool pwm = false;           ///< driven with analogWrite
  bool toned = false;         ///< driven with tone()
  bool looked = false;        ///< read with digitalRead or by an interrupt's edge, as an input
  bool looked_along = false;  ///< read together with other pins of its port, as a chip's digitalRead() does
  bool measured = false;      ///< read with the ADC
  bool pulled_up = false;     ///< the pull-up was on
  bool discharged = false;    ///< driven HIGH, then read: the timing of RC sensors
  bool pulses = false;        ///< driven LOW, HIGH, LOW within 3 ms: a trigger, a servo
};

/// The use of each pin by a sketch, in one or more runs.
class PinHistory {
 public:
  explicit PinHistory(const BoardSpec& board) : board_(board), facts_(board.pin_count) {}

  /// Begins another run. Keeps the facts about pins, but clears the recorded duty cycles.
  void begin();
  void add(const wire::Event& event);
  /// Ends a run of duration `t_ns`.
  void end(std::int64_t t_ns);

  const PinFacts& of(Pin pin) const { return facts_[pin]; }

  /// Returns the mean over the run of (duty of `high` - duty of `low`) x duty of `enable`. With kNoPin, `low`
  /// has duty 0.5, and `enable` has duty 1. A result above 0 means that `high` was mostly higher.
  double lean(Pin enable, Pin high, Pin low) const { return mean(enable, high, low, false); }
  /// Returns the mean of the absolute values of what lean() averages. Equals |lean()| only if the motor
  /// never turns back.
  double effort(Pin enable, Pin high, Pin low) const { return mean(enable, high, low, true); }

 private:
  struct Change {
    std::int64_t t_ns;
    Pin pin;
    double duty;  // share of the time at which the pin is high; 0 or 1 for a level
  };

  double mean(Pin enable, Pin high, Pin low, bool absolute) const;
  /// Records the pins that were read at the same time.
  void settle_reads();

  const BoardSpec& board_;
  std::vector<PinFacts> facts_;
  std::vector<Pin> read_together_;  ///< the pins that were read at read_ns_
  std::int64_t read_ns_ = -1;
  std::vector<Change> changes_;
  std::map<Pin, std::int64_t> raised_, lowered_;
  std::int64_t end_ns_ = 0;
};

}  // namespace robosim::wiring
