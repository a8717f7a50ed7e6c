// The firmware's view of the board, grouped by function. Executors call these interfaces. On the target
// `host`, the firmware's image calls them, too. The shortest example of a board is BreadBoard in
// tests/unit/board/bread_board_test.cpp.
//
// Contract of all calls:
//   - `t` is the present time, in ns since power-on. It may be earlier than the previous call's time by at
//     most one instruction.
//   - Any `pin` is allowed. A pin that the board does not have is low, and its drive has no effect.
//   - A call may call watchers and parts, which may call RobotPort. They must not call these interfaces.
//   - No call blocks, throws, or stores a reference to its arguments.
#pragma once

#include "hal/board/board.h"

namespace robosim {

/// The pins of a board.
class PinPort {
 public:
  /// Changes how `pin` is driven. If the drive has changed, watchers are called before this call returns.
  virtual void set_drive(Pin pin, const PinDrive& drive, SimTime t) = 0;
  /// Returns the result of a digital read of `pin`. An input pin has the level of its source, and an output
  /// pin has the level that it drives. An unconnected input is high with a pull-up and low without a pull-up.
  /// Each call may have another result, because sensors are noisy.
  virtual bool read_level(Pin pin, SimTime t, ReadIntent intent = ReadIntent::pin) = 0;
  /// Returns the source on `pin` at the moment when the ADC or the comparator samples the pin. A pin without
  /// a source is at the supply voltage if read_level() returns true, else at 0 V. Each call may have another
  /// result.
  virtual Source read_source(Pin pin, SimTime t) = 0;
  double read_volts(Pin pin, SimTime t) { return read_source(pin, t).volts; }
  /// Returns the present supply voltage, which drops with a weak battery. The reference is valid as long as
  /// the board, and follows all changes.
  virtual const double& supply_volts() const = 0;

 protected:
  ~PinPort() = default;
};

/// The UART that is connected to the computer.
class SerialPort {
 public:
  /// Sends a byte, which the firmware has written at `t`. The call returns at once. The caller waits for the
  /// byte's duration before the next call.
  virtual void send_byte(uint8_t byte, SimTime t) = 0;

 protected:
  ~SerialPort() = default;
};

/// The two-wire bus (I2C), with the chip as its only master.
class TwoWirePort {
 public:
  /// Sends a START and an address byte. The byte ends at `t`. Its upper seven bits are the address. Its
  /// lowest bit is 1 if the device shall send. Returns whether a device answers. This device is addressed
  /// until the next START or STOP.
  virtual bool two_wire_address(uint8_t address, SimTime t) = 0;
  /// Sends a byte to the addressed device, and returns whether the device acknowledges it.
  virtual bool two_wire_write(uint8_t byte, SimTime t) = 0;
  /// Returns a byte from the addressed device, or 0xFF without a device.
  virtual uint8_t two_wire_read(SimTime t) = 0;
  virtual void two_wire_stop(SimTime t) = 0;

 protected:
  ~TwoWirePort() = default;
};

/// The memory that survives power cycles.
class EepromPort {
 public:
  /// Returns a byte of EEPROM; `address` is below spec().eeprom_bytes. New bytes are 0xFF.
  virtual uint8_t read_eeprom(uint16_t address) const = 0;
  /// Begins to write a byte of EEPROM. read_eeprom() returns the new value at once. The caller waits
  /// kEepromWriteTime before the next call.
  virtual void write_eeprom(uint16_t address, uint8_t value, SimTime t) = 0;

 protected:
  ~EepromPort() = default;
};

class FirmwarePort : public PinPort, public SerialPort, public TwoWirePort, public EepromPort {
 public:
  /// Returns the board's description, which is valid as long as the board.
  virtual const BoardSpec& spec() const = 0;

 protected:
  ~FirmwarePort() = default;
};

}  // namespace robosim
