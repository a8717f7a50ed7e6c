// Models timers 0, 1 and 2 on the host (data sheet, chapters 15, 16 and 18). Counts are computed when they
// are read.
//
//   single slope (normal, CTC, fast PWM):  period TOP + 1 ticks, count = position
//   dual slope (phase correct PWM):        period 2 TOP ticks,   count = position, then 2 TOP - position
//
// A tick is `prescaler` CPU cycles. With PWM, a new compare value takes effect with the tick that leaves TOP
// (BOTTOM in frequency correct modes). If TOP changes, or drops below the count, the counter deviates from
// these formulas. The end of the deviation is called a turn (timer_turns.cpp). timer_capture.cpp captures
// edges of ICP1.
#pragma once

#include <stdint.h>

#include "hal/board/avr_timer.h"
#include "hal/board/board.h"
#include "hal/host/clock.h"

namespace robosim {
namespace host ROBOSIM_WITHIN {

class Timer {
 public:
  enum Flag : uint8_t {
    overflow = kTov,
    compare_a = kOcfa,
    compare_b = kOcfb,
    captured = kIcf
  };  ///< bits of TIFRn and TIMSKn

  constexpr explicit Timer(uint8_t number)
      : number_(number),
        max_(kChip.timers[number].bits == 16 ? 0xFFFF : 0xFF),
        flag_count_(kChip.timers[number].capture != 0 ? 4 : 3),
        counting_(avr::counting(kChip.timers[number], 0, 0)),
        top_(counting_.fixed_top),
        period_(top_ + 1) {}

  /// Returns whether the timer has 16 bits.
  bool is_wide() const { return max_ > 0xFF; }
  uint8_t control_a() const { return control_a_; }
  uint8_t control_b() const { return control_b_; }
  uint16_t compare(int channel) const { return compare_[channel]; }
  uint16_t capture() const { return capture_; }
  uint8_t enabled() const { return enabled_; }
  /// Reads TIFRn.
  uint8_t flags();
  uint16_t count() const;

  ROBOSIM_RARE void set_control_a(uint8_t value);
  ROBOSIM_RARE void set_control_b(uint8_t value);
  /// Sets a compare value. The board receives the pin's new duty cycle at once, even if the value takes
  /// effect later. A value that is the counter's TOP is an exception: the caller must then refresh the pin.
  void set_compare(int channel, uint16_t value);
  /// Sets a compare value. The board receives the new duty cycle when the value takes effect.
  ROBOSIM_RARE void write_compare(int channel, uint16_t value);
  ROBOSIM_RARE void set_capture(uint16_t value);
  ROBOSIM_RARE void set_count(uint16_t value);
  /// Restarts the prescaler's count at 0 (PSRSYNC, PSRASY).
  ROBOSIM_RARE void reset_prescaler();
  /// Changes the pins as matches do, except in PWM modes. `bits` are FOCnA and FOCnB.
  ROBOSIM_RARE void force_compare(uint8_t bits);
  ROBOSIM_RARE void set_enabled(uint8_t mask);
  void clear_flags(uint8_t mask);

  /// Simulates a moment of the core's init(): the timer runs with prescaler 8 before PWM is selected (CS11,
  /// then CS10 and WGM10). In this moment, the count most likely reaches 1. This raises the flags of matches
  /// with 0. The overflow flag is not raised before the count returns to BOTTOM.
  ROBOSIM_RARE void leave_bottom();

  /// Raises the enabled flags that are due now.
  void sync() {
    if (state.now >= due_) raise_due();
  }
  /// Returns the time at which the next enabled flag will be raised.
  SimTime due() const { return due_; }
  /// Returns the time at which the next enabled flag other than the overflow will be raised.
  SimTime due_to_match() const { return due_to_match_; }
  /// Returns whether only the overflow is due. The caller may then call take_overflows() and the overflow's
  /// handler.
  bool overflows_next() const { return state.now >= due_of_[0] && state.now < due_to_match_; }
  /// Returns the flags that are raised and enabled.
  uint8_t pending() const { return flags_ & enabled_; }
  /// Clears `flag` when its handler starts.
  void acknowledge(uint8_t flag) { flags_ &= static_cast<uint8_t>(~flag); }

  /// Returns the COM bits of channel 0 (A) or 1 (B). 0 = the port drives the pin.
  uint8_t connection(int channel) const { return avr::connection(control_a_, channel); }
  /// Sets the COM bits. The caller must then refresh the pin.
  ROBOSIM_RARE void set_connection(int channel, uint8_t bits);
  /// Returns whether a channel drives its pin when the pin is an output.
  bool drives(int channel) const;
  /// Returns how a channel drives its pin.
  PinDrive drive(int channel) const;
  /// Return the level of a channel's pin at `at`, and the time of its next change after `after`, or kNever.
  /// The channel must have PWM or toggle its pin. The times must not be before the last register write.
  bool level(int channel, SimTime at) const { return level_at(channel, tick_at(at)); }
  ROBOSIM_RARE SimTime next_edge(int channel, SimTime after) const;
  /// Returns the time of the next turn. Levels and edges are valid until then.
  SimTime turns_at() const { return turns_at_; }
  ROBOSIM_RARE void turn();

