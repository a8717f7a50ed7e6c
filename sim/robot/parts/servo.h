// type = "servo": turns its horn to an angle, at a limited speed. A distance sensor can be mounted on it.
//
//   target = range (pulse - shortest) / (longest - shortest), 0 to range; the horn turns there at `speed`
//
// Longer pulses turn the horn to the left, seen from above (reversed = true: to the right). At power-on the
// horn is in its middle position. Without pulses the horn stays in place.
//
// Sources: Arduino's Servo library outputs pulses of 0.544 to 2.4 ms for write(0) to write(180). The SG90
// takes 0.12 s for 60 degrees at 4.8 V, and has a dead band of 10 us (Tower Pro data sheet).
#pragma once

#include "sim/robot/part.h"
#include "sim/robot/part_context.h"
#include "sim/robot/part_reader.h"
#include "sim/robot/parts/servo_signal.h"

namespace robosim::robot {

std::shared_ptr<const PartSpec> read_servo(PartReader&);

class ServoSpec final : public PartSpec {
 public:
  Pin pin = kNoPin;
  Vec2 at;              ///< m, place of the axis
  double facing = 0.0;  ///< rad, direction of the middle position: 0 ahead, counter-clockwise
  Parameter shortest;   ///< s, the pulse for angle 0
  Parameter longest;    ///< s, the pulse for `range`
  Parameter range;      ///< rad
  Parameter speed;      ///< rad/s
  bool reversed = false;

  std::unique_ptr<Part> make(PartContext&) const override;
  std::vector<Gauge> gauges() const override { return {{name, "deg"}}; }
};

class ServoPart final : public Part, public PinWatcher, public Breakable {
 public:
  ServoPart(const ServoSpec&, PartContext&);

  /// Returns the place of the axis, and the direction of the horn at `t`, in the body's frame.
  Pose horn(SimTime t) const;

  /// Returns the distance from the axle's centre to the servo's axis, m.
  double arm() const { return length(spec_.at); }

  /// Connects the servo to the body's steered wheels. They turn by `ratio` times the servo's angle, but at
  /// most by `most` (rad). The robot calls this function once.
  void turn_wheels(world::Body& body, double ratio, double most);

  void register_with(PartRegistry&) override;
  void begin_tick(SimTime) override;
  void pin_changed(Pin, const PinDrive&, SimTime) override;
  /// Appends the angle in degrees, as in Servo.write().
  void read(std::vector<Reading>&) const override;

  const std::string& name() const override { return spec_.name; }
  std::span<const FaultKind> fault_kinds() const override;
  void fail(const Fault&) override;

 private:
  /// Returns the angle in rad from the right stop, or from the left stop if the servo is `reversed`.
  double angle(SimTime t) const;
  /// Returns the angle in rad to the left of the middle position.
  double turned(SimTime t) const;

  struct State {
    ServoSignal signal;
    double from = 0.0;  // rad, angle at `since`
    SimTime since = 0;
    double target = 0.0;  // rad
    SimTime pulse = 0;    // ns; length of the last pulse that changed the target
    bool stuck = false;
  };

  const ServoSpec& spec_;
  PartContext& context_;
  const double shortest_, longest_, range_;  // ns, ns, rad
  const double speed_;                       // rad/ns
  world::Body* body_ = nullptr;              // body whose wheels the servo steers; null = none
  double ratio_ = 0.0, most_ = 0.0;
  State state_;
};

}  // namespace robosim::robot
