// type = "ws2812": a strip of LEDs with a controller each, on one data pin (NeoPixel).
//
//   bit 0   high 0.35 us, low 0.8 us       bit 1   high 0.7 us, low 0.6 us     each +- 0.15 us
//   reset   low for 50 us: shows what came since the last one
//
// A bit is a 1 if it is high for 0.55 us or longer. 24 of them, green, red, blue, the highest first, belong
// to one LED, and the rest goes on to the next (WorldSemi data sheet WS2812). Newer strips take 280 us for a
// reset, which they get where a sketch waits as its library does. Colours are reported as an event, RRGGBB
// per LED, when they have changed and stayed for 50 ms.
//
// Only an emulated chip makes pulses so short by loops. On the target host the library's stand-in makes them.
#pragma once

#include "sim/robot/part.h"
#include "sim/robot/part_context.h"
#include "sim/robot/part_reader.h"

namespace robosim::robot {

std::shared_ptr<const PartSpec> read_ws2812(PartReader&);

class Ws2812Spec final : public PartSpec {
 public:
  Pin pin = kNoPin;
  int leds = 1;

  std::unique_ptr<Part> make(PartContext&) const override;
  std::vector<Gauge> gauges() const override { return {{name, "lit"}}; }
};

class Ws2812Part final : public Part, public PinWatcher, public TextOutput {
 public:
  Ws2812Part(const Ws2812Spec&, PartContext&);

  void register_with(PartRegistry&) override;
  void pin_changed(Pin, const PinDrive&, SimTime) override;
  const std::string& name() const override { return spec_.name; }
  std::string poll_text(SimTime) override;
  /// Returns the number of lit LEDs.
  void read(std::vector<Reading>&) const override;

 private:
  void show();

  struct State {
    bool high = false;
    SimTime since = 0;                  // beginning of `high`
    std::vector<std::uint32_t> coming;  // GRB
    int bits = 0;                       // in the last of `coming`
    std::vector<std::uint32_t> shown;
    SimTime changed_at = kNever;  // kNever = it has been reported
  };

  const Ws2812Spec& spec_;
  PartContext& context_;
  State state_;
};

}  // namespace robosim::robot
