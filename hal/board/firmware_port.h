// The firmware's view of the board. Executors call this interface. On the target `host`, the firmware's image
// calls it, too.
#pragma once

#include "hal/board/board.h"

namespace robosim {

class FirmwarePort {
 public:
  virtual const BoardSpec& spec() const = 0;
  /// Changes how `pin` is driven. Watchers are called if the drive has changed.
  virtual void set_drive(Pin pin, const PinDrive& drive, SimTime t) = 0;
  /// Returns the result of a digital read of `pin`. An input pin has the level of its source, and an output
  /// pin has the level that it drives. An unconnected input is high with a pull-up and low without a pull-up.
  virtual bool read_level(Pin pin, SimTime t) = 0;
  /// Returns the level of `pin`, for a read of the complete port. The firmware may or may not use this pin's
  /// level.
  virtual bool read_along(Pin pin, SimTime t) = 0;
  /// Returns the source on `pin` at the moment when the ADC or the comparator samples the pin. A pin without
  /// a source is at the supply voltage if read_level() returns true, else at 0 V.
  virtual Source read_source(Pin pin, SimTime t) = 0;
  double read_volts(Pin pin, SimTime t) { return read_source(pin, t).volts; }
  /// Returns the present supply voltage, which drops with a weak battery. The reference is valid as long as
  /// the board, and follows all changes.
  virtual const double& supply_volts() const = 0;
  virtual void send_byte(uint8_t byte, SimTime t) = 0;
  /// Sends a START and an address byte on the two-wire bus (I2C). The byte ends at `t`. Its upper seven bits
  /// are the address. Its lowest bit is 1 if the device shall send. Returns whether a device answers.
  virtual bool two_wire_address(uint8_t address, SimTime t) = 0;
  /// Sends a byte to the device, and returns whether the device acknowledges it.
  virtual bool two_wire_write(uint8_t byte, SimTime t) = 0;
  /// Returns a byte from the device, or 0xFF without a device.
  virtual uint8_t two_wire_read(SimTime t) = 0;
  virtual void two_wire_stop(SimTime t) = 0;
  /// Returns the spec().eeprom_bytes bytes of the EEPROM, which survive power cycles. New bytes are 0xFF.
  virtual uint8_t* eeprom() = 0;
  /// Begins to write a byte of EEPROM; `address` is below spec().eeprom_bytes.
  virtual void write_eeprom(uint16_t address, uint8_t value, SimTime t) = 0;

 protected:
  ~FirmwarePort() = default;
};

}  // namespace robosim
