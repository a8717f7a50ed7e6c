// Models the 8-bit and 16-bit timers. ATmega328P data sheet DS40002061B, chapters 15 (timer 0), 16 (timer 1),
// 17 (prescaler) and 18 (timer 2, with the processor's clock).
//
//   prescaler, pin Tn ─► Counter ─► flags in TIFRn ─► interrupts, ADC
//                         ▲   └───► pins OCnA, OCnB
//   pin ICPn ─► canceler ─┘ ICRn
//
// - Time. A write to a register takes effect after the cycle of the write. With a prescaler of 1, a value
//   written to TCNTn in cycle c reads unchanged in c + 1, and as one more in c + 2. A flag that a tick sets
//   still reads as 0 in the cycle of the tick, but its interrupt can be entered in this cycle. If a tick
//   sets a flag in the cycle in which firmware writes 1 to the flag, the flag stays set.
// - Counting happens on demand. Only observable changes are scheduled as events: the setting of a flag whose
//   interrupt is enabled, a changed level of a pin, or an OCRnx that changes a duty cycle.
// - Pins. PWM is reported as a duty cycle, and a pin in toggle mode (COM = 1) as a tone of the pin's
//   frequency. If the tone is too low to be heard, each match reports a new level. COM = 2 and 3 without PWM
//   also report levels. If the counter has no clock, its pins keep their levels. PINx reads the current
//   level. If the chip also listens to such a pin, each edge is an event.
// - Capture. Edges of ICPn are recorded once firmware uses capture: it sets ICIEn, ICESn or ICNCn, or reads
//   ICRn or TIFRn. An unused pin therefore costs nothing. The analog comparator can replace the pin.
// - PRR. Without a clock, the registers read 0 and ignore writes (10.10).
//
// Not modelled: timer 2's crystal (ASSR).
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "sim/mcu/avr/core.h"
#include "sim/mcu/avr/pins.h"
#include "sim/mcu/avr/timer_counter.h"
#include "sim/mcu/avr/timer_edges.h"
#include "sim/mcu/avr/timer_prescaler.h"

namespace robosim::avr {

class Timer final : public Peripheral {
 public:
  /// `index` is the timer's position in ChipSpec::timers.
  Timer(Core& core, Pins& pins, Prescalers& prescalers, int index);

  void reset(Cycle at) override;
  void clock_runs(bool runs, Cycle at) override;
  std::uint64_t may_interrupt() const override;

  /// Counts all ticks up to and including cycle `at`, and sets their flags.
  void count_to(Cycle at);
  /// Updates the interrupt requests, the pins and the next event. Called after each change of the timer's
  /// state.
  void settle();

  const Counter& counter() const { return state_.counter; }

  /// Starts or stops capturing the comparator's output instead of ICPn (ACIC). `level` is the current output.
  void capture_comparator(bool is, bool level, Cycle at);
  void comparator_changed(bool level, Cycle at);

  // --- for timers that share TIFR and TIMSK: flags are bits at their positions in these registers
  std::uint8_t flags_in_register();
  void clear_in_register(std::uint8_t flags) { clear_flags(of_register(flags)); }
  void enable_in_register(std::uint8_t flags);
  ReadForecast forecast_of_flags(Address address, std::uint8_t bits);

 private:
  static constexpr std::uint8_t kConnections = 0xFC;  ///< COM of all channels in TCCRnA
  static constexpr std::uint8_t kCaptured = Counter::kTop;
  static constexpr std::uint8_t kCounted =
      Counter::kOverflow | Counter::kMatchA | Counter::kMatchB | Counter::kMatchC;

