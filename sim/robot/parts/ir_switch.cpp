#include "sim/robot/parts/ir_switch.h"

namespace robosim::robot {
namespace {

constexpr double kLetsGo = 1.1;  // multiple of the range at which an object is lost again

constexpr FaultKind kIrSwitchFaults[] = {
    {Failure::ok, "works again"},
    {Failure::dead, "it sees nothing"},
    {Failure::stuck, "it always sees something"},
};

}  // namespace

std::shared_ptr<const PartSpec> read_ir_switch(PartReader& reader) {
  auto spec = std::make_shared<IrSwitchSpec>();
  spec->pin = reader.pin("pin", PinUse::digital);
  spec->mount = read_mount(reader);
  spec->range = reader.figure("range", Dimension::length, {0.15, 0.0}, 0.01, 1.5);
  spec->active_high = reader.high("active", false);
  return reader.finish(spec);
}

std::unique_ptr<Part> IrSwitchSpec::make(PartContext& context) const {
  return std::make_unique<IrSwitchPart>(*this, context);
}

IrSwitchPart::IrSwitchPart(const IrSwitchSpec& spec, PartContext& context)
    : spec_(spec),
      context_(context),
      mount_(spec.mount, context.view),
      range_(context.sampler.draw(spec.range, spec.name, "range")) {
  context.snapshots.add(state_);
}

void IrSwitchPart::register_with(PartRegistry& registry) {
  context_.board.connect(spec_.pin, *this);
  registry.ticking.push_back(this);
  registry.sightlines.push_back({&mount_, kLetsGo * range_});
  registry.breakable.push_back(this);
}

void IrSwitchPart::begin_tick(SimTime t) {
  const Pose from = mount_.pose_at(t);
  const double reach = state_.near ? kLetsGo * range_ : range_;
  const View& view = context_.view;
  state_.near = view.world->range_along(view.body_number, from.position, from.heading, reach) < reach;
  const bool changed = sees() != state_.told;
  state_.told = sees();
  if (changed && context_.board.wants_edges(spec_.pin)) context_.board.schedule_edge(spec_.pin, level(t), t);
}

void IrSwitchPart::read(std::vector<Reading>& readings) const {
  readings.push_back({spec_.name, sees() ? 1.0 : 0.0});
}

std::span<const FaultKind> IrSwitchPart::fault_kinds() const { return kIrSwitchFaults; }

void IrSwitchPart::fail(const Fault& fault) {
  state_.stuck = fault.failure == Failure::stuck  ? Stuck::seeing
                 : fault.failure == Failure::dead ? Stuck::blind
                                                  : Stuck::no;
}

}  // namespace robosim::robot
