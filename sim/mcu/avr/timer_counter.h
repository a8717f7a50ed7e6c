// Models the counter of a timer, tick by tick (ATmega328P data sheet DS40002061B, 15.4 to 15.8, 16.4 to
// 16.10, 18.4 to 18.7).
//
//   MAX     0xFF, or 0xFFFF
//   TOP     value at which the counter turns or restarts: fixed, OCRnA or ICRn
//   BOTTOM  0
//
// Each event happens at the tick at which the counter leaves a value (figures 15-8 to 15-11, 16-10 to 16-13):
//
//   leaves      in mode          event
//   OCRnx       all              match: OCFnx is set, and the pin changes
//   TOP         clear on match   restart at 0
//   TOP         fast PWM         restart at 0, TOV is set, OCRnx are latched
//   TOP         phase correct    turn, OCRnx are latched; phase and frequency correct: only turn
//   TOP = ICRn  all              ICF is set
//   BOTTOM      dual slope       turn, TOV is set; phase and frequency correct: OCRnx are latched
//   MAX         all              restart at 0; TOV is set in normal and clear-on-match mode
//
// If a new TOP is below the counter, the counter runs on to MAX. A TOP of 0 keeps a dual-slope counter at 0.
//
// After a write to TCNTn, the comparators ignore the value at the next tick: there is no match, no TOP from
// OCRnA or ICRn, and no turn at BOTTOM while counting down (15.5.3, 16.7.3).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "hal/board/avr_timer.h"
#include "sim/mcu/avr/cycle.h"

namespace robosim::avr {

class Counter {
 public:
  /// The events of a tick. All except kTakenOver are encoded like the bits of TIFRn. kTakenOver reports that
  /// values written to OCRnx took effect.
  enum Hit : std::uint8_t {
    kOverflow = 0x01,
    kMatchA = 0x02,
    kMatchB = 0x04,
    kMatchC = 0x08,
    kTop = 0x20,
    kTakenOver = 0x80
  };
  static constexpr std::array<std::uint8_t, 3> kMatch{kMatchA, kMatchB, kMatchC};

  std::uint16_t value() const { return value_; }
  const Counting& how() const { return how_; }
  bool counts_down() const { return down_; }
  std::uint16_t top() const { return static_cast<std::uint16_t>(top_of(how_, compare_[0], capture_)); }
  /// Returns the effective compare value. A value written to OCRnx may still be pending.
  std::uint16_t compare(std::size_t channel) const { return compare_[channel]; }
  bool waits() const {
    return compare_[0] != written_[0] || compare_[1] != written_[1] || compare_[2] != written_[2];
  }
  std::uint16_t capture() const { return capture_; }

  /// Sets the counting mode; `channels` is the number of OCRnx registers.
  void count(const Counting& how, std::uint16_t max, std::uint8_t channels = 2);
  void set_value(std::uint16_t value) {
    value_ = value;
    hidden_ = true;
  }
  void write_compare(std::size_t channel, std::uint16_t value);
  void set_capture(std::uint16_t value) { capture_ = value; }

  /// Advances by `ticks`. Returns the events, as a sum of Hit.
  std::uint8_t advance(Cycle ticks);
  // Returns whether the counter is in the usual state: it counts up to TOP and restarts, and no written value
  // is pending.
  bool is_regular() const { return !how_.dual_slope && !hidden_ && !waits() && value_ <= top(); }
  /// Advances a regular counter whose events have no listener.
  void pass(Cycle ticks) {
    const Cycle period = top() + Cycle{1}, value = value_ + ticks;
    value_ = static_cast<std::uint16_t>(value < period       ? value
                                        : value < 2 * period ? value - period
                                                             : value % period);
  }
  /// Returns the number of matches of a channel in `ticks`.
  Cycle matches(std::size_t channel, Cycle ticks) const;
  /// Returns the events of the next tick, without advancing.
  std::uint8_t next_hits() const;
  /// Returns the number of ticks (at least 1) to the next event in `wanted`; kNoCycle = never.
  Cycle ticks_to(std::uint8_t wanted) const;
  /// Returns a number of ticks during which the counter certainly counts up by one per tick.
  Cycle ticks_upwards() const { return down_ ? 0 : straight(); }

 private:
  struct Ran {
    Cycle ticks = 0;
    std::uint8_t hits = 0;
  };
  static constexpr int kManyTurns = std::numeric_limits<int>::max();

  /// Runs until an event in `wanted`, for at most `most` ticks, and at most `turns` turns or restarts.
  Ran run(Cycle most, std::uint8_t wanted, int turns);
  /// Advances a regular counter by at most one period, with the same result as run().
  std::uint8_t advance_regularly(unsigned ticks);
  std::uint8_t hits_at_end() const;
  std::uint8_t tick();
  std::uint16_t straight() const;
  std::uint8_t take_over();

  Counting how_;
  std::uint16_t max_ = 0xFF;
  std::uint16_t value_ = 0;
  std::uint8_t channels_ = 2;
  std::array<std::uint16_t, 3> compare_{}, written_{};
  std::uint16_t capture_ = 0;
  bool down_ = false;
  bool hidden_ = false;  ///< TCNTn was written since the last tick
};

}  // namespace robosim::avr
