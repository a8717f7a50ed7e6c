#include "sim/robot/parts/servo.h"

#include <algorithm>
#include <cstdlib>

#include "sim/base/trig_series.h"

namespace robosim::robot {
namespace {

constexpr SimTime kDeadBand = 10 * kMicrosecond;

constexpr FaultKind kServoFaults[] = {
    {Failure::ok, "works again"},
    {Failure::stuck, "the horn does not move"},
};

}  // namespace

std::shared_ptr<const PartSpec> read_servo(PartReader& reader) {
  auto spec = std::make_shared<ServoSpec>();
  spec->pin = reader.pin("pin", PinUse::driven);
  spec->at = reader.point("at", {});
  spec->facing = reader.angle("facing");
  spec->shortest = reader.figure("shortest", Dimension::time, {544e-6, 0.0}, 400e-6, 1400e-6);
  spec->longest = reader.figure("longest", Dimension::time, {2400e-6, 0.0}, 1600e-6, 2900e-6);
  spec->range =
      reader.figure("range", Dimension::angle, {180.0 * kDegree, 0.0}, 10.0 * kDegree, 360.0 * kDegree);
  spec->speed = reader.figure("speed", Dimension::rotation_rate, {500.0 * kDegree, 0.0}, 10.0 * kDegree,
                              5000.0 * kDegree);
  spec->reversed = reader.table().boolean("reversed", false);
  return reader.finish(spec);
}

std::unique_ptr<Part> ServoSpec::make(PartContext& context) const {
  return std::make_unique<ServoPart>(*this, context);
}

ServoPart::ServoPart(const ServoSpec& spec, PartContext& context)
    : spec_(spec),
      context_(context),
      shortest_(context.sampler.draw(spec.shortest, spec.name, "shortest") * 1e9),
      longest_(context.sampler.draw(spec.longest, spec.name, "longest") * 1e9),
      range_(context.sampler.draw(spec.range, spec.name, "range")),
      speed_(context.sampler.draw(spec.speed, spec.name, "speed") * 1e-9) {
  state_.from = state_.target = 0.5 * range_;
  context.snapshots.add(state_);
}

void ServoPart::register_with(PartRegistry& registry) {
  context_.netlist.watch(spec_.pin, *this);
  registry.breakable.push_back(this);
  registry.servos.push_back(this);
}

double ServoPart::angle(SimTime t) const {
  if (state_.stuck) return state_.from;
  const double way = speed_ * static_cast<double>(t - state_.since);
  return state_.from + std::clamp(state_.target - state_.from, -way, way);
}

void ServoPart::pin_changed(Pin, const PinDrive& drive, SimTime t) {
  const auto pulse = state_.signal.change(drive, t);
  if (!pulse || std::llabs(*pulse - state_.pulse) <= kDeadBand) return;
  state_.from = angle(t);
  state_.since = t;
  state_.pulse = *pulse;
  const double share = (static_cast<double>(*pulse) - shortest_) / (longest_ - shortest_);
  state_.target = range_ * std::clamp(share, 0.0, 1.0);
}

double ServoPart::turned(SimTime t) const {
  const double turned = angle(t) - 0.5 * range_;
  return spec_.reversed ? -turned : turned;
}

Pose ServoPart::horn(SimTime t) const { return {spec_.at, direction_of(spec_.facing + turned(t))}; }

void ServoPart::turn_wheels(world::Body& body, double ratio, double most) {
  body_ = &body;
  ratio_ = ratio;
  most_ = most;
}

void ServoPart::begin_tick(SimTime t) {
  if (body_) body_->steer(std::clamp(ratio_ * turned(t), -most_, most_));
}

void ServoPart::read(std::vector<Reading>& readings) const {
  readings.push_back({spec_.name, angle(context_.view.tick_start) / kDegree});
}

std::span<const FaultKind> ServoPart::fault_kinds() const { return kServoFaults; }

void ServoPart::fail(const Fault& fault) {
  const SimTime now = context_.view.tick_start;
  state_.from = angle(now);
  state_.since = now;
  state_.stuck = fault.failure == Failure::stuck;
}

}  // namespace robosim::robot
