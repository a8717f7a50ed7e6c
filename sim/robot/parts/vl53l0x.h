// type = "vl53l0x": a time-of-flight distance sensor (ST data sheet DS11555), with the features that its
// usual libraries need. Its registers are not documented; their meaning is derived from ST's own driver.
//
//   0xC0 to 0xC2   model and revision: 0xEE, 0xAA, 0x10
//   0x00           bit 0 starts a measurement, and always reads 0; bits 1 and 2 start repeated measurements
//   0x13           bits 0 to 2: a measurement is ready; a write to 0x0B clears them
//   0x1E, 0x1F     the last result, mm; 8190 if nothing is near
//   0x83           never 0, since the driver's start-up waits until this register is not 0
//
// A measurement takes 33 ms (the default timing budget, 2.7.4), whatever budget the firmware sets. The
// distance is measured along one ray, up to `reach` (1.2 m; table 12: 80 cm on grey to 2 m on white), with a
// standard deviation of 4 % in the profile `typical` (table 13). Other registers store any value written; all
// register pages share them.
#pragma once

#include "sim/base/noise.h"
#include "sim/robot/parts/mount.h"
#include "sim/robot/parts/two_wire.h"

namespace robosim::robot {

std::shared_ptr<const PartSpec> read_vl53l0x(PartReader&);

class Vl53l0xSpec final : public PartSpec {
 public:
  std::uint8_t address = 0;
  MountSpec mount;
  Parameter reach;  ///< m
  Parameter noise;  ///< share of the distance, standard deviation

  std::unique_ptr<Part> make(PartContext&) const override;
  std::vector<Gauge> gauges() const override { return {{name, "mm"}}; }
  const MountSpec* mounted() const override { return &mount; }
};

class Vl53l0xPart final : public Part, public RegisterDevice {
 public:
  Vl53l0xPart(const Vl53l0xSpec&, PartContext&);

  void register_with(PartRegistry&) override;
  void resolve_mounts(const PartRegistry& registry) override { mount_.resolve_mounts(registry); }
  void begin_tick(SimTime) override;
  /// Appends the last measurement, mm.
  void read(std::vector<Reading>&) const override;
  using RegisterDevice::read;

 private:
  void set(std::uint8_t number, std::uint8_t value, SimTime t) override;
  std::uint8_t get(std::uint8_t number, SimTime) override { return state_.registers[number]; }

  struct State {
    std::array<std::uint8_t, 256> registers{};
    Cursor cursor;
    SimTime ready_at = kNever;
    bool goes_on = false;
    std::uint64_t samples = 0;
    int millimetres = 0;
  };

  const Vl53l0xSpec& spec_;
  PartContext& context_;
  Mount mount_;
  const NoiseStream stream_;
  const double reach_, noise_;
  State state_;
};

}  // namespace robosim::robot
