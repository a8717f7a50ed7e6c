#include "sim/robot/parts/vl53l0x.h"

#include <algorithm>
#include <cmath>

namespace robosim::robot {
namespace {

constexpr int kUsualVl53Address = 0x29;
constexpr std::uint8_t kStart = 0x00, kClearRegister = 0x0B, kStatusRegister = 0x13, kResult = 0x1E,
                       kStartUp = 0x83, kModel = 0xC0;
constexpr std::uint8_t kIsThere = 0x04, kOnce = 0x01, kForEver = 0x06;
constexpr SimTime kBudget = 33 * kMillisecond;
constexpr int kNothingNear = 8190;  // mm
constexpr double kBeyond = 1.0;     // m; noise can make objects up to this far beyond `reach` visible

}  // namespace

std::shared_ptr<const PartSpec> read_vl53l0x(PartReader& reader) {
  auto spec = std::make_shared<Vl53l0xSpec>();
  spec->address = read_two_wire(reader, kUsualVl53Address);
  spec->mount = read_mount(reader);
  spec->reach = reader.figure("reach", Dimension::length, {1.2, 0.0}, 0.05, 2.0);
  spec->noise = reader.figure("noise", Dimension::ratio, {0.04, 0.0}, 0.0, 1.0);
  return reader.finish(spec);
}

std::unique_ptr<Part> Vl53l0xSpec::make(PartContext& context) const {
  return std::make_unique<Vl53l0xPart>(*this, context);
}

Vl53l0xPart::Vl53l0xPart(const Vl53l0xSpec& spec, PartContext& context)
    : RegisterDevice(spec.address, state_.cursor),
      spec_(spec),
      context_(context),
      mount_(spec.mount, context.view),
      stream_(context.sampler.noise(spec.name, "reading")),
      reach_(context.sampler.draw(spec.reach, spec.name, "reach")),
      noise_(context.sampler.ideal() ? 0.0 : context.sampler.draw(spec.noise, spec.name, "noise")) {
  state_.registers[kModel] = 0xEE;
  state_.registers[kModel + 1] = 0xAA;
  state_.registers[kModel + 2] = 0x10;
  state_.registers[kStartUp] = 0x01;
  context.snapshots.add(state_);
}

void Vl53l0xPart::register_with(PartRegistry& registry) {
  context_.board.connect(*this);
  registry.ticking.push_back(this);
  registry.sightlines.push_back({&mount_, reach_ + kBeyond});
}

void Vl53l0xPart::set(std::uint8_t number, std::uint8_t value, SimTime t) {
  if (number == kStart) {
    state_.goes_on = value & kForEver;
    state_.ready_at = value & (kOnce | kForEver) ? t + kBudget : kNever;
    value &= static_cast<std::uint8_t>(~kOnce);
  } else if (number == kClearRegister) {
    state_.registers[kStatusRegister] &= static_cast<std::uint8_t>(~7);
  } else if (number == kStartUp) {
    value = 0x01;
  }
  if (number != kStatusRegister && number < kModel) state_.registers[number] = value;
}

void Vl53l0xPart::begin_tick(SimTime t) {
  if (t + kTick <= state_.ready_at) return;
  const Pose from = mount_.pose_at(std::max(t, state_.ready_at));
  const View& view = context_.view;
  double metres = view.world->range_along(view.body_number, from.position, from.heading, reach_ + kBeyond);
  if (noise_ > 0.0) metres *= 1.0 + noise_ * stream_.gauss(state_.samples++);
  state_.millimetres = metres > reach_ ? kNothingNear : static_cast<int>(std::lround(metres * 1000.0));
  state_.registers[kResult] = static_cast<std::uint8_t>(state_.millimetres >> 8);
  state_.registers[kResult + 1] = static_cast<std::uint8_t>(state_.millimetres);
  state_.registers[kStatusRegister] |= kIsThere;
  state_.ready_at = state_.goes_on ? state_.ready_at + kBudget : kNever;
}

void Vl53l0xPart::read(std::vector<Reading>& readings) const {
  readings.push_back({spec_.name, static_cast<double>(state_.millimetres)});
}

}  // namespace robosim::robot
