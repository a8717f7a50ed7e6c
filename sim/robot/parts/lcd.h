// type = "lcd": a character display whose HD44780 (hd44780.h) is wired to pins, with 4 or 8 data lines. R/W
// is wired to a pin or to ground. Text that has stayed the same for 50 ms is reported as an event, with its
// lines joined by "|". A pulse on E (enable) counts if it lasts at least 230 ns. A sketch that reads the busy
// flag (R/W high) always finds the display ready.
//
// Not modelled: contrast, backlight, and the first 40 ms after power-on, in which a real display ignores
// input.
#pragma once

#include "sim/robot/part.h"
#include "sim/robot/part_context.h"
#include "sim/robot/part_reader.h"
#include "sim/robot/parts/hd44780.h"
#include "sim/robot/parts/settled_text.h"

namespace robosim::robot {

std::shared_ptr<const PartSpec> read_lcd(PartReader&);

class LcdSpec final : public PartSpec {
 public:
  Pin rs = kNoPin;
  Pin enable = kNoPin;
  Pin rw = kNoPin;        ///< kNoPin = wired to ground
  std::vector<Pin> data;  ///< D4 to D7, or D0 to D7
  int columns = 16;
  int rows = 2;

  std::unique_ptr<Part> make(PartContext&) const override;
};

class LcdPart final : public Part, public PinWatcher, public TextOutput {
 public:
  LcdPart(const LcdSpec&, PartContext&);

  void register_with(PartRegistry&) override;
  void pin_changed(Pin, const PinDrive&, SimTime) override;
  const std::string& name() const override { return spec_.name; }
  std::string poll_text(SimTime) override;
  /// Appends 1 while the display shows text, else 0.
  void read(std::vector<Reading>&) const override;

 private:
  bool high(Pin pin) const;

  struct State {
    Hd44780 controller;
    bool enabled = false;
    SimTime since = 0;  // time at which E rose
    SettledText text;
  };

  const LcdSpec& spec_;
  PartContext& context_;
  State state_;
};

}  // namespace robosim::robot
