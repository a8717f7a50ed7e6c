// The board as firmware sees it. Executors call this interface, and images of the host target through theirs.
#pragma once

#include "hal/board/board.h"

namespace robosim {

class FirmwarePort {
 public:
  virtual const BoardSpec& spec() const = 0;
  /// The firmware changes how it drives `pin`. Watchers hear of it if it differs from before.
  virtual void set_drive(Pin pin, const PinDrive& drive, SimTime t) = 0;
  /// What a digital read of `pin` gives: its source; an output reads back its own level; an unconnected pin
  /// reads high with a pull-up and low without.
  virtual bool read_level(Pin pin, SimTime t) = 0;
  /// The same of a pin that may have been read only because its whole port was: nobody knows whether the
  /// firmware looks at it.
  virtual bool read_along(Pin pin, SimTime t) = 0;
  /// Volts on `pin` at the moment the ADC samples it. Unconnected: as read_level, at 0 V or the supply.
  virtual double read_volts(Pin pin, SimTime t) = 0;
  /// The same for the capacitor of an AVR's ADC, with `before` volts on it, which the pin has charged since
  /// `from`: adc_capacitor.h.
  virtual double convert(Pin pin, double /*before*/, SimTime /*from*/, SimTime t) {
    return read_volts(pin, t);
  }
  /// What is left of the board's supply, as a share of spec().supply_volts. Volts on pins are told as if it
  /// had not sunk: as many times more as a reference that is the supply has become less.
  virtual double supply_share() { return 1.0; }
  virtual void send_byte(uint8_t byte, SimTime t) = 0;
  /// On the two-wire bus (I2C), at the end of each byte. After a START: seven bits of address, and 1 at the
  /// bottom if the device is to send. Gives whether one answers.
  virtual bool two_wire_address(uint8_t address, SimTime t) = 0;
  /// A byte for the device; whether it acknowledges.
  virtual bool two_wire_write(uint8_t byte, SimTime t) = 0;
  /// A byte of the device; 0xFF if there is none.
  virtual uint8_t two_wire_read(SimTime t) = 0;
  virtual void two_wire_stop(SimTime t) = 0;
  /// Non-volatile memory, of spec().eeprom_bytes; 0xFF when new. Survives power cycles.
  virtual uint8_t* eeprom() = 0;
  /// The firmware begins to write a byte of it; `address` is below spec().eeprom_bytes.
  virtual void write_eeprom(uint16_t address, uint8_t value, SimTime t) = 0;

 protected:
  ~FirmwarePort() = default;
};

}  // namespace robosim
