// The world outside of a chip, as the chip sees it: the only seam of this room. Each user of a chip
// implements it: a robot's board, a test or a page.
//
// Pins are indices in ChipSpec::pins, moments are cycles of the processor. Moments never go back by more than
// the few cycles of an instruction.
#pragma once

#include "hal/board/board.h"
#include "sim/avr/cycle.h"

namespace robosim::avr {

class ChipEnvironment {
 public:
  // --- pins
  /// Returns the level of a pin that the chip does not drive; `pull_up`: its level without any other driver.
  virtual bool level(int pin, bool pull_up, Cycle at) = 0;
  /// Returns the level for a read by a peripheral, or for an instruction that reads the whole port: the
  /// program may not use it.
  virtual bool level_along(int pin, bool pull_up, Cycle at) = 0;
  /// Returns until which cycle, exclusive, level() surely equals its result at `at`, so that fewer calls make
  /// no difference; `at` = unknown.
  virtual Cycle level_until(int pin, Cycle at) = 0;
  /// Returns the volts at a pin, for a sample of the converter or comparator. `high`: the chip's own output
  /// or pull-up.
  virtual double volts(int pin, bool high, Cycle at) = 0;
  /// Returns the volts of the converter's capacitor, with `before` volts initially, which the pin has charged
  /// since `from`: FirmwarePort::convert().
  virtual double convert(int pin, bool high, double /*before*/, Cycle /*from*/, Cycle at) {
    return volts(pin, high, at);
  }
  /// Returns FirmwarePort::supply_share().
  virtual double supply_share() { return 1.0; }
  /// Reports a changed drive of a pin.
  virtual void driven(int pin, const PinDrive& drive, Cycle at) = 0;
  /// Starts or stops reports of level changes by Chip::edge(), relative to the level that this returns. (If
  /// they stop, the result does not matter.)
  virtual bool wants_edges(int pin, bool wanted, Cycle at) = 0;

  // --- serial lines: UARTs by their index in ChipSpec::uarts, then the USB's
  /// A frame begins to leave the chip.
  virtual void sent(int line, std::uint16_t data, Cycle at) = 0;
  /// Sets the duration of a received frame from now on; 0 = the receiver is off.
  virtual void listens(int line, Cycle frame, Cycle at) = 0;

  // --- the two-wire bus, at the end of each byte
  /// Addresses a device, seven bits and the direction; returns whether one answers.
  virtual bool two_wire_address(std::uint8_t address, Cycle at) = 0;
  /// Returns whether it acknowledges.
  virtual bool two_wire_write(std::uint8_t byte, Cycle at) = 0;
  virtual std::uint8_t two_wire_read(Cycle at) = 0;
  virtual void two_wire_stop(Cycle at) = 0;

  // --- memory that outlives the power
  virtual std::uint8_t* eeprom() = 0;
  /// Writes (or erases) a byte of it at once. Called when the chip begins to write it.
  virtual void write_eeprom(std::uint16_t address, std::uint8_t value, Cycle at) = 0;

  // --- time
  /// Called at the moment requested by Chip::call_at().
  virtual void called(Cycle at) = 0;
  /// Reports that the processor's clock is the oscillator's divided by `divisor` from `at` on (CLKPR; a reset
  /// sets it to 1).
  virtual void clock_divided(int divisor, Cycle at) = 0;
  /// Reports that the chip has reset itself: registers are as after power-on, memory is retained. `flags` are
  /// MCUSR's.
  virtual void was_reset(std::uint8_t flags, Cycle at) = 0;

 protected:
  ~ChipEnvironment() = default;
};

}  // namespace robosim::avr
