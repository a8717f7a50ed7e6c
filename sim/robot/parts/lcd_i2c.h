// type = "lcd-i2c": a character display with an HD44780 (hd44780.h) behind a PCF8574 port expander (Texas
// Instruments, SCPS068): each byte that is written is the state of its eight pins, wired as the usual
// backpacks are:
//
//   P0 RS    P1 R/W    P2 E    P3 backlight    P4 to P7 D4 to D7
//
// Data is taken where E falls. It is told as an `lcd` is. What is read is what was written: nobody on such a
// backpack reads the busy flag, for at 100 kHz a byte takes longer than the display is busy.
#pragma once

#include "sim/robot/parts/hd44780.h"
#include "sim/robot/parts/settled_text.h"
#include "sim/robot/parts/two_wire.h"

namespace robosim::robot {

std::shared_ptr<const PartSpec> read_lcd_i2c(PartReader&);

class LcdI2cSpec final : public PartSpec {
 public:
  std::uint8_t address = 0;
  int columns = 16;
  int rows = 2;

  std::unique_ptr<Part> make(PartContext&) const override;
};

class LcdI2cPart final : public Part, public TwoWireDevice, public Teller {
 public:
  LcdI2cPart(const LcdI2cSpec&, PartContext&);

  void join(Roster&) override;
  bool address(std::uint8_t address, bool, SimTime) override { return address == spec_.address; }
  bool write(std::uint8_t byte, SimTime t) override;
  std::uint8_t read(SimTime) override { return state_.pins; }
  const std::string& name() const override { return spec_.name; }
  std::string tell(SimTime) override;
  /// 1 while it shows something.
  void read(std::vector<Reading>&) const override;

 private:
  struct State {
    Hd44780 controller;
    std::uint8_t pins = 0xFF;
    SettledText text;
  };

  const LcdI2cSpec& spec_;
  PartContext& context_;
  State state_;
};

}  // namespace robosim::robot