  struct Output {
    bool taken = false;
    bool level = false;  ///< level after the last match; unused with PWM
    PinDrive drive;
  };
  struct State {
    Counter counter;
    Cycle at = 0;  ///< all ticks up to this cycle are counted
    std::uint8_t control_a = 0, control_b = 0,
                 enables = 0;  ///< TCCRnA, TCCRnB and TIMSKn, in an ATmega's layout
    std::uint8_t flags = 0, requested = 0, watched = 0;
    std::uint8_t temp = 0;  ///< high byte between the two accesses to a register
    bool runs = true;       ///< the timer has a clock (PRR, sleep)
    int shift = -1;         ///< the prescaler divides by 1 << shift; -1 = no prescaler clock
    bool drives_stale = false;
    std::uint8_t tones = 0,
                 heard = 0;  ///< one bit per channel: reported as a tone (`tones`), has a listener (`heard`)
    std::array<Output, 3> outputs{};
    EdgesUnderWay pulses, captures;
    NoiseCanceler canceler;
    bool wants_captures = false, captures_comparator = false;
    bool comparator = false;  ///< level of the comparator's output
    Cycle pll_locked_at = kNoCycle;
    /// Periodic flag whose interrupt is enabled and that has no other listeners; 0 = none.
    std::uint8_t beat = 0;
    std::uint8_t beat_flags = 0;  ///< all flags that the timer can set
    int beat_vector = 0;
    Cycle beat_at = 0, beat_period = 0;
  };
  // registers
  void hook_registers();
  void write_control_a(Address address, std::uint8_t value);
  void write_control_b(Address address, std::uint8_t value);
  void write_control_c(Address address, std::uint8_t value);
  void write_enables(Address address, std::uint8_t value);
  std::uint8_t read_plain(Address address) { return state_.runs ? core_.at(address) : std::uint8_t{0}; }
  std::uint8_t read_flags(Address address);
  void write_flags(Address address, std::uint8_t value);
  void write_flag(Address address, std::uint8_t value, std::uint8_t bit);
  std::uint8_t read_count(Address address);
  ReadForecast forecast_of_count(Address address, std::uint8_t bits);
  void write_count(Address address, std::uint8_t value);
  void write_compare(Address address, std::uint8_t value);
  std::uint8_t read_capture(Address address);
  void write_capture(Address address, std::uint8_t value);
  std::uint8_t read_temp(Address) { return state_.runs ? state_.temp : std::uint8_t{0}; }
  void write_temp(Address address, std::uint8_t value);
  std::uint8_t in_register(std::uint8_t flags) const;
  std::uint8_t of_register(std::uint8_t flags) const;
  // for an ATtiny85's timer 1: timer_pll.cpp
  void hook_pll_registers();
  void write_pll_control(Address address, std::uint8_t value);
  void write_pll_general(Address address, std::uint8_t value);
  void write_top(Address address, std::uint8_t value);
  void write_pll(Address address, std::uint8_t value);
  std::uint8_t read_pll(Address address);
  void take_pll_control();
  int pll_shift() const;
  std::uint16_t with_temp(std::uint8_t low) const;
  /// Stores the last read or written value in data memory; returns the low byte.
  std::uint8_t show(Address address, std::uint16_t value);
  void clear_flags(std::uint8_t flags);
  bool is_wide() const { return spec_.bits == 16; }
  std::span<const std::uint16_t> compares() const { return {spec_.compare, channels_}; }
  std::uint8_t flags_there_are() const;
  std::size_t channel_at(Address compare) const {
    return compare == spec_.compare[0] ? 0 : compare == spec_.compare[1] ? 1 : 2;
  }
  std::uint8_t control_a() const { return state_.control_a; }
  std::uint8_t control_b() const { return state_.control_b; }
  std::uint8_t enables() const { return state_.enables; }

  // counting
  void set_mode();
  void set_enables(std::uint8_t enables);
  void count_ticks(Cycle to);
  Cycle before_now() const { return core_.now() > 0 ? core_.now() - 1 : 0; }
  bool ticks_come() const;  ///< the prescaler currently provides ticks
  void set_flags(std::uint8_t hits, Cycle at);
  void due(Cycle at);
  void entered(int vector);
  bool awaited(int vector, bool awaited);
  void clock_changed(std::int64_t hz_before);
  void schedule();
  Cycle when_due();
  void find_beat(std::uint8_t flag, Cycle at);
  bool beat();
  Cycle tick_after(Cycle at, Cycle ticks) const;
  Cycle next_edge() const { return std::min(state_.pulses.next(), state_.captures.next()); }
  std::uint8_t coming(Cycle at) const;
  std::uint8_t coming_by_edge() const;
  std::uint8_t flags_of_ticks() const {
    return state_.counter.how().top == Counting::Top::capture ? kCounted | kCaptured : kCounted;
  }
  void request(unsigned flags);
  std::uint8_t wanted() const;
  int vector_of(std::uint8_t flag) const;
  std::uint8_t flag_of(int vector) const;

  // pins
  bool is_external() const { return state_.shift < 0 && (control_b() & 7) >= 6; }
  void pulsed(int pin, bool level, Cycle at);
  void captured(int pin, bool level, Cycle at);
  void capture_edge(bool level, Cycle at);
  bool is_captured() const { return state_.counter.how().top != Counting::Top::capture; }
  bool capture_level() { return state_.captures_comparator ? state_.comparator : pins_.level(capture_pin_); }
  void listen();
  void want_captures();
  bool drives(std::size_t channel) const;
  void match(std::size_t channel);
  void force(std::uint8_t control);
  bool pwm_level(std::size_t channel) const;
  std::size_t channel_of(int pin) const;
  bool wave_level(int pin);
  void wave_heard(int pin, bool heard);
  bool level_of(std::size_t channel) const;
  bool is_followed(std::size_t channel) const;
  void toggle_tones(Cycle ticks);
  void tell_waves();
  bool changes_at_match(std::size_t channel) const;
  PinDrive drive_of(std::size_t channel) const;
  void tell_drives();

  Core& core_;
  Pins& pins_;
  Prescalers& prescalers_;
  const TimerSpec& spec_;
  const std::uint8_t channels_;
  const Address control_b_;
  const Prescalers::Which prescaler_;
  std::array<int, 3> output_pins_{-1, -1, -1};
  int pulse_listener_ = -1, capture_listener_ = -1, capture_pin_ = -1;
  Events::Id due_ = 0;
  State state_;
};

}  // namespace robosim::avr
