// The prescalers of the timers, and GTCCR that resets them to 0. ATmega328P data sheet DS40002061B: 17,
// 18.10, 18.11.9.
//
//   timers 0, 1   a shared one (PSRSYNC)
//   timer 2       its own (PSRASY); on an ATtiny85, timer 1 (PSR1)
//
// They run freely from the reset on, whatever the timers do. A timer that divides by N ticks when its
// prescaler's count is a multiple of N. So its first tick comes 1 to N cycles after its start. TSM holds
// prescalers at 0 while they are being reset. A timer that divides by 1 bypasses the prescaler. They stop in
// the sleep modes without an I/O clock.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "sim/avr/core.h"

namespace robosim::avr {

class Timer;

class Prescalers final : public Peripheral {
 public:
  enum Which : std::uint8_t { kShared, kOwn };

  explicit Prescalers(Core& core);
  /// Adds a timer, which is called before and after a prescaler is set.
  void add(Timer& timer) { timers_.push_back(&timer); }

  void reset(Cycle at) override;
  void clock_runs(bool runs, Cycle at) override;

  /// Returns a cycle at which the count was 0.
  Cycle began(Which which) const { return state_.began[which]; }
  bool is_held(Which which) const { return state_.held[which]; }

 private:
  struct State {
    std::array<Cycle, 2> began{};
    std::array<bool, 2> held{};
    Cycle stopped = 0;
  };

  void write(Address address, std::uint8_t value);

  Core& core_;
  std::vector<Timer*> timers_;
  State state_;
};

}  // namespace robosim::avr
