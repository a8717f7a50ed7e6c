#include "sim/robot/parts/wheel_servo.h"

#include <algorithm>
#include <cmath>

namespace robosim::robot {
namespace {

constexpr SimTime kHolds = 50 * kMillisecond;  // from the last pulse to coasting: 2.5 usual periods

}  // namespace

std::shared_ptr<const PartSpec> read_wheel_servo(PartReader& reader) {
  auto spec = std::make_shared<WheelServoSpec>();
  spec->pin = reader.pin("pin", PinUse::driven);
  spec->wheel = reader.wheel();
  spec->reversed = reader.table().boolean("reversed", false);
  spec->stop = reader.figure("stop", Dimension::time, {1500e-6, 0.0}, 1000e-6, 2000e-6);
  spec->full = reader.figure("full", Dimension::time, {500e-6, 0.0}, 100e-6, 1000e-6);
  spec->dead_band = reader.figure("dead_band", Dimension::time, {45e-6, 0.0}, 0.0, 90e-6);
  return reader.finish(spec);
}

std::unique_ptr<Part> WheelServoSpec::make(PartContext& context) const {
  return std::make_unique<WheelServoPart>(*this, context);
}

WheelServoPart::WheelServoPart(const WheelServoSpec& spec, PartContext& context)
    : WheelMotor(spec, context),
      spec_(spec),
      context_(context),
      stop_(context.sampler.draw(spec.stop, spec.name, "stop") * 1e9),
      full_(context.sampler.draw(spec.full, spec.name, "full") * 1e9),
      dead_band_(context.sampler.draw(spec.dead_band, spec.name, "dead_band") * 1e9),
      forward_((spec.wheel == world::left) != spec.reversed ? 1.0 : -1.0) {
  context.snapshots.add(state_);
}

void WheelServoPart::register_with(PartRegistry& registry) {
  registry.motor[spec_.wheel] = this;
  registry.breakable.push_back(this);
  registry.ticking.push_back(this);
  context_.netlist.watch(spec_.pin, *this);
}

void WheelServoPart::begin_tick(SimTime t) {
  if (state_.signal.repeats()) state_.last_pulse = t;
  if (state_.last_pulse == kNever || t - state_.last_pulse < kHolds) return;
  state_.last_pulse = kNever;
  set({}, t);
}

void WheelServoPart::pin_changed(Pin, const PinDrive& drive, SimTime t) {
  const auto pulse = state_.signal.change(drive, t);
  if (!pulse) return;
  state_.last_pulse = t;
  const double over = static_cast<double>(*pulse) - stop_;
  const double share = std::max(std::abs(over) - dead_band_, 0.0) / (full_ - dead_band_);
  const double speed = std::min(share, 1.0);
  set({std::copysign(speed, over) * forward_, 1.0 - speed}, t);
}

}  // namespace robosim::robot
