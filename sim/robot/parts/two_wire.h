// Common code of parts on the two-wire bus (I2C). These parts use the board's SDA and SCL, which the robot
// file need not name. `address` is a part's seven-bit address.
//
// The bus is simulated byte by byte, without pull-ups, clock stretching, or devices that hold a line low. A
// sketch that implements the bus in software (bit-banging) finds no device. Neither does firmware on the
// target stm32, whose I2C peripherals are modelled without devices on the bus (sim/exec/stm32/i2c.h).
#pragma once

#include <array>
#include <cstdint>

#include "sim/robot/part.h"
#include "sim/robot/part_context.h"
#include "sim/robot/part_reader.h"

namespace robosim::robot {

/// Reads `address`, and wires the part to the bus.
std::uint8_t read_two_wire(PartReader&, int usual_address);

/// A device with registers. The first byte written is a register's number; further bytes go to that register
/// and to the following registers. Reads continue at the next register in this order.
class RegisterDevice : public TwoWireDevice {
 public:
  /// State that each device adds to the part's state.
  struct Cursor {
    std::uint8_t number = 0;
    bool numbered = false;  ///< a register number has been received since the device was addressed
  };

  bool address(std::uint8_t address, bool reads, SimTime) final;
  bool write(std::uint8_t byte, SimTime t) final;
  std::uint8_t read(SimTime t) final;

 protected:
  RegisterDevice(std::uint8_t address, Cursor& cursor) : address_(address), cursor_(cursor) {}
  ~RegisterDevice() = default;

  virtual void set(std::uint8_t number, std::uint8_t value, SimTime t) = 0;
  virtual std::uint8_t get(std::uint8_t number, SimTime t) = 0;
  /// Returns the register number for the first byte of a transfer.
  virtual std::uint8_t numbered(std::uint8_t byte) const { return byte; }
  /// Returns the register that follows register `number`.
  virtual std::uint8_t behind(std::uint8_t number) const { return static_cast<std::uint8_t>(number + 1); }
  /// Freezes the measurement, so that its bytes are consistent. The bus calls this function before each
  /// transfer.
  virtual void hold(SimTime) {}

 private:
  const std::uint8_t address_;
  Cursor& cursor_;
};

}  // namespace robosim::robot
