// type = "tcs34725": a light-to-digital converter with red, green, blue and clear (TAOS data sheet TAOS135),
// looking down at the floor beside its own white LED.
//
//   command byte   0x80 | register; the next byte is that of the next one, whatever bit 5 says: libraries
//   read
//                  words without it
//   integration    2.4 ms (256 - ATIME); at most 1024 counts for each 2.4 ms, or 65535
//   counts         full scale x gain (1, 4, 16, 60) x share; share = white 0.008, on black 1/10 of that, and
//                  between by what comes back of its colour (grid/colour.h); red 0.36, green 0.36, blue 0.28
//                  of it, and clear their sum
//
// The shares are our estimate of a breakout some millimetres above paper. It integrates while PON and AEN are
// set (ENABLE = 3); each ending sets AVALID. Not modelled: interrupts, waiting, noise.
#pragma once

#include "sim/robot/parts/two_wire.h"

namespace robosim::robot {

std::shared_ptr<const PartSpec> read_tcs34725(PartReader&);

class Tcs34725Spec final : public PartSpec {
 public:
  std::uint8_t address = 0;
  Vec2 at;                 ///< m, forward and left of the axle's centre
  double footprint = 0.0;  ///< m, the diameter that it sees

  std::unique_ptr<Part> make(PartContext&) const override;
  std::vector<Gauge> gauges() const override { return {{name, "counts"}}; }
};

class Tcs34725Part final : public Part, public RegisterDevice {
 public:
  Tcs34725Part(const Tcs34725Spec&, PartContext&);

  void join(Roster&) override;
  void begin_tick(SimTime) override;
  /// The counts of clear.
  void read(std::vector<Reading>&) const override;
  using RegisterDevice::read;

 private:
  void set(std::uint8_t number, std::uint8_t value, SimTime t) override;
  std::uint8_t get(std::uint8_t number, SimTime) override { return state_.registers[number & 0x1F]; }
  SimTime integration() const;
  void measure(SimTime t);

  struct State {
    std::array<std::uint8_t, 32> registers{};
    Cursor cursor;
    SimTime ready_at = kNever;
    double clear = 0.0;
  };

  const Tcs34725Spec& spec_;
  PartContext& context_;
  State state_;
};

}  // namespace robosim::robot
