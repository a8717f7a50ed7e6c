// Models clocks and sleep: SMCR, PRR, CLKPR and MCUSR (data sheet DS40002061B, chapters 9 to 11).
//
//   mode                         processor   I/O clock   ADC clock   start-up on wake-up
//   idle                         stopped     runs        runs        none
//   noise reduction              stopped     stopped     runs        none
//   standby, extended standby    stopped     stopped     stopped     6 cycles
//   other modes                  stopped     stopped     stopped     the oscillator's start-up time
//
// Table 9-4 lists the oscillator's start-up time: 16384 cycles for a crystal (ChipSpec stores the time of
// each chip). After the start-up, the processor waits for 4 more cycles, and then takes 4 cycles to enter the
// interrupt (10.2).
//
// While a bit in PRR stops a peripheral, the peripheral's registers read 0 and keep their content (10.11.3).
// CLKPR divides all clocks except those of the watchdog and the EEPROM. Not modelled: timer 2's own crystal;
// all timers use the I/O clock.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/mcu/avr/core.h"

namespace robosim::avr {

class Power final : public Peripheral {
 public:
  enum class Clock : std::uint8_t { io, adc };

  explicit Power(Core& core);

  /// Connects a peripheral to its clock. The peripheral stops in sleep modes that stop `clock`, and while bit
  /// number `bit` of the PRR at address `reduction` is set; -1 = no bit.
  void supply(Peripheral& peripheral, Clock clock, Address reduction, int bit);

  void reset(Cycle at) override;

  /// Handles SLEEP. Does nothing and returns false if SE is not set.
  bool sleep(Cycle at);
  bool is_asleep() const { return state_.asleep; }
  /// Handles an interrupt that wakes the chip: the processor continues after the start-up time.
  void wake(Cycle at);
  /// Returns the number of cycles slept.
  Cycle slept(Cycle now) const { return state_.slept + (state_.asleep ? now - state_.slept_from : 0); }

 private:
  struct Supplied {
    Peripheral* peripheral = nullptr;
    Clock clock = Clock::io;
    Address reduction = 0;
    std::uint8_t mask = 0;
  };
  struct State {
    bool asleep = false;
    bool io_runs = true, adc_runs = true;
    Cycle slept_from = 0, slept = 0;
    std::uint64_t stopped = 0;  ///< one bit per supplied peripheral
    Cycle start_up = 0;         ///< start-up time at wake-up, in cycles
    Cycle divisor_unlocked_until = 0;
  };

  void write_reduction(Address address, std::uint8_t value);
  std::uint8_t read_divisor(Address address);
  void write_divisor(Address address, std::uint8_t value);
  void write_reset_flags(Address address, std::uint8_t value);
  void let_run(bool io, bool adc, Cycle at);
  void update(Cycle at);
  void divide_clock(int divisor, Cycle at);

  Core& core_;
  std::vector<Supplied> supplied_;
  std::vector<Peripheral*> on_adc_clock_;
  State state_;
};

}  // namespace robosim::avr
