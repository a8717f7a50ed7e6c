#include "sim/robot/parts/motor.h"

#include <algorithm>
#include <cstring>

#include "sim/robot/part_context.h"

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

std::shared_ptr<const PartSpec> read_motor(PartReader& reader) {
  auto spec = std::make_shared<MotorSpec>();
  spec->wheel = reader.wheel();
  spec->reversed = reader.table().boolean("reversed", false);
  std::size_t wiring = 0;
  if (std::strcmp(reader.driver().chip->name, "transistor") == 0) {
    spec->en = reader.pin_table({{"en"}}, wiring, PinUse::driven)[0];
    return reader.finish(spec);
  }
  const std::vector<Pin> pins =
      reader.pin_table({{"en", "in1", "in2"}, {"in1", "in2"}, {"en", "phase"}}, wiring, PinUse::driven);
  spec->phase = wiring == 2;
  if (wiring == 1) {
    spec->in1 = pins[0];
    spec->in2 = pins[1];
  } else {
    spec->en = pins[0];
    spec->in1 = pins[1];
    if (wiring == 0) spec->in2 = pins[2];
  }
  return reader.finish(spec);
}

std::unique_ptr<Part> MotorSpec::make(PartContext& context) const {
  return std::make_unique<MotorPart>(*this, context);
}

MotorPart::MotorPart(const MotorSpec& spec, PartContext& context) : spec_(spec), context_(context) {
  context.kept.add(state_);
}

void MotorPart::join(Roster& roster) {
  roster.motor[spec_.wheel] = this;
  roster.breakable.push_back(this);
  for (const Pin pin : {spec_.en, spec_.in1, spec_.in2, context_.description.driver.standby})
    if (pin != kNoPin) context_.netlist.watch(pin, *this);
  update();
}

void MotorPart::pin_changed(Pin, const PinDrive&, SimTime t) {
  account(t);
  update();
  state_.steady = false;
}

void MotorPart::update() {
  const auto share = [this](Pin pin, double unwired) {
    return pin == kNoPin ? unwired : high_share(context_.netlist.drive(pin));
  };
  const Driver& driver = context_.description.driver;
  state_.now = {};
  const double awake = share(driver.standby, 1.0);
  if (awake > 0.0) {
    state_.now = bridge_command(
        *driver.chip, {share(spec_.en, 1.0), share(spec_.in1, 0.0), share(spec_.in2, 0.0), spec_.phase});
    state_.now.drive *= spec_.reversed ? -awake : awake;
    state_.now.brake *= awake;
  }
}

void MotorPart::account(SimTime t) {
  if (!state_.changed) {
    state_.changed = true;
    state_.sum = {};
    state_.since = context_.view.tick_start;
  }
  const auto lasted = static_cast<double>(std::max<SimTime>(t - state_.since, 0));
  state_.sum.drive += state_.now.drive * lasted;
  state_.sum.brake += state_.now.brake * lasted;
  state_.since = std::max(state_.since, t);
}

world::WheelCommand MotorPart::average(SimTime tick_start, SimTime t) {
  account(t);
  state_.changed = false;
  const auto tick = static_cast<double>(std::max<SimTime>(t - tick_start, 1));
  return {state_.sum.drive / tick, state_.sum.brake / tick};
}

void MotorPart::spoil(world::WheelCommand& command) const {
  command.drive *= state_.strength;
  if (state_.dead) command = {};
}

std::span<const FaultKind> MotorPart::fault_kinds() const { return kMotorFaults; }

void MotorPart::fail(const Fault& fault) {
  state_.strength = 1.0;
  state_.dead = fault.failure == Failure::dead;
  if (fault.failure == Failure::reversed) state_.strength = -1.0;
  if (fault.failure == Failure::weak) state_.strength = fault.number;
  state_.blocked = fault.failure == Failure::stuck;
  state_.broken = fault.failure != Failure::ok;
  state_.steady = false;
}

}  // namespace robosim::robot
