#include "sim/robot/parts/voltage.h"

#include <algorithm>

namespace robosim::robot {

std::shared_ptr<const PartSpec> read_voltage(PartReader& reader) {
  auto spec = std::make_shared<VoltageSpec>();
  spec->pin = reader.pin("pin", PinUse::analog);
  spec->volts = reader.volts("volts");
  spec->share = reader.figure("share", Dimension::ratio, {}, 0.0, 1.0);
  spec->noise = reader.volts("noise", {}, 1.0);
  const ConfigValue& table = reader.table().table();
  if ((table.find("volts") != nullptr) == (table.find("share") != nullptr))
    throw InputError(table.place,
                     reader.name() + " requires either volts or share (of the battery's voltage)");
  spec->source_ohms = reader.source_ohms();
  return reader.finish(spec);
}

std::unique_ptr<Part> VoltageSpec::make(PartContext& context) const {
  return std::make_unique<VoltagePart>(*this, context);
}

VoltagePart::VoltagePart(const VoltageSpec& spec, PartContext& context)
    : spec_(spec),
      context_(context),
      stream_(context.sampler.noise(spec.name, "reading")),
      supply_(context.description.board->supply_volts),
      volts_(context.sampler.draw(spec.volts, spec.name, "volts")),
      battery_volts_(context.sampler.draw(spec.share, spec.name, "share") *
                     context.sampler.draw(context.description.motors.supply, "motors", "supply")),
      noise_(context.sampler.ideal() ? 0.0 : context.sampler.draw(spec.noise, spec.name, "noise")),
      source_ohms_(context.sampler.draw(spec.source_ohms, spec.name, "source_ohms")) {
  context.snapshots.add(state_);
}

void VoltagePart::register_with(PartRegistry&) { context_.connect_analog(spec_.pin, *this); }

Source VoltagePart::output(SimTime, double supply) {
  const double noise = noise_ > 0.0 ? noise_ * stream_.gauss(state_.samples++) : 0.0;
  return {std::clamp(volts_ + battery_volts_ * context_.view.battery + noise, 0.0, supply), source_ohms_};
}

}  // namespace robosim::robot
