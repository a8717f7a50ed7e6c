// The firmware's view of the board. Executors call this interface; host images call it through executors.
#pragma once

#include "hal/board/board.h"

namespace robosim {

class FirmwarePort {
 public:
  virtual const BoardSpec& spec() const = 0;
  /// Changes how `pin` is driven. Watchers are called if the drive has changed.
  virtual void set_drive(Pin pin, const PinDrive& drive, SimTime t) = 0;
  /// Returns the result of a digital read of `pin`: the level of its source. An output returns its own level;
  /// an unconnected pin is high with a pull-up and low without.
  virtual bool read_level(Pin pin, SimTime t) = 0;
  /// Reads a pin as part of its whole port. The firmware may or may not use this pin's level.
  virtual bool read_along(Pin pin, SimTime t) = 0;
  /// Returns the volts on `pin` at the moment when the ADC samples it. An unconnected pin is at 0 V or the
  /// supply, as for read_level().
  virtual double read_volts(Pin pin, SimTime t) = 0;
  /// Returns the volts on the capacitor of an AVR's ADC (adc_capacitor.h). The capacitor had `before` volts,
  /// and the pin has charged it since `from`.
  virtual double convert(Pin pin, double /*before*/, SimTime /*from*/, SimTime t) {
    return read_volts(pin, t);
  }
  /// Returns the board's supply as a share of spec().supply_volts. Volts on pins are returned divided by this
  /// share. A reference that equals the supply then counts as nominal.
  virtual double supply_share() { return 1.0; }
  virtual void send_byte(uint8_t byte, SimTime t) = 0;
  /// Sends a START and an address byte on the two-wire bus (I2C), which end at `t`. The byte has a seven-bit
  /// address, and 1 in the lowest bit if the device is to send. Returns whether a device answers.
  virtual bool two_wire_address(uint8_t address, SimTime t) = 0;
  /// Sends a byte to the device, and returns whether the device acknowledges it.
  virtual bool two_wire_write(uint8_t byte, SimTime t) = 0;
  /// Returns a byte from the device, or 0xFF without a device.
  virtual uint8_t two_wire_read(SimTime t) = 0;
  virtual void two_wire_stop(SimTime t) = 0;
  /// Returns the EEPROM's spec().eeprom_bytes bytes, which survive power cycles; 0xFF when new.
  virtual uint8_t* eeprom() = 0;
  /// Begins to write a byte of EEPROM; `address` is below spec().eeprom_bytes.
  virtual void write_eeprom(uint16_t address, uint8_t value, SimTime t) = 0;

 protected:
  ~FirmwarePort() = default;
};

}  // namespace robosim
