// type = "motor": a wheel's motor, wired to one half of the driver in one of the usual ways.
#pragma once

#include "sim/robot/part.h"
#include "sim/robot/part_reader.h"
#include "sim/robot/parts/motor_driver.h"

namespace robosim::robot {

std::shared_ptr<const PartSpec> read_motor(PartReader&);

class MotorSpec final : public PartSpec {
 public:
  Side wheel = world::left;
  bool reversed = false;  ///< the motor's two leads are swapped
  bool phase = false;     ///< PHASE/ENABLE: `in1` is PHASE
  Pin en = kNoPin;        ///< kNoPin = tied high
  Pin in1 = kNoPin;
  Pin in2 = kNoPin;

  std::unique_ptr<Part> make(PartContext&) const override;
  int driven_wheel() const override { return wheel; }
};

/// The command of a tick is the time average of what the pins said during it.
class MotorPart final : public Part, public PinWatcher, public Breakable {
 public:
  MotorPart(const MotorSpec&, PartContext&);

  void join(Roster&) override;
  void pin_changed(Pin, const PinDrive&, SimTime) override;

  /// The command of the tick that ends at `t`.
  world::WheelCommand take(SimTime tick_start, SimTime t) {
    world::WheelCommand command = state_.now;
    state_.steady = !state_.changed;
    if (state_.changed) command = average(tick_start, t);
    if (state_.broken) spoil(command);
    return command;
  }

  /// Whether take() would give what it gave last.
  bool steady() const { return state_.steady; }

  /// Whether something blocks its wheel.
  bool blocked() const { return state_.blocked; }

  const std::string& name() const override { return spec_.name; }
  std::span<const FaultKind> fault_kinds() const override;
  void fail(const Fault&) override;

 private:
  void update();
  void account(SimTime t);
  world::WheelCommand average(SimTime tick_start, SimTime t);
  void spoil(world::WheelCommand&) const;

  struct State {
    world::WheelCommand now;  // since `since`
    world::WheelCommand sum;  // times nanoseconds, before
    SimTime since = 0;
    bool steady = false;   // nothing has happened since the last take()
    bool changed = false;  // since the tick began
    bool broken = false;
    double strength = 1.0;  // of drive: < 1 weak, 0 dead, < 0 reversed
    bool dead = false;
    bool blocked = false;
  };

  const MotorSpec& spec_;
  PartContext& context_;
  State state_;
};

}  // namespace robosim::robot
