// The world outside of a chip, as the chip sees it: the only seam of this room. Each user of a chip
// implements it: a robot's board, a test or a page.
//
// Pins are indices in ChipSpec::pins, moments are cycles of the processor. Moments never go back by more than
// the few cycles of an instruction.
#pragma once

#include "hal/board/board.h"
#include "sim/avr/cycle.h"

namespace robosim::avr {

class Surroundings {
 public:
  // --- pins
  /// The level of a pin that the chip does not drive; `pull_up`: what it has if nothing else drives it.
  virtual bool level(int pin, bool pull_up, Cycle at) = 0;
  /// The same of a pin that a peripheral looks at, or an instruction that reads all of its port: whether the
  /// program uses it is not known.
  virtual bool level_along(int pin, bool pull_up, Cycle at) = 0;
  /// Until which cycle, exclusive, level() surely gives what it gives at `at`, and may be asked less often
  /// without a difference; `at` = that is not known.
  virtual Cycle level_until(int pin, Cycle at) = 0;
  /// Volts at a pin, when the converter samples it or the comparator looks. `high`: what the chip itself
  /// gives it, by its output or its pull-up.
  virtual double volts(int pin, bool high, Cycle at) = 0;
  /// The same for the capacitor of the converter, with `before` volts on it, which the pin has charged since
  /// `from`: FirmwarePort::convert().
  virtual double convert(int pin, bool high, double /*before*/, Cycle /*from*/, Cycle at) {
    return volts(pin, high, at);
  }
  /// FirmwarePort::supply_share().
  virtual double supply_share() { return 1.0; }
  /// The chip drives a pin in another way than before.
  virtual void driven(int pin, const PinDrive& drive, Cycle at) = 0;
  /// From now on changes of the pin's level are wanted as Chip::edge(), or no longer: changes of the level
  /// that this returns (where they are no longer wanted, it does not matter).
  virtual bool wants_edges(int pin, bool wanted, Cycle at) = 0;

  // --- serial lines: UARTs by their index in ChipSpec::uarts, then the USB's
  /// A frame begins to leave the chip.
  virtual void sent(int line, std::uint16_t data, Cycle at) = 0;
  /// What a received frame takes from now on; 0 = the receiver is off.
  virtual void listens(int line, Cycle frame, Cycle at) = 0;

  // --- the two-wire bus, at the end of each byte
  /// A device is addressed, seven bits and the direction: whether one answers.
  virtual bool two_wire_address(std::uint8_t address, Cycle at) = 0;
  /// Whether it acknowledges.
  virtual bool two_wire_write(std::uint8_t byte, Cycle at) = 0;
  virtual std::uint8_t two_wire_read(Cycle at) = 0;
  virtual void two_wire_stop(Cycle at) = 0;

  // --- memory that outlives the power
  virtual std::uint8_t* eeprom() = 0;
  /// The chip begins to write (or erase) a byte of it, which is done when it calls this.
  virtual void write_eeprom(std::uint16_t address, std::uint8_t value, Cycle at) = 0;

  // --- time
  /// The moment that was asked for by Chip::call_at() has come.
  virtual void called(Cycle at) = 0;
  /// From `at` the processor's clock runs at the oscillator's divided by `divisor` (CLKPR; a
  /// reset makes it 1 again).
  virtual void clock_divided(int divisor, Cycle at) = 0;
  /// The chip has reset itself: registers are as after power-on, memory is kept. `flags` are MCUSR's.
  virtual void was_reset(std::uint8_t flags, Cycle at) = 0;

 protected:
  ~Surroundings() = default;
};

}  // namespace robosim::avr
