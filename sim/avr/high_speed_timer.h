// Timer 4 of an ATmega32U4, as far as it makes PWM. Data sheet 7766J, chapter 15.
//
//   TOP    OCR4C, with the two bits of TC4H as they were written with it; 0xFF after a reset
//   WGM4   0 fast PWM: high for OCR4x + 1 of TOP + 1 ticks
//          1 phase and frequency correct: OCR4x of TOP
//   COM4x  2 cleared at the match, 3 set; PWM4x switches PWM on for A, B and D
//
// Pins are told as a duty, taken over at once. Not modelled: counting (TCNT4 stands, no flag is set and
// nothing interrupts), dead times and the inverted outputs, PWM6, the fault unit, enhanced mode.
#pragma once

#include <array>
#include <cstdint>

#include "sim/avr/pins.h"

namespace robosim::avr {

class HighSpeedTimer final : public Peripheral {
 public:
  /// `index`: in ChipSpec::timers.
  HighSpeedTimer(Core& core, Pins& pins, int index);

  void reset(Cycle at) override;
  void clock_runs(bool runs, Cycle at) override;

 private:
  static constexpr std::size_t kOutputs = 4;  ///< A to D; C is TOP
  struct State {
    std::array<std::uint16_t, kOutputs> compare{};
    std::array<bool, kOutputs> taken{};
    bool runs = true;
  };

  void write(Address address, std::uint8_t value);
  void write_compare(Address address, std::uint8_t value);
  void tell_drives();
  /// COM of an output, and whether PWM is switched on for it.
  int connection(std::size_t output) const;
  bool has_pwm(std::size_t output) const;
  std::uint8_t control(int offset) const {
    return core_.cpu.data[spec_.control + static_cast<unsigned>(offset)];
  }

  Core& core_;
  Pins& pins_;
  const TimerSpec& spec_;
  std::array<int, kOutputs> output_pins_;
  State state_;
};

}  // namespace robosim::avr
