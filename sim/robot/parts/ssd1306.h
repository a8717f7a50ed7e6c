// type = "ssd1306": a graphic OLED display (Solomon Systech data sheet, revision 1.1), 128 pixels wide and 64
// or 32 high, on I2C.
//
//   control byte   0x00: commands follow; 0x40: data follows; 0x80: one command follows; 0xC0: one data
//                  byte follows; after such a single byte, another control byte follows
//   memory         8 pages of 128 bytes, the lowest bit of each byte on top
//   addressing     by page (after power-on), horizontal, vertical; the last two wrap within the columns and
//                  pages that the commands 0x21 and 0x22 set
//
// A picture is reported when it has changed and then stayed the same for 50 ms: "212 lit in 0,0 to 63,15: Lap
// 2|12.4 s". The report contains the number of lit pixels, their bounding box (x and y of two corners), and
// any text (pixel_text.h). Mirroring (segment remap, COM direction) is ignored: the picture is reported as if
// both were set, since libraries set both.
//
// The command for inverse display inverts the reported pixels. Not modelled: scrolling, contrast, the start
// line.
#pragma once

#include <vector>

#include "sim/robot/parts/settled_text.h"
#include "sim/robot/parts/two_wire.h"

namespace robosim::robot {

std::shared_ptr<const PartSpec> read_ssd1306(PartReader&);

class Ssd1306Spec final : public PartSpec {
 public:
  std::uint8_t address = 0;
  int height = 64;

  std::unique_ptr<Part> make(PartContext&) const override;
  std::vector<Gauge> gauges() const override { return {{name, "lit"}}; }
};

class Ssd1306Part final : public Part, public TwoWireDevice, public TextOutput {
 public:
  static constexpr int kWidth = 128, kPages = 8;

  Ssd1306Part(const Ssd1306Spec&, PartContext&);

  void register_with(PartRegistry&) override;
  bool address(std::uint8_t address, bool, SimTime) override;
  bool write(std::uint8_t byte, SimTime t) override;
  /// Returns the status; bit 6 is set while the display is off.
  std::uint8_t read(SimTime) override { return state_.on ? 0x00 : 0x40; }
  const std::string& name() const override { return spec_.name; }
  std::string poll_text(SimTime) override;
  /// Appends the number of lit pixels.
  void read(std::vector<Reading>&) const override;
  bool lit(int x, int y) const;

 private:
  enum class Expects : std::uint8_t { control, command, commands, data_byte, data };

  void command(std::uint8_t byte);
  void carry_out();
  void put(std::uint8_t byte);
  std::string picture() const;

  struct State {
    std::array<std::uint8_t, kWidth * kPages> memory{};
    Expects expects = Expects::control;
    std::array<std::uint8_t, 7> words{};  // a command and its arguments
    int count = 0, wanted = 0;
    bool on = false, inverse = false, all = false;
    int mode = 2;  // 0 horizontal, 1 vertical, 2 by page
    int column = 0, page = 0;
    int first_column = 0, last_column = kWidth - 1, first_page = 0, last_page = kPages - 1;
    SimTime changed_at = 0;
    SettledText text;
  };

  const Ssd1306Spec& spec_;
  PartContext& context_;
  State state_;
};

}  // namespace robosim::robot
