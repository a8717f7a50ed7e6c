// type = "current-sensor": an ACS712 in the motors' supply. It measures the motors' current from the battery.
//
//   V = half the supply + `per_amp` i, at most the supply; i = mean current in the last tick, A
//
// Source: Allegro's ACS712 data sheet: 185 mV per ampere (5 A type), 100 (20 A), 66 (30 A) at 5 V; noise of
// 21 mV peak to peak (5 A type), about 4 mV rms. The board's own current is not included.
#pragma once

#include "sim/base/noise.h"
#include "sim/robot/part.h"
#include "sim/robot/part_context.h"
#include "sim/robot/part_reader.h"

namespace robosim::robot {

std::shared_ptr<const PartSpec> read_current_sensor(PartReader&);

class CurrentSensorSpec final : public PartSpec {
 public:
  Pin pin = kNoPin;
  Parameter per_amp;  ///< V per ampere
  Parameter noise;    ///< V, standard deviation
  Parameter source_ohms;

  std::unique_ptr<Part> make(PartContext&) const override;
  std::vector<Gauge> gauges() const override { return {{name, "A"}}; }
};

class CurrentSensorPart final : public Part, public PinSource, public Breakable {
 public:
  CurrentSensorPart(const CurrentSensorSpec&, PartContext&);

  void register_with(PartRegistry&) override;
  void begin_tick(SimTime) override;
  void read(std::vector<Reading>&) const override;

  Source output(SimTime, double supply) override;
  bool level(SimTime t) override { return output(t, supply_).volts > 0.5 * supply_; }

  const std::string& name() const override { return spec_.name; }
  std::span<const FaultKind> fault_kinds() const override;
  void fail(const Fault&) override;

 private:
  struct State {
    double energy = 0.0;  // J, net energy that the motors have drawn up to the last tick
    double amps = 0.0;
    std::uint64_t samples = 0;
    bool dead = false;
  };

  const CurrentSensorSpec& spec_;
  PartContext& context_;
  const NoiseStream stream_;
  const double per_amp_, noise_, supply_, source_ohms_;
  State state_;
};

}  // namespace robosim::robot