  /// Returns whether the timer counts edges of a pin (external clock). count_edge() handles the pin's new
  /// level.
  bool counts_edges() const { return (control_b_ & 7) != 0 && prescaler_ == 0; }
  ROBOSIM_RARE void count_edge(bool level);

  /// Returns whether the timer captures edges of a pin. capture_edge() handles the pin's new level at `at`.
  bool captures_edges() const { return listens_ && !of_comparator_ && captures(); }
  ROBOSIM_RARE void capture_edge(bool level, SimTime at);
  /// Starts or stops capturing edges of the comparator's output (ACIC). comparator_changed() handles a change
  /// of that output.
  void capture_comparator(bool is, bool level);
  void comparator_changed(bool level);

  /// Returns whether the timer runs like Timer 0 after init(): from 0 to 255, with a single slope.
  bool counts_bytes() const { return !dual_slope_ && top_ == 255 && prescaler_ != 0 && turn_ == kNoTick; }
  /// Returns the time at which `ticks` timer ticks have passed since the present count began.
  SimTime ticks_from_now(int64_t ticks) const;
  /// Returns the number of overflows that have not been counted yet, without raising the overflow flag.
  int64_t take_overflows();

 private:
  /// The counter's position at the change of a register that affects counting.
  struct Phase {
    uint16_t count;
    bool down, hidden;
    int32_t prescaler;
    SimTime tick_began;
  };
  bool makes_pwm() const { return counting_.kind == avr::Counting::Kind::pwm; }
  /// Reports that the timer has left or entered PWM. The arguments are the state before a write to TCCRnx.
  void tell_of_mode(bool made_pwm, uint8_t control_a) const;
  ROBOSIM_RARE Phase leave_registers();
  ROBOSIM_RARE void take_registers(const Phase& phase);
  ROBOSIM_RARE void keep_level(int channel, int64_t tick);
  bool is_held(int channel) const {
    if (replaced_at_[channel] < 0) return false;
    return prescaler_ == 0 || (state.now - replaced_at_[channel] < lasts_ && ticks() < held_until(channel));
  }
  int64_t held_until(int channel) const;
  ROBOSIM_RARE void begin(uint16_t count, bool down, bool hidden);
  bool is_top(int channel) const { return channel == 0 && counting_.top == avr::Counting::Top::compare_a; }
  int64_t taken_over_at() const {
    return !dual_slope_ ? 0 : (counting_.frequency_correct ? 1 : top_ + 1) % period_;
  }
  void turn_where_taken_over() {
    const int64_t until = held_until(0);
    if (until != kLongAgo && until < turn_) turn_ = until;
  }
  ROBOSIM_RARE void take_turns();
  ROBOSIM_RARE bool steps(int channel) const;
  /// Returns whether steps(channel) may be true for any channel.
  bool steps() const {
    return control_a_ & (counting_.kind == avr::Counting::Kind::pwm ? kToggles : kConnections);
  }
  ROBOSIM_RARE bool level_at(int channel, int64_t tick) const;
  ROBOSIM_RARE int64_t next_change(uint16_t compare, int64_t after) const;
  int64_t tick_at(SimTime at) const;
  int64_t ticks() const { return tick_at(state.now); }
  uint16_t count_at(int64_t tick) const;
  /// Returns whether the counter counts down, or has counted down to BOTTOM in the last tick.
  bool counts_down(int64_t tick) const {
    const int64_t at = tick % period_;
    return dual_slope_ && (strays_ || (top_ > 0 && (at > top_ || (at == 0 && tick > 0))));
  }
  SimTime time_of(int64_t tick) const;
  bool passed(int64_t at, int64_t from, int64_t until) const;
  ROBOSIM_RARE bool raised(int flag, int64_t until) const;
  void raise_due();
  void sync_disabled() {
    if (prescaler_ != 0) sync_disabled(ticks());
  }
  void sync_disabled(int64_t until);
  void refresh_due(int64_t after);
  ROBOSIM_RARE void refresh_turn();
  int64_t first(int64_t at, int64_t after) const;
  SimTime next(int flag, int64_t after) const;
  ROBOSIM_RARE SimTime next_match(int channel, int64_t after) const;
  bool overflows() const {
    const bool clears = counting_.kind == avr::Counting::Kind::clear_on_match;
    return counting_.dual_slope || (strays_ ? clears : !clears || top_ == max_);
  }
  /// Returns the position in the period at which the overflow flag is raised. With dual slope, this is one
  /// tick after BOTTOM. A counter that starts at BOTTOM thus raises the flag with its first tick.
  int64_t overflows_at() const { return counting_.dual_slope ? 1 % period_ : 0; }
  /// Stores in `at` the positions in the period at which a match with `value` is detected. Returns their
  /// number, 0..2.
  ROBOSIM_RARE int matches(int64_t value, int64_t (&at)[2]) const;
  /// Stores in `at` the positions in the period at which the counter raises flag 0..3: overflow, match A,
  /// match B, and ICFn at TOP. Returns their number. Matches use the compare value that was written last.
  int raises(int flag, int64_t (&at)[2]) const;
  static constexpr uint8_t bit_of(int flag) { return flag == 3 ? captured : static_cast<uint8_t>(1 << flag); }
  /// Requests edges of ICPn from now on, because the sketch uses captures.
  void listen_to_captures();
  /// Starts the noise canceler with the pin's level.
  void begin_canceler();
  bool captures() const { return counting_.top != avr::Counting::Top::capture; }
  bool has_capture() const { return flag_count_ > 3; }
  static constexpr uint8_t kConnections = 0xF0, kToggles = 0x50;  ///< all COM bits; COMnA0 and COMnB0

