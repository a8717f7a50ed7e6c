// Declares the interface through which a chip accesses its environment. A robot's board, a test or a web page
// implements the interface. By default, nothing is connected to the chip's pins.
//
// Pins are indices in ChipSpec::pins, and times are processor cycles. The time of a call may be earlier than
// that of the previous call, by at most the cycles of one instruction. During a call, the environment may
// call only these functions of the chip: Chip::edge(), receive(), call_at() and Cpu::stop().
#pragma once

#include "hal/board/board.h"
#include "sim/mcu/avr/cycle.h"

namespace robosim::avr {

class ChipEnvironment {
 public:
  // --- pins
  /// Returns the level of a pin that the chip does not drive. `pull_up` is the level if nothing else drives
  /// the pin.
  virtual bool level(int /*pin*/, bool pull_up, Cycle /*at*/, ReadIntent) { return pull_up; }
  /// Returns the first cycle after `at` at which the result of level() may change. Before that cycle, the
  /// caller need not call level() again. Returns `at` if that cycle is unknown.
  virtual Cycle level_until(int /*pin*/, Cycle at) { return at; }
  /// Returns the voltage source at a pin, for a sample of the ADC or comparator. `high` is set if the chip's
  /// output or pull-up drives the pin high.
  virtual Source source(int /*pin*/, bool high, Cycle /*at*/) { return high ? supply_volts() : 0.0; }
  /// Returns the present voltage of VCC and AVCC.
  virtual double supply_volts() const { return 5.0; }
  /// Reports that the chip has changed how it drives a pin.
  virtual void driven(int /*pin*/, const PinDrive&, Cycle /*at*/) {}
  /// Starts or stops the reports of a pin's level changes through Chip::edge(). Returns the pin's level at
  /// `at`; the caller ignores the result when reports stop.
  virtual bool wants_edges(int pin, bool /*wanted*/, Cycle at) {
    return level(pin, true, at, ReadIntent::port);
  }

  // --- serial lines: `line` is an index in ChipSpec::uarts; USB has the number after the last UART
  /// Reports that the chip starts to send a frame.
  virtual void sent(int /*line*/, std::uint16_t /*data*/, Cycle /*at*/) {}
  /// Reports the frame duration, in cycles, that the receiver expects from `at` on; 0 = the receiver is off.
  virtual void listens(int /*line*/, Cycle /*frame*/, Cycle /*at*/) {}

  // --- two-wire bus: called at the end of a byte, or at the stop condition
  /// Addresses a device (seven bits and the direction); returns whether a device answers.
  virtual bool two_wire_address(std::uint8_t /*address*/, Cycle /*at*/) { return false; }
  /// Writes a byte; returns whether the device acknowledges it.
  virtual bool two_wire_write(std::uint8_t /*byte*/, Cycle /*at*/) { return false; }
  virtual std::uint8_t two_wire_read(Cycle /*at*/) { return 0xFF; }
  virtual void two_wire_stop(Cycle /*at*/) {}

  // --- non-volatile memory
  virtual std::uint8_t read_eeprom(std::uint16_t /*address*/) const { return 0xFF; }
  /// Writes or erases a byte of the EEPROM immediately. Called when the chip starts the write.
  virtual void write_eeprom(std::uint16_t /*address*/, std::uint8_t /*value*/, Cycle /*at*/) {}

  // --- time
  /// Called at the cycle that Chip::call_at() has requested.
  virtual void called(Cycle /*at*/) {}
  /// Reports that the processor's clock is the oscillator's clock divided by `divisor` from `at` on (CLKPR).
  /// A reset sets the divisor to 1.
  virtual void clock_divided(int /*divisor*/, Cycle /*at*/) {}
  /// Reports that the chip was reset: registers are as after power-on, memory is retained. `flags` is the
  /// content of MCUSR.
  virtual void was_reset(std::uint8_t /*flags*/, Cycle /*at*/) {}

 protected:
  ~ChipEnvironment() = default;
};

}  // namespace robosim::avr
