// Models the timers' prescalers, and GTCCR, which resets them to 0 (ATmega328P data sheet DS40002061B, 17,
// 18.10, 18.11.9).
//
//   timers 0, 1   share a prescaler (PSRSYNC)
//   timer 2       has its own prescaler (PSRASY); on an ATtiny85, timer 1 has its own (PSR1)
//
// Prescalers run freely from the reset on, independently of the timers. A timer with divisor N has a tick
// whenever its prescaler's count is a multiple of N. The timer's first tick therefore comes 1 to N cycles
// after its start. While TSM is set, a prescaler whose reset bit is also set stays at 0. A timer with divisor
// 1 bypasses the prescaler. Prescalers stop in sleep modes without an I/O clock.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "sim/mcu/avr/core.h"

namespace robosim::avr {

class Timer;

class Prescalers final : public Peripheral {
 public:
  enum Which : std::uint8_t { kShared, kOwn };

  explicit Prescalers(Core& core);
  /// Adds a timer, which is updated before and after each change of a prescaler.
  void add(Timer& timer) { timers_.push_back(&timer); }

  void reset(Cycle at) override;
  void clock_runs(bool runs, Cycle at) override;

  /// Returns a cycle at which the prescaler's count was 0.
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