  uint8_t number_;
  uint16_t max_;
  int flag_count_;
  uint8_t control_a_ = 0, control_b_ = 0, enabled_ = 0, flags_ = 0;
  uint16_t compare_[2] = {0, 0};
  uint16_t capture_ = 0;
  // Decoded from the registers:
  avr::Counting counting_;
  int32_t prescaler_ = 0;  ///< 0 = stopped
  // How the counter runs until the next turn:
  static constexpr int64_t kNoTick = INT64_MAX, kLongAgo = INT64_MIN;
  bool dual_slope_ = false, strays_ = false;  ///< strays_: the counter deviates (timer_turns.cpp)
  int64_t top_, period_;
  int64_t pin_top_ = 0xFF;                         ///< TOP according to the registers, for duty cycles
  SimTime lasts_ = 0;                              ///< upper limit of the duration of a period
  int64_t turn_ = kNoTick;                         ///< tick at which the counter restarts
  SimTime turns_at_ = kNever, turn_due_ = kNever;  ///< turn_due_: next turn or report of a pin
  int64_t hidden_ = kLongAgo;                      ///< a write to TCNTn hides a match at this tick
  uint16_t set_to_ = 0;                            ///< value of that write
  // The counter: tick `base_tick_` began at `base_`.
  SimTime base_ = 0;
  int64_t base_tick_ = 0;
  int64_t overflows_seen_ = 0;  ///< tick up to which take_overflows() has counted
  int64_t disabled_seen_ = 0;   ///< tick up to which the flags without an enabled interrupt are up to date
  SimTime due_of_[4] = {kNever, kNever, kNever, kNever};  ///< due times of flags 0..3; kNever if not enabled
  SimTime due_ = kNever, due_to_match_ = kNever;
  // Levels of the pins. Without PWM: the level after the last match, and the tick of this match. With PWM:
  // the compare value before the last write, and the time of the write.
  bool toggled_[2] = {false, false};
  int64_t toggled_at_[2] = {0, 0};
  uint16_t held_[2] = {0, 0};
  SimTime replaced_at_[2] = {-1, -1};  ///< -1 = no write since the last turn
  uint8_t late_ = 0;                   ///< channels whose new compare value is reported when it takes effect
  bool pins_stale_ = false;
  // Captures: `listens_` = the sketch uses captures. `passed_` is the level after the noise canceler.
  // `level_` is the level before the canceler, which changed at `changed_at_`. `had_flag_` and `had_capture_`
  // are the state before the last edge, in case the canceler withdraws this edge.
  bool listens_ = false, of_comparator_ = false, comparator_ = false;
  bool passed_ = false, level_ = false, may_take_back_ = false, had_flag_ = false;
  SimTime changed_at_ = 0;
  uint16_t had_capture_ = 0;
};

extern Timer timer0, timer1, timer2;
inline Timer& timer(int number) { return number == 0 ? timer0 : number == 1 ? timer1 : timer2; }

/// Does the work of all due runs of Timer 0's overflow handler in one step, for firmware that only waits.
void timer0_catch_up();
/// The counts of Timer 0's overflow handler.
struct Timer0Count {
  uint64_t millis;     ///< result of millis()
  uint64_t fraction;   ///< part of the next millisecond, in 125ths
  uint64_t overflows;  ///< number of overflows, for micros()
};
extern Timer0Count timer0_count;
constexpr SimTime kOverflowTakes = cycles(cost::kTimer0Overflow);

}  // namespace ROBOSIM_WITHIN
}  // namespace robosim

/// Timer 0's overflow handler, which takes the time kOverflowTakes.
extern "C" void __vector_16();
