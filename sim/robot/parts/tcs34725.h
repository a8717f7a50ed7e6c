// type = "tcs34725": a light-to-digital converter with red, green, blue and clear channels (TAOS data sheet
// TAOS135). The sensor and its own white LED look down at the floor.
//
//   command byte   0x80 | register; the next byte belongs to the next register, even without bit 5
//                  (auto-increment), since libraries read words without that bit
//   integration    2.4 ms (256 - ATIME); at most 1024 counts per 2.4 ms, and 65535 in total
//   counts         full scale x gain (1, 4, 16, 60) x share
//   share          on white 0.008 x (red 0.36, green 0.36, blue 0.28), on black a tenth; on other colours
//                  in between, by their reflectance (sim/map/colour.h); clear is the sum of the three
//
// The shares are estimated for a breakout board a few millimetres above paper. The sensor integrates while
// PON and AEN are set (ENABLE = 3); the end of each integration sets AVALID. Not modelled: interrupts,
// the wait time, noise.
#pragma once

#include "sim/robot/parts/two_wire.h"

namespace robosim::robot {

std::shared_ptr<const PartSpec> read_tcs34725(PartReader&);

class Tcs34725Spec final : public PartSpec {
 public:
  std::uint8_t address = 0;
  Vec2 at;                 ///< m, forward and left of the axle's centre
  double footprint = 0.0;  ///< m, diameter of the sensor's field of view

  std::unique_ptr<Part> make(PartContext&) const override;
  std::vector<Gauge> gauges() const override { return {{name, "counts"}}; }
};

class Tcs34725Part final : public Part, public RegisterDevice {
 public:
  Tcs34725Part(const Tcs34725Spec&, PartContext&);

  void register_with(PartRegistry&) override;
  void begin_tick(SimTime) override;
  /// Appends the counts of the clear channel.
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
    world::FloorProbe probe;
  };

  const Tcs34725Spec& spec_;
  PartContext& context_;
  State state_;
};

}  // namespace robosim::robot
