// type = "lcd-i2c": a character display with an HD44780 (hd44780.h) on a PCF8574 port expander (Texas
// Instruments, SCPS068). Each byte written is the state of the expander's eight pins, which are wired as on
// common backpacks:
//
//   P0 RS    P1 R/W    P2 E    P3 backlight    P4 to P7 D4 to D7
//
// The display reads data on E's falling edge. Text is reported as for an `lcd`. A read transfer returns the
// last byte written. Libraries for such backpacks do not read the busy flag: at 100 kHz a byte takes longer
// than the display is busy.
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

class LcdI2cPart final : public Part, public TwoWireDevice, public TextOutput {
 public:
  LcdI2cPart(const LcdI2cSpec&, PartContext&);

  void register_with(PartRegistry&) override;
  bool address(std::uint8_t address, bool, SimTime) override { return address == spec_.address; }
  bool write(std::uint8_t byte, SimTime t) override;
  std::uint8_t read(SimTime) override { return state_.pins; }
  const std::string& name() const override { return spec_.name; }
  std::string poll_text(SimTime) override;
  /// Appends 1 while the display shows text, else 0.
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
