// type = "motor": a wheel's motor on one half of the motor driver. The wiring is EN/IN1/IN2, IN1/IN2 or
// PHASE/ENABLE. For the driver "transistor", the wiring is EN alone.
#pragma once

#include "sim/robot/part.h"
#include "sim/robot/part_reader.h"
#include "sim/robot/parts/motor_driver.h"
#include "sim/robot/parts/wheel_motor.h"

namespace robosim::robot {

std::shared_ptr<const PartSpec> read_motor(PartReader&);

class MotorSpec final : public PartSpec {
 public:
  Side wheel = world::left;
  bool both = false;      ///< drives both wheels through a differential; `wheel` is then world::left
  bool reversed = false;  ///< the motor's two leads are swapped
  bool phase = false;     ///< PHASE/ENABLE: `in1` is PHASE
  Pin en = kNoPin;        ///< kNoPin = tied high
  Pin in1 = kNoPin;
  Pin in2 = kNoPin;

  std::unique_ptr<Part> make(PartContext&) const override;
  int driven_wheel() const override { return both ? kBothWheels : wheel; }
};

class MotorPart final : public WheelMotor, public PinWatcher {
 public:
  MotorPart(const MotorSpec&, PartContext&);

  void register_with(PartRegistry&) override;
  void pin_changed(Pin, const PinDrive&, SimTime) override;

 private:
  void take(Pin, const PinDrive&);
  /// Returns the command for the present state of the pins.
  world::WheelCommand told() const;
  /// Returns the period of the pins' PWM in s, for bridge_command().
  double period() const;

  /// Shares of time at high level. A pin that is not wired keeps its initial value.
  struct State {
    double awake = 1.0, en = 1.0, in1 = 0.0, in2 = 0.0;
  };

  const MotorSpec& spec_;
  PartContext& context_;
  const DriverChip& chip_;
  const Pin standby_;
  const bool has_inductance_;  ///< otherwise the PWM period has no effect
  State state_;
};

}  // namespace robosim::robot
