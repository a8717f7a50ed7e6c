// type = "hc-sr04": measures a distance by the travel time of sound.
//
//   trig  __/‾‾\_________________________________   10 us or longer
//   burst      ||||||||                             8 periods of 40 kHz
//   echo  ______________/‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾\______  the travel time of sound, there and back
//              |  450 us |      2 d / v      |
//
// d is the distance to the nearest point of a wall, obstacle, map edge or other robot in the beam. The
// distance is measured when the trigger ends. v = 343 m/s (air at 20 degrees). The echo lasts 38 ms if
// nothing is within `reach` (default 4 m). An object nearer than 20 mm counts as 20 mm. A trigger before the
// end of an echo is ignored. With `pins = { sig }`, trigger and echo share one wire.
//
// Sources: Elecfreaks' data sheet (trigger of 10 us, burst of 8 periods, range of 2 cm to 4 m, beam of 15
// degrees, accuracy of 3 mm). The data sheet states neither the time before the echo rises nor the 38 ms.
// Users of modules measured both: 0.25 to 0.5 ms (clones 2.3 ms), and 38 to 200 ms.
//
// Not modelled: echoes that oblique walls deflect, soft objects, and other robots' sound.
#pragma once

#include "sim/base/noise.h"
#include "sim/robot/parts/mount.h"

namespace robosim::robot {

std::shared_ptr<const PartSpec> read_ultrasonic(PartReader&);

class UltrasonicSpec final : public PartSpec {
 public:
  Pin trig = kNoPin;
  Pin echo = kNoPin;  ///< equal to trig with one wire
  MountSpec mount;
  double beam = 0.0;  ///< rad, full angle
  Parameter reach;    ///< m
  Parameter noise;    ///< m, standard deviation

  std::unique_ptr<Part> make(PartContext&) const override;
  std::vector<Gauge> gauges() const override { return {{name, "cm"}}; }
  const MountSpec* mounted() const override { return &mount; }
};

class UltrasonicPart final : public Part, public PinSource, public PinWatcher, public Breakable {
 public:
  UltrasonicPart(const UltrasonicSpec&, PartContext&);

  void register_with(PartRegistry&) override;
  void resolve_mounts(const PartRegistry& registry) override { mount_.resolve_mounts(registry); }
  void begin_tick(SimTime) override;
  /// Appends the last result in cm; 0 before the first result, or if nothing was within reach.
  void read(std::vector<Reading>&) const override;

  bool level(SimTime t) override { return t >= state_.rises && t < state_.falls; }
  SimTime same_until(SimTime t) override {
    return t < state_.rises ? state_.rises : t < state_.falls ? state_.falls : kNever;
  }
  void pin_changed(Pin, const PinDrive&, SimTime) override;

  const std::string& name() const override { return spec_.name; }
  std::span<const FaultKind> fault_kinds() const override;
  void fail(const Fault&) override;

 private:
  void ping(SimTime t);
  void announce(SimTime end);

  struct State {
    bool triggered = false;  // the trigger is high
    SimTime since = 0;
    SimTime rises = 0, falls = 0;  // the echo
    int announced = 2;             // number of the echo's two edges that have been scheduled
    std::uint64_t pings = 0;
    double shown = 0.0;  // cm
    bool dead = false;
  };

  const UltrasonicSpec& spec_;
  PartContext& context_;
  Mount mount_;
  const NoiseStream stream_;
  const double reach_, noise_;
  const Vec2 half_beam_;
  State state_;
};

}  // namespace robosim::robot
