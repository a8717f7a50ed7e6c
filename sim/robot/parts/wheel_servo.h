// type = "wheel-servo": a servo for continuous rotation that drives a wheel. The pulse width sets the speed.
//
//   over  = |pulse - stop| - dead band, at least 0
//   drive = over / (full - dead band), at most 1, with the sign of pulse - stop
//   brake = 1 - |drive|
//
// The motor has the parameters of [motors] (sim/world/body.h); `reversed` mounts the servo the other way
// round. Pulses longer than `stop` turn the servo counter-clockwise, seen from its shaft. They therefore
// drive the left wheel forward. The right servo is mounted mirrored, so longer pulses drive the right wheel
// backward. The servo coasts when the last pulse is more than 50 ms ago.
//
// Sources: FS90R (Feetech; Pololu product 2820): stop at 1.5 ms, dead band of 45 us to each side since 2014,
// longer pulses turn counter-clockwise, full speed at some 0.5 ms from stop. Parallax 900-00008: full speed
// at 0.2 ms from stop, almost no dead band.
#pragma once

#include "sim/robot/part_reader.h"
#include "sim/robot/parts/servo_signal.h"
#include "sim/robot/parts/wheel_motor.h"

namespace robosim::robot {

std::shared_ptr<const PartSpec> read_wheel_servo(PartReader&);

class WheelServoSpec final : public PartSpec {
 public:
  Pin pin = kNoPin;
  Side wheel = world::left;
  bool reversed = false;
  Parameter stop;       ///< s, the pulse for standstill
  Parameter full;       ///< s, difference from stop for full speed
  Parameter dead_band;  ///< s to each side of stop

  std::unique_ptr<Part> make(PartContext&) const override;
  int driven_wheel() const override { return wheel; }
};

class WheelServoPart final : public WheelMotor, public PinWatcher {
 public:
  WheelServoPart(const WheelServoSpec&, PartContext&);

  void register_with(PartRegistry&) override;
  void begin_tick(SimTime) override;
  void pin_changed(Pin, const PinDrive&, SimTime) override;

 private:
  struct State {
    ServoSignal signal;
    SimTime last_pulse = kNever;  // kNever = the servo coasts
  };

  const WheelServoSpec& spec_;
  PartContext& context_;
  const double stop_, full_, dead_band_;  // ns
  const double forward_;                  // 1 = longer pulses drive the wheel forward; else -1
  State state_;
};

}  // namespace robosim::robot
