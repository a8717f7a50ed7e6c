#include "sim/robot/parts/ir_distance.h"

#include <algorithm>
#include <array>

namespace robosim::robot {
namespace {

constexpr SimTime kMeasurement = 38'300 * kMicrosecond;
constexpr double kFarthest = 3.0;  // in metres; no light returns from farther away

struct CurvePoint {
  double metres, volts;
};
constexpr std::array<CurvePoint, 15> kCurve{{{0.0, 1.2},
                                             {0.03, 2.2},
                                             {0.04, 2.65},
                                             {0.05, 2.95},
                                             {0.06, 3.1},
                                             {0.08, 2.75},
                                             {0.1, 2.3},
                                             {0.15, 1.65},
                                             {0.2, 1.3},
                                             {0.3, 0.94},
                                             {0.4, 0.74},
                                             {0.5, 0.6},
                                             {0.6, 0.51},
                                             {0.7, 0.45},
                                             {0.8, 0.4}}};

constexpr FaultKind kIrDistanceFaults[] = {
    {Failure::ok, "works again"},
    {Failure::dead, "it gives 0 V"},
};

}  // namespace

double ir_volts(double metres) {
  const CurvePoint& last = kCurve.back();
  if (metres >= last.metres) return last.volts * last.metres / metres;
  const auto next = std::find_if(kCurve.begin() + 1, kCurve.end() - 1,
                                 [metres](const CurvePoint& point) { return metres < point.metres; });
  const CurvePoint& before = *(next - 1);
  const double share = (metres - before.metres) / (next->metres - before.metres);
  return before.volts + share * (next->volts - before.volts);
}

std::shared_ptr<const PartSpec> read_ir_distance(PartReader& reader) {
  auto spec = std::make_shared<IrDistanceSpec>();
  spec->pin = reader.pin("pin", PinUse::analog);
  spec->mount = read_mount(reader);
  spec->noise = reader.figure("noise", Dimension::voltage, {0.01, 0.0}, 0.0, 1.0);
  spec->source_ohms = reader.source_ohms();
  return reader.finish(spec);
}

std::unique_ptr<Part> IrDistanceSpec::make(PartContext& context) const {
  return std::make_unique<IrDistancePart>(*this, context);
}

IrDistancePart::IrDistancePart(const IrDistanceSpec& spec, PartContext& context)
    : spec_(spec),
      context_(context),
      mount_(spec.mount, context.view),
      stream_(context.sampler.noise(spec.name, "reading")),
      noise_(context.sampler.ideal() ? 0.0 : context.sampler.draw(spec.noise, spec.name, "noise")),
      supply_(context.description.board->supply_volts),
      source_ohms_(context.sampler.draw(spec.source_ohms, spec.name, "source_ohms")),
      state_{.measures_until = kMeasurement} {
  context.snapshots.add(state_);
}

void IrDistancePart::register_with(PartRegistry& registry) {
  context_.connect_analog(spec_.pin, *this);
  registry.ticking.push_back(this);
  registry.sightlines.push_back({&mount_, kFarthest});
  registry.breakable.push_back(this);
}

void IrDistancePart::begin_tick(SimTime t) {
  if (t + kTick <= state_.measures_until) return;
  const Pose from = mount_.pose_at(state_.measures_until);
  const View& view = context_.view;
  state_.held = ir_volts(view.world->range_along(view.body_number, from.position, from.heading, kFarthest));
  state_.measures_until += kMeasurement;
}

Source IrDistancePart::output(SimTime, double supply) {
  if (state_.dead) return {0.0, source_ohms_};
  const double noise = noise_ > 0.0 && state_.held > 0.0 ? noise_ * stream_.gauss(state_.samples++) : 0.0;
  return {std::clamp(state_.held + noise, 0.0, supply), source_ohms_};
}

void IrDistancePart::read(std::vector<Reading>& readings) const {
  readings.push_back({spec_.name, state_.dead ? 0.0 : state_.held});
}

std::span<const FaultKind> IrDistancePart::fault_kinds() const { return kIrDistanceFaults; }

void IrDistancePart::fail(const Fault& fault) { state_.dead = fault.failure == Failure::dead; }

}  // namespace robosim::robot
