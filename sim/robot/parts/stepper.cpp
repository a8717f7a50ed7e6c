#include "sim/robot/parts/stepper.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/robot/parts/motor_driver.h"

namespace robosim::robot {
namespace {

constexpr double kPeriod = 8.0;                           // half steps
constexpr double kStepsOfATurn = 64.0 * 25792.0 / 405.0;  // 8 periods of 8 half steps, times the gear ratio
constexpr double kRpm = 2.0 * std::numbers::pi / 60.0;    // rad/s

constexpr FaultKind kStepperFaults[] = {
    {Failure::ok, "works again"},
    {Failure::stuck, "the rotor does not move"},
};

}  // namespace

std::shared_ptr<const PartSpec> read_stepper(PartReader& reader) {
  auto spec = std::make_shared<StepperSpec>();
  std::size_t wiring = 0;
  spec->coils = reader.pin_table({{"in1", "in2", "in3", "in4"}}, wiring, PinUse::driven);
  spec->steps = reader.figure("steps", Dimension::ratio, {kStepsOfATurn, 0.0}, 8.0, 1e6);
  spec->speed =
      reader.figure("speed", Dimension::rotation_rate, {16.0 * kRpm, 0.0}, 0.1 * kRpm, 6000.0 * kRpm);
  spec->reversed = reader.table().boolean("reversed", false);
  return reader.finish(spec);
}

std::unique_ptr<Part> StepperSpec::make(PartContext& context) const {
  return std::make_unique<StepperPart>(*this, context);
}

StepperPart::StepperPart(const StepperSpec& spec, PartContext& context)
    : spec_(spec),
      context_(context),
      steps_(context.sampler.draw(spec.steps, spec.name, "steps")),
      rate_(context.sampler.draw(spec.speed, spec.name, "speed") / (2.0 * std::numbers::pi) * steps_ * 1e-9) {
  context.snapshots.add(state_);
}

void StepperPart::register_with(PartRegistry& registry) {
  for (const Pin pin : spec_.coils) context_.netlist.watch(pin, *this);
  registry.breakable.push_back(this);
}

// Returns the direction of the field from a table. The indices are the differences of opposite coils, IN1 -
// IN3 and IN2 - IN4, each of which has 3 values.
int StepperPart::field() const {
  const auto on = [this](std::size_t coil) {
    return high_share(context_.netlist.drive(spec_.coils[coil])) >= 0.5 ? 1 : 0;
  };
  static constexpr int kFields[3][3] = {{5, 4, 3}, {6, kNoField, 2}, {7, 0, 1}};
  return kFields[1 + on(0) - on(2)][1 + on(1) - on(3)];
}

double StepperPart::rotor(SimTime t) const {
  if (state_.field == kNoField || state_.stuck) return state_.from;
  const double lead = std::remainder(state_.field - state_.from, kPeriod);
  const double way = rate_ * static_cast<double>(t - state_.since);
  return state_.from + std::clamp(lead, -way, way);
}

void StepperPart::pin_changed(Pin, const PinDrive&, SimTime t) {
  state_.from = rotor(t);
  state_.since = t;
  state_.field = field();
}

void StepperPart::read(std::vector<Reading>& readings) const {
  const double degrees = rotor(context_.view.tick_start) / steps_ * 360.0;
  readings.push_back({spec_.name, spec_.reversed ? -degrees : degrees});
}

std::span<const FaultKind> StepperPart::fault_kinds() const { return kStepperFaults; }

void StepperPart::fail(const Fault& fault) {
  state_.from = rotor(context_.view.tick_start);
  state_.since = context_.view.tick_start;
  state_.stuck = fault.failure == Failure::stuck;
}

}  // namespace robosim::robot
