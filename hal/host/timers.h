// Timers 0, 1 and 2 (datasheet, chapters 15, 16 and 18): counters that are computed when somebody looks.
//
//   single slope (normal, CTC, fast PWM):  period TOP + 1 ticks, count = position
//   dual slope (phase correct PWM):        period 2 TOP ticks,   count = position, or 2 TOP - position on the
//   way down
//
// A tick is `prescaler` CPU cycles. Not modelled: input capture, external clocks, double buffering of OCR.
#pragma once

#include <stdint.h>

#include "hal/board/board.h"

namespace robosim {
namespace host {

class Timer {
 public:
  enum Flag : uint8_t { overflow = 1, compare_a = 2, compare_b = 4 };  ///< bits of TIFRn and TIMSKn

  constexpr explicit Timer(uint8_t number) : number_(number) {}

  uint8_t control_a() const { return control_a_; }
  uint8_t control_b() const { return control_b_; }
  uint16_t compare(int channel) const { return compare_[channel]; }
  uint16_t capture() const { return capture_; }
  uint8_t enabled() const { return enabled_; }
  uint8_t flags() const { return flags_; }
  uint16_t count() const;

  void set_control_a(uint8_t value);
  void set_control_b(uint8_t value);
  void set_compare(int channel, uint16_t value);
  void set_capture(uint16_t value);
  void set_count(uint16_t value);
  void set_enabled(uint8_t mask) { enabled_ = mask; }
  void clear_flags(uint8_t mask) { flags_ &= ~mask; }

  /// Raises the flags of what has happened until now.
  void sync();
  /// When the next flag in `mask` will be raised; kNever if none.
  SimTime next(uint8_t mask) const;

  /// The COM bits of channel 0 (A) or 1 (B): 0 = the pin belongs to the port.
  uint8_t connection(int channel) const { return control_a_ >> (channel == 0 ? 6 : 4) & 3; }
  /// Sets them; the caller refreshes the pin.
  void set_connection(int channel, uint8_t bits);
  /// How a connected channel drives its pin.
  PinDrive drive(int channel) const;

  /// Whether the counter runs as init() sets Timer 0: 0..255, one slope.
  bool counts_bytes() const { return !dual_ && top_ == 255 && prescaler_ != 0; }
  /// The moment `ticks` timer ticks after the present count began.
  SimTime ticks_from_now(int64_t ticks) const;
  /// Counts overflows until now, without raising the flag for them.
  int64_t take_overflows();

 private:
  template <typename Change>
  void reconfigure(Change change);
  void decode();
  int64_t position() const;
  int64_t ticks() const;
  SimTime time_of(int64_t tick) const;
  bool passed(int64_t event, int64_t until) const;
  /// Positions at which compare match `channel` happens; returns how many there are, 0..2.
  int matches(int channel, int64_t (&at)[2]) const;
  uint16_t counter_max() const { return number_ == 1 ? 0xFFFF : 0xFF; }

  uint8_t number_;
  uint8_t control_a_ = 0, control_b_ = 0, enabled_ = 0, flags_ = 0;
  uint16_t compare_[2] = {0, 0};
  uint16_t capture_ = 0;
  // What the registers mean:
  enum class Kind : uint8_t { normal, clear_on_match, pwm };
  Kind kind_ = Kind::normal;
  bool dual_ = false;
  int32_t prescaler_ = 0;  ///< 0 = stopped
  int64_t top_ = 0xFF;
  int64_t period_ = 0x100;
  // The counter: tick `base_tick_` began at `base_`; flags are up to date to `synced_`.
  SimTime base_ = 0;
  int64_t base_tick_ = 0;
  int64_t synced_ = 0;
};

extern Timer timer0, timer1, timer2;
inline Timer& timer(int number) { return number == 0 ? timer0 : number == 1 ? timer1 : timer2; }

/// Does in one go what the overflow handler of Timer 0 would have done since it ran last. For firmware that
/// waits.
void timer0_catch_up();
/// What millis() returns, and the overflows that micros() counts.
extern uint64_t timer0_millis;
extern uint64_t timer0_overflows;
/// At a reset.
void reset_timers();

}  // namespace host
}  // namespace robosim
