#include "sim/robot/parts/motor.h"

#include <algorithm>
#include <cstring>

#include "sim/robot/part_context.h"

namespace robosim::robot {
std::shared_ptr<const PartSpec> read_motor(PartReader& reader) {
  auto spec = std::make_shared<MotorSpec>();
  const ConfigValue* wheel = reader.table().find("wheel");
  spec->both = wheel && wheel->kind == ConfigValue::Kind::string && wheel->string == "both";
  if (!spec->both) spec->wheel = reader.wheel();
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

MotorPart::MotorPart(const MotorSpec& spec, PartContext& context)
    : WheelMotor(spec, context),
      spec_(spec),
      context_(context),
      chip_(*context.description.driver.chip),
      standby_(context.description.driver.standby),
      has_inductance_(context.description.motors.inductance.value > 0.0) {
  context.snapshots.add(state_);
}

[[gnu::noinline]] double MotorPart::period() const {
  double period = 0.0;
  for (const Pin pin : {spec_.en, spec_.in1, spec_.in2})
    if (pin != kNoPin) period = std::max(period, period_of(context_.netlist.drive(pin)));
  return period;
}

inline world::WheelCommand MotorPart::told() const {
  if (state_.awake <= 0.0) return {};
  world::WheelCommand command = bridge_command(
      chip_, {state_.en, state_.in1, state_.in2, spec_.phase, has_inductance_ ? period() : 0.0});
  command.drive *= spec_.reversed ? -state_.awake : state_.awake;
  command.brake *= state_.awake;
  command.against *= state_.awake;
  return command;
}

inline void MotorPart::take(Pin pin, const PinDrive& drive) {
  const double share = high_share(drive);
  if (pin == spec_.en) state_.en = share;
  if (pin == spec_.in1) state_.in1 = share;
  if (pin == spec_.in2) state_.in2 = share;
  if (pin == standby_) state_.awake = share;
}

void MotorPart::register_with(PartRegistry& registry) {
  registry.motor[spec_.wheel] = this;
  registry.differential = spec_.both;
  registry.breakable.push_back(this);
  for (const Pin pin : {spec_.en, spec_.in1, spec_.in2, standby_}) {
    if (pin == kNoPin) continue;
    context_.netlist.watch(pin, *this);
    take(pin, context_.netlist.drive(pin));
  }
  begin(told());
}

void MotorPart::pin_changed(Pin pin, const PinDrive& drive, SimTime t) {
  take(pin, drive);
  set(told(), t);
}

}  // namespace robosim::robot
