// type = "ws2812": a strip of LEDs with one controller each, on one data pin (NeoPixel).
//
//   bit 0   high 0.35 us, low 0.8 us       bit 1   high 0.7 us, low 0.6 us     each +- 0.15 us
//   reset   low for 50 us: shows the bits since the last reset
//
// A bit is a 1 if it is high for 0.55 us or longer. Each LED uses 24 bits: green, red and blue, each with the
// highest bit first. The LED passes all further bits to the next LED (WorldSemi data sheet WS2812). Newer
// strips need 280 us for a reset; their libraries wait for that time. Colours are reported as an event,
// RRGGBB per LED, when they have changed and then stayed the same for 50 ms.
//
// Only firmware on an emulated chip can make such short pulses in loops. On the target host, the replacement
// for the Adafruit_NeoPixel library (hal/libraries) makes the pulses.
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
  /// Appends the number of lit LEDs.
  void read(std::vector<Reading>&) const override;

 private:
  void show();

  struct State {
    bool high = false;
    SimTime since = 0;                  // time of the last level change
    std::vector<std::uint32_t> coming;  // GRB
    int bits = 0;                       // number of bits in the last element of `coming`
    std::vector<std::uint32_t> shown;
    SimTime changed_at = kNever;  // kNever = the change has been reported
  };

  const Ws2812Spec& spec_;
  PartContext& context_;
  State state_;
};

}  // namespace robosim::robot
