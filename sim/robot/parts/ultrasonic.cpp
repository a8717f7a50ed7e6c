#include "sim/robot/parts/ultrasonic.h"

#include <algorithm>

#include "sim/base/trig_series.h"

namespace robosim::robot {
namespace {

constexpr double kSound = 343.0;                      // m/s
constexpr double kNearest = 0.02;                     // m
constexpr SimTime kTrigger = 9500;                    // in ns: 10 us, less a tolerance for the sketch's delay
constexpr SimTime kBurst = 450 * kMicrosecond;        // from the trigger's end to the echo's beginning
constexpr SimTime kNothingHeard = 38 * kMillisecond;  // timeout of the echo

constexpr FaultKind kUltrasonicFaults[] = {
    {Failure::ok, "works again"},
    {Failure::dead, "its echo stays low"},
};

}  // namespace

std::shared_ptr<const PartSpec> read_ultrasonic(PartReader& reader) {
  auto spec = std::make_shared<UltrasonicSpec>();
  std::size_t wiring = 0;
  const std::vector<Pin> pins = reader.pin_table({{"trig", "echo"}, {"sig"}}, wiring);
  spec->trig = pins[0];
  spec->echo = pins.back();
  spec->mount = read_mount(reader);
  spec->beam = reader.angle("beam", 15.0 * kDegree, 1.0 * kDegree, 90.0 * kDegree);
  spec->reach = reader.figure("reach", Dimension::length, {4.0, 0.0}, 0.1, 6.0);
  spec->noise = reader.figure("noise", Dimension::length, {0.0015, 0.0}, 0.0, 0.1);
  return reader.finish(spec);
}

std::unique_ptr<Part> UltrasonicSpec::make(PartContext& context) const {
  return std::make_unique<UltrasonicPart>(*this, context);
}

UltrasonicPart::UltrasonicPart(const UltrasonicSpec& spec, PartContext& context)
    : spec_(spec),
      context_(context),
      mount_(spec.mount, context.view),
      stream_(context.sampler.noise(spec.name, "echo")),
      reach_(context.sampler.draw(spec.reach, spec.name, "reach")),
      noise_(context.sampler.ideal() ? 0.0 : context.sampler.draw(spec.noise, spec.name, "noise")),
      half_beam_(direction_of(0.5 * spec.beam)) {
  context.snapshots.add(state_);
}

void UltrasonicPart::register_with(PartRegistry& registry) {
  context_.board.connect(spec_.echo, *this);
  context_.board.watch(spec_.trig, *this);
  registry.ticking.push_back(this);
  registry.sightlines.push_back({&mount_, reach_});
  registry.breakable.push_back(this);
}

void UltrasonicPart::pin_changed(Pin, const PinDrive& drive, SimTime t) {
  const bool high = drive.mode == PinMode::output && !drive.pwm && drive.level;
  const bool fell = state_.triggered && !high;
  if (high && !state_.triggered) state_.since = t;
  state_.triggered = high;
  if (fell && t - state_.since >= kTrigger && t >= state_.falls && !state_.dead) ping(t);
}

void UltrasonicPart::ping(SimTime t) {
  const Pose from = mount_.pose_at(t);
  const View& view = context_.view;
  const double way =
      view.world->range_in_beam(view.body_number, from.position, from.heading, half_beam_, reach_);
  const bool heard = way < reach_;
  const double error = noise_ > 0.0 ? noise_ * stream_.gauss(state_.pings++) : 0.0;
  const double told = std::max(way + error, kNearest);
  state_.shown = heard ? told * 100.0 : 0.0;
  state_.rises = t + kBurst;
  state_.falls = state_.rises + (heard ? static_cast<SimTime>(2e9 * told / kSound) : kNothingHeard);
  state_.announced = 0;
  announce(view.tick_start + kTick);
}

void UltrasonicPart::begin_tick(SimTime t) {
  if (state_.announced < 2) announce(t + kTick);
}

void UltrasonicPart::announce(SimTime end) {
  for (; state_.announced < 2; ++state_.announced) {
    const bool rise = state_.announced == 0;
    const SimTime at = rise ? state_.rises : state_.falls;
    if (at >= end) return;
    context_.board.schedule_edge(spec_.echo, rise, at);
  }
}

void UltrasonicPart::read(std::vector<Reading>& readings) const {
  readings.push_back({spec_.name, state_.shown});
}

std::span<const FaultKind> UltrasonicPart::fault_kinds() const { return kUltrasonicFaults; }

void UltrasonicPart::fail(const Fault& fault) { state_.dead = fault.failure == Failure::dead; }

}  // namespace robosim::robot
