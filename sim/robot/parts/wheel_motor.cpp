#include "sim/robot/parts/wheel_motor.h"

#include <algorithm>

namespace robosim::robot {
namespace {

constexpr FaultKind kMotorFaults[] = {
    {Failure::ok, "works again"},
    {Failure::dead, "a lead is off: it turns freely"},
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
  context.kept.add(state_);
}

void WheelMotor::set(const world::WheelCommand& command, SimTime t) {
  account(t);
  state_.now = command;
  state_.steady = false;
}

void WheelMotor::account(SimTime t) {
  if (!state_.changed) {
    state_.changed = true;
    state_.sum = {};
    state_.since = view_.tick_start;
  }
  const auto lasted = static_cast<double>(std::max<SimTime>(t - state_.since, 0));
  state_.sum.drive += state_.now.drive * lasted;
  state_.sum.brake += state_.now.brake * lasted;
  state_.sum.against += state_.now.against * lasted;
  if (state_.now.period_s > 0.0) state_.sum.period_s = state_.now.period_s;
  state_.since = std::max(state_.since, t);
}

world::WheelCommand WheelMotor::average(SimTime tick_start, SimTime t) {
  account(t);
  state_.changed = false;
  const auto tick = static_cast<double>(std::max<SimTime>(t - tick_start, 1));
  return {state_.sum.drive / tick, state_.sum.brake / tick, state_.sum.against / tick, state_.sum.period_s};
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
