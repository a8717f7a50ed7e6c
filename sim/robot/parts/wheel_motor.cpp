#include "sim/robot/parts/wheel_motor.h"

namespace robosim::robot {
namespace {

constexpr FaultKind kMotorFaults[] = {
    {Failure::ok, "works again"},
    {Failure::dead, "a lead is disconnected: the motor turns freely"},
    {Failure::weak, "it gets this share of its voltage, such as 0.8 or 80%", FaultKind::Argument::number, 0.0,
     1.0},
    {Failure::reversed, "its leads are swapped"},
    {Failure::stuck, "something holds the wheel: it does not turn, and the motor stalls"},
};

}  // namespace

world::WheelCommand over_a_tick(const world::WheelCommand& command) {
  constexpr auto kWhole = static_cast<double>(kTick);
  return {command.drive * kWhole / kWhole, command.brake * kWhole / kWhole, command.against * kWhole / kWhole,
          command.period_s};
}

WheelMotor::WheelMotor(const PartSpec& spec, PartContext& context) : name_(spec.name), view_(context.view) {
  context.snapshots.add(state_);
}

void WheelMotor::spoil(world::WheelCommand& command) const {
  command.drive *= state_.strength;
  if (state_.dead) command = {};
}

std::span<const FaultKind> WheelMotor::fault_kinds() const { return kMotorFaults; }

void WheelMotor::fail(const Fault& fault) {
  state_.strength = 1.0;
  state_.dead = fault.failure == Failure::dead;
  if (fault.failure == Failure::reversed) state_.strength = -1.0;
  if (fault.failure == Failure::weak) state_.strength = fault.number;
  state_.blocked = fault.failure == Failure::stuck;
  state_.broken = fault.failure != Failure::ok;
  state_.steady = false;
}

}  // namespace robosim::robot
