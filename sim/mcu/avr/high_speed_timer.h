// Models timer 4 of an ATmega32U4 (data sheet 7766J, chapter 15).
//
//   TOP    OCR4C; 0xFF after a reset
//   PWM4x  0 for all outputs: counts up to TOP, restarts at 0 and sets TOV4; OCR4x take effect at once
//   WGM4   with PWM: 0 fast: counts as above; the output is high for OCR4x + 1 of TOP + 1 ticks
//                    1 phase and frequency correct: counts up and down, sets TOV4 at 0; the output is high
//                      for OCR4x of TOP ticks
//   COM4x  at a match, 1 toggles the output, 2 clears it, 3 sets it (2 and 3 also with PWM)
//   CS4    divides the clock by 2^(CS4 - 1)
//   TC4H   the two high bits of each register: written before the low byte, set by reads of TCNT4
//
// The environment receives PWM as a duty cycle, which a new OCR4x changes at once. For flags, for counting,
// and for the level that PINx reads, a new OCR4x takes effect at TOP or BOTTOM. If one output has PWM, the
// counter is in PWM mode for all outputs.
//
// Not modelled: the PLL as clock source, dead times and the inverted outputs, PWM6, the fault unit, enhanced
// mode, and TLOCK4.
#pragma once

#include <array>
#include <cstdint>

#include "sim/mcu/avr/pins.h"
#include "sim/mcu/avr/timer_counter.h"

namespace robosim::avr {

class HighSpeedTimer final : public Peripheral {
 public:
  /// `index` is the timer's position in ChipSpec::timers.
  HighSpeedTimer(Core& core, Pins& pins, int index);

  void reset(Cycle at) override;
  void clock_runs(bool runs, Cycle at) override;
  std::uint64_t may_interrupt() const override;

 private:
  static constexpr std::size_t kOutputs = 4;   ///< A to D; the register of C is TOP
  static constexpr std::size_t kChannels = 3;  ///< compare channels of the counter: A, B and D
  struct State {
    Counter counter;
    Cycle at = 0;     ///< all ticks up to this cycle are counted
    Cycle began = 0;  ///< a cycle at which the prescaler's count was 0
    std::array<std::uint16_t, kOutputs> compare{};
    std::array<bool, kOutputs> taken{}, level{};  ///< `level` is the level after the last match, without PWM
    std::uint8_t flags = 0, enables = 0, requested = 0,
                 heard = 0;  ///< `heard` has one bit per output; the others have bits of Counter::Hit
    bool runs = true;
    bool drives_stale = false;
  };

  // registers
  void write(Address address, std::uint8_t value);
  void write_compare(Address address, std::uint8_t value);
  std::uint8_t read_count(Address address);
  void write_count(Address address, std::uint8_t value);
  std::uint8_t read_flags(Address address);
  void write_flags(Address address, std::uint8_t value);
  void write_flag(Address address, std::uint8_t value, std::uint8_t bit);
  void write_enables(Address address, std::uint8_t value);
  std::uint8_t control(int offset) const {
    return core_.cpu.data[spec_.control + static_cast<unsigned>(offset)];
  }
  std::uint16_t with_high(std::uint8_t low) const;
  /// Return an output's COM bits, and whether the output has PWM.
  int connection(std::size_t output) const;
  bool has_pwm(std::size_t output) const;

  // counting
  int shift() const;  ///< the prescaler divides by 1 << shift; -1 = no clock
  bool ticks_come() const { return state_.runs && shift() >= 0; }
  Cycle tick_after(Cycle at, Cycle ticks) const;
  Cycle before_now() const { return core_.now() > 0 ? core_.now() - 1 : 0; }
  void set_mode();
  void count_to(Cycle to);
  /// Updates the interrupt requests, the pins and the next event. Called after each change of the timer's
  /// state.
  void settle();
  void schedule();
  void due(Cycle at);
  void entered(int vector);
  void request(unsigned flags);
  int vector_of(std::uint8_t flag) const;
  std::uint8_t wanted() const;

  // pins
  bool switches(std::size_t output) const;
  void match(std::size_t output);
  bool pwm_level(std::size_t output) const;
  bool wave_level(int pin);
  void wave_heard(int pin, bool heard);
  std::size_t output_of(int pin) const;
  /// Reports changed pins, and edges on pins with a listener.
  void tell();
  void tell_drives();

  Core& core_;
  Pins& pins_;
  const TimerSpec& spec_;
  std::array<int, kOutputs> output_pins_;
  Events::Id due_ = 0;
  State state_;
};

}  // namespace robosim::avr
