#include "sim/robot/parts/serial_radio.h"

#include <algorithm>

#include "sim/world/radio_channel.h"

namespace robosim::robot {
namespace {

constexpr FaultKind kSerialRadioFaults[] = {
    {Failure::ok, "works again"},
    {Failure::dead, "nothing arrives on either side"},
};

}  // namespace

std::shared_ptr<const PartSpec> read_serial_radio(PartReader& reader) {
  auto spec = std::make_shared<SerialRadioSpec>();
  spec->wiring = read_serial_wiring(reader);
  spec->delay = reader.figure("delay", Dimension::time, {0.02, 0.0}, 1e-3, 10.0);
  spec->loss = reader.figure("loss", Dimension::ratio, {0.0, 0.0}, 0.0, 1.0);
  spec->channel = static_cast<int>(reader.table().integer("channel", 1, 0, 255));
  return reader.finish(spec);
}

std::unique_ptr<Part> SerialRadioSpec::make(PartContext& context) const {
  return std::make_unique<SerialRadioPart>(*this, context);
}

SerialRadioPart::SerialRadioPart(const SerialRadioSpec& spec, PartContext& context)
    : spec_(spec),
      radio_(*context.view.radio),
      number_(radio_.add_radio(spec.channel)),
      // Is at least one tick, so that reception does not depend on the order of the robots in a tick.
      delay_(
          std::max(kTick, static_cast<SimTime>(context.sampler.draw(spec.delay, spec.name, "delay") * 1e9))),
      loss_(context.sampler.draw(spec.loss, spec.name, "loss")),
      losses_(context.sampler.noise(spec.name, "losses")),
      line_(spec.wiring, context, [this](std::uint8_t byte, bool sound, SimTime t) {
        if (sound && !state_.dead) radio_.send(number_, byte, t + delay_);
      }) {
  context.snapshots.add(state_);
}

void SerialRadioPart::register_with(PartRegistry& registry) {
  registry.has_radio = true;
  registry.breakable.push_back(this);
  registry.receivers.push_back(this);
  line_.register_with(*this, registry);
  if (std::find(registry.ticking.begin(), registry.ticking.end(), this) == registry.ticking.end())
    registry.ticking.push_back(this);
}

void SerialRadioPart::send(const Message& message, SimTime t) {
  if (state_.dead) return;
  for (const char c : message.text) line_.send(static_cast<std::uint8_t>(c), t);
}

void SerialRadioPart::begin_tick(SimTime t) {
  while (const auto arrival = radio_.take(number_, t + kTick)) {
    const bool lost = losses_.uniform(state_.arrived++) < loss_;
    if (!lost && !state_.dead) line_.send(arrival->byte, std::max(t, arrival->at));
  }
  line_.begin_tick(t);
}

void SerialRadioPart::read(std::vector<Reading>& readings) const {
  readings.push_back({spec_.name, line_.idle() ? 0.0 : 1.0});
}

std::span<const FaultKind> SerialRadioPart::fault_kinds() const { return kSerialRadioFaults; }

void SerialRadioPart::fail(const Fault& fault) { state_.dead = fault.failure == Failure::dead; }

}  // namespace robosim::robot
