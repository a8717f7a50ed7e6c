#include "sim/robot/parts/current_sensor.h"

#include <algorithm>

namespace robosim::robot {
namespace {

constexpr FaultKind kCurrentSensorFaults[] = {
    {Failure::ok, "works again"},
    {Failure::dead, "it always gives half the supply, which means no current"},
};

}  // namespace

std::shared_ptr<const PartSpec> read_current_sensor(PartReader& reader) {
  auto spec = std::make_shared<CurrentSensorSpec>();
  spec->pin = reader.pin("pin", PinUse::analog);
  spec->per_amp = reader.figure("per_amp", Dimension::voltage, {0.185, 0.0}, 0.001, 1.0);
  spec->noise = reader.figure("noise", Dimension::voltage, {0.004, 0.0}, 0.0, 1.0);
  spec->source_ohms = reader.source_ohms();
  return reader.finish(spec);
}

std::unique_ptr<Part> CurrentSensorSpec::make(PartContext& context) const {
  return std::make_unique<CurrentSensorPart>(*this, context);
}

CurrentSensorPart::CurrentSensorPart(const CurrentSensorSpec& spec, PartContext& context)
    : spec_(spec),
      context_(context),
      stream_(context.sampler.noise(spec.name, "reading")),
      per_amp_(context.sampler.draw(spec.per_amp, spec.name, "per_amp")),
      noise_(context.sampler.ideal() ? 0.0 : context.sampler.draw(spec.noise, spec.name, "noise")),
      supply_(context.description.board->supply_volts),
      source_ohms_(context.sampler.draw(spec.source_ohms, spec.name, "source_ohms")) {
  context.snapshots.add(state_);
}

void CurrentSensorPart::register_with(PartRegistry& registry) {
  context_.connect_analog(spec_.pin, *this);
  registry.ticking.push_back(this);
  registry.breakable.push_back(this);
}

void CurrentSensorPart::begin_tick(SimTime) {
  const world::Body& body = *context_.view.body;
  const double volts = body.params().supply_volts * context_.view.battery;
  const double energy = body.energy() - body.energy_back();
  state_.amps = volts > 0.0 ? (energy - state_.energy) / (volts * 1e-9 * kTick) : 0.0;
  state_.energy = energy;
}

Source CurrentSensorPart::output(SimTime, double supply) {
  const double noise = noise_ > 0.0 ? noise_ * stream_.gauss(state_.samples++) : 0.0;
  const double amps = state_.dead ? 0.0 : state_.amps;
  const double volts = std::clamp(0.5 * supply_ + per_amp_ * amps + noise, 0.0, supply_);
  return {volts * (supply / supply_), source_ohms_};
}

void CurrentSensorPart::read(std::vector<Reading>& readings) const {
  readings.push_back({spec_.name, state_.dead ? 0.0 : state_.amps});
}

std::span<const FaultKind> CurrentSensorPart::fault_kinds() const { return kCurrentSensorFaults; }

void CurrentSensorPart::fail(const Fault& fault) { state_.dead = fault.failure == Failure::dead; }

}  // namespace robosim::robot
