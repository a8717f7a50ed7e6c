// The board as firmware sees it. Executors call this interface, and images of the host target through theirs.
#pragma once

#include "hal/board/board.h"

namespace robosim {

class FirmwarePort {
 public:
  virtual const BoardSpec& spec() const = 0;
  /// Changes how `pin` is driven. Watchers are called if that differs from before.
  virtual void set_drive(Pin pin, const PinDrive& drive, SimTime t) = 0;
  /// Returns the result of a digital read of `pin`: its source's level. An output returns its own level; an
  /// unconnected pin is high with a pull-up and low without.
  virtual bool read_level(Pin pin, SimTime t) = 0;
  /// Reads a pin as part of its whole port. The firmware may or may not use this pin's level.
  virtual bool read_along(Pin pin, SimTime t) = 0;
  /// Returns the volts on `pin` at the moment when the ADC samples it. Unconnected: as read_level, at 0 V or
  /// the supply.
  virtual double read_volts(Pin pin, SimTime t) = 0;
  /// Returns the volts on the capacitor of an AVR's ADC. It had `before` volts, and the pin has charged it
  /// since `from`: adc_capacitor.h.
  virtual double convert(Pin pin, double /*before*/, SimTime /*from*/, SimTime t) {
    return read_volts(pin, t);
  }
  /// Returns the board's supply as a share of spec().supply_volts. Volts on pins are returned as if it had
  /// not dropped: increased by the same factor by which a reference from the supply has decreased.
  virtual double supply_share() { return 1.0; }
  virtual void send_byte(uint8_t byte, SimTime t) = 0;
  /// Sends a START and an address byte on the two-wire bus (I2C), at its end: seven bits of address, and 1 in
  /// the lowest bit if the device is to send. Returns whether a device answers.
  virtual bool two_wire_address(uint8_t address, SimTime t) = 0;
  /// Sends a byte to the device, and returns whether it acknowledges it.
  virtual bool two_wire_write(uint8_t byte, SimTime t) = 0;
  /// Returns a byte from the device; 0xFF without one.
  virtual uint8_t two_wire_read(SimTime t) = 0;
  virtual void two_wire_stop(SimTime t) = 0;
  /// Returns the non-volatile memory, of spec().eeprom_bytes; 0xFF when new. Survives power cycles.
  virtual uint8_t* eeprom() = 0;
  /// Begins to write a byte of it; `address` is below spec().eeprom_bytes.
  virtual void write_eeprom(uint16_t address, uint8_t value, SimTime t) = 0;

 protected:
  ~FirmwarePort() = default;
};

}  // namespace robosim
