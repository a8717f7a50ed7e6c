// Records how a sketch used each pin in a run, from the run's events.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "hal/board/board_spec.h"
#include "sim/wire/messages.h"

namespace robosim::wiring {

struct PinFacts {
  bool driven = false;      ///< as an output
  bool pwm = false;         ///< by analogWrite
  bool toned = false;       ///< by tone()
  bool looked = false;      ///< digitalRead, or an interrupt's edge, as an input
  bool measured = false;    ///< by the ADC
  bool pulled_up = false;   ///< its pull-up was on
  bool discharged = false;  ///< driven HIGH, then read: the timing of RC sensors
  bool pulses = false;      ///< driven LOW, HIGH, LOW within 3 ms: a trigger, a servo
};

/// The use of each pin by a sketch in one run or several.
class PinHistory {
 public:
  explicit PinHistory(const BoardSpec& board) : board_(board), facts_(board.pin_count) {}

  /// Begins another run. Facts about a pin are retained, but its drive is that of the last run.
  void begin();
  void add(const wire::Event& event);
  /// Ends a run of that duration.
  void end(std::int64_t t_ns);

  const PinFacts& of(Pin pin) const { return facts_[pin]; }

  /// Returns the share of the run in which `high` was higher than `low` (kNoPin = than nothing), less the
  /// share of the opposite. It is weighted by the duty cycle of `enable` (kNoPin = always). Above 0 = mostly
  /// so.
  double lean(Pin enable, Pin high, Pin low) const;

 private:
  struct Change {
    std::int64_t t_ns;
    Pin pin;
    double duty;  // share of the time at high; a level is 0 or 1
  };

  const BoardSpec& board_;
  std::vector<PinFacts> facts_;
  std::vector<Change> changes_;
  std::map<Pin, std::int64_t> raised_, lowered_;
  std::int64_t end_ns_ = 0;
};

}  // namespace robosim::wiring
