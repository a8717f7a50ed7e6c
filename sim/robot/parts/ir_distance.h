// type = "ir-distance": Sharp's GP2Y0A21YK0F. Its voltage depends on where reflected infrared light falls on
// its detector, and thereby on the distance d.
//
//   d     0    30   40   50   60   80   100  150  200  300  400  500  600  700  800 mm
//   V     1.2  2.2  2.65 2.95 3.1  2.75 2.3  1.65 1.3  0.94 0.74 0.6  0.51 0.45 0.4
//
// The voltage is linear between these points. Data sheet E4-A00201EN states 2.3 V at 100 mm and 0.4 V at
// 800 mm; the other points are from its figure 2, for white paper. Below 60 mm the voltage falls again, so
// that a very near object looks far. Beyond 800 mm the voltage is inversely proportional to the distance.
//
// A measurement takes 38.3 ms. The output keeps the result during the next measurement, and is 0 V before the
// first result. The distance d is measured along a ray from the sensor's pose at the end of the measurement.
// The default of `noise` is an estimate.
#pragma once

#include "sim/base/noise.h"
#include "sim/robot/parts/mount.h"

namespace robosim::robot {

std::shared_ptr<const PartSpec> read_ir_distance(PartReader&);

/// Returns the voltage at a distance, by the table above.
double ir_volts(double metres);

class IrDistanceSpec final : public PartSpec {
 public:
  Pin pin = kNoPin;
  MountSpec mount;
  Parameter noise;  ///< V, standard deviation of a reading
  Parameter source_ohms;

  std::unique_ptr<Part> make(PartContext&) const override;
  std::vector<Gauge> gauges() const override { return {{name, "V"}}; }
  const MountSpec* mounted() const override { return &mount; }
};

class IrDistancePart final : public Part, public PinSource, public Breakable {
 public:
  IrDistancePart(const IrDistanceSpec&, PartContext&);

  void register_with(PartRegistry&) override;
  void resolve_mounts(const PartRegistry& registry) override { mount_.resolve_mounts(registry); }
  void begin_tick(SimTime) override;
  void read(std::vector<Reading>&) const override;

  Source output(SimTime, double supply) override;
  bool level(SimTime t) override { return output(t, supply_).volts > 0.5 * supply_; }

  const std::string& name() const override { return spec_.name; }
  std::span<const FaultKind> fault_kinds() const override;
  void fail(const Fault&) override;

 private:
  struct State {
    double held = 0.0;  // V
    SimTime measures_until;
    std::uint64_t samples = 0;
    bool dead = false;
  };

  const IrDistanceSpec& spec_;
  PartContext& context_;
  Mount mount_;
  const NoiseStream stream_;
  const double noise_, supply_, source_ohms_;
  State state_;
};

}  // namespace robosim::robot
