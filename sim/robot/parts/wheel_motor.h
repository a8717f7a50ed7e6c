// A wheel's drive: a motor on a driver, or a servo for continuous rotation.
#pragma once

#include <algorithm>

#include "sim/robot/part.h"
#include "sim/robot/part_context.h"
#include "sim/world/body.h"

namespace robosim::robot {

/// Averages a command as take() does, over a tick in which the command does not change. Because of rounding,
/// the result may differ from the command.
world::WheelCommand over_a_tick(const world::WheelCommand& command);

/// Averages the commands passed to set() over a tick.
class WheelMotor : public Part, public Breakable {
 public:
  /// Returns the command for the tick that ends at `t`.
  world::WheelCommand take(SimTime tick_start, SimTime t) {
    world::WheelCommand command = state_.now;
    state_.steady = !state_.changed;
    if (state_.changed) command = average(tick_start, t);
    if (state_.broken) spoil(command);
    return command;
  }

  /// Returns whether take() would repeat its last result.
  bool steady() const { return state_.steady; }

  /// Returns whether the wheel is blocked.
  bool blocked() const { return state_.blocked; }

  const std::string& name() const override { return name_; }
  std::span<const FaultKind> fault_kinds() const override;
  void fail(const Fault&) override;

 protected:
  WheelMotor(const PartSpec& spec, PartContext& context);

  /// Sets the command before the first tick.
  void begin(const world::WheelCommand& command) { state_.now = command; }
  /// Sets the command from `t` on.
  void set(const world::WheelCommand& command, SimTime t);
  const world::WheelCommand& now() const { return state_.now; }

 private:
  void account(SimTime t);
  world::WheelCommand average(SimTime tick_start, SimTime t);
  void spoil(world::WheelCommand&) const;

  struct State {
    world::WheelCommand now;  // from `since` on
    world::WheelCommand sum;  // the tick's earlier commands, each times its duration in ns
    SimTime since = 0;
    bool steady = false;   // no change since the last take()
    bool changed = false;  // set() was called since the tick began
    bool broken = false;
    double strength = 1.0;  // factor of the drive: < 1 weak, < 0 reversed
    bool dead = false;
    bool blocked = false;
  };

  const std::string& name_;
  const View& view_;
  State state_;
};

inline void WheelMotor::account(SimTime t) {
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

inline void WheelMotor::set(const world::WheelCommand& command, SimTime t) {
  account(t);
  state_.now = command;
  state_.steady = false;
}

inline world::WheelCommand WheelMotor::average(SimTime tick_start, SimTime t) {
  account(t);
  state_.changed = false;
  const auto tick = static_cast<double>(std::max<SimTime>(t - tick_start, 1));
  return {state_.sum.drive / tick, state_.sum.brake / tick, state_.sum.against / tick, state_.sum.period_s};
}

}  // namespace robosim::robot
