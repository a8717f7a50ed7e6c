#include "sim/robot/parts/tcs34725.h"

#include <algorithm>

namespace robosim::robot {
namespace {

constexpr int kUsualTcsAddress = 0x29;
constexpr std::uint8_t kEnableRegister = 0x00, kAtime = 0x01, kControl = 0x0F, kId = 0x12, kStatus = 0x13,
                       kClear = 0x14;
constexpr std::uint8_t kOn = 0x03, kValid = 0x01, kTcsIdentity = 0x44;
constexpr SimTime kCycle = 2400 * kMicrosecond;
constexpr double kCountsOfCycle = 1024.0, kMostCounts = 65535.0;
constexpr double kOfWhite = 0.008, kOfLine = 0.1;
constexpr double kGains[4] = {1.0, 4.0, 16.0, 60.0};
constexpr double kOfColour[] = {0.36, 0.36, 0.28};
constexpr world::Band kBands[] = {world::Band::red, world::Band::green, world::Band::blue};

}  // namespace

std::shared_ptr<const PartSpec> read_tcs34725(PartReader& reader) {
  auto spec = std::make_shared<Tcs34725Spec>();
  spec->address = read_two_wire(reader, kUsualTcsAddress);
  spec->at = reader.point("at", {});
  spec->footprint = reader.figure("footprint", Dimension::length, {0.01, 0.0}, 0.001, 0.1).value;
  return reader.finish(spec);
}

std::unique_ptr<Part> Tcs34725Spec::make(PartContext& context) const {
  return std::make_unique<Tcs34725Part>(*this, context);
}

Tcs34725Part::Tcs34725Part(const Tcs34725Spec& spec, PartContext& context)
    : RegisterDevice(spec.address, state_.cursor), spec_(spec), context_(context) {
  state_.probe = spec.footprint;
  state_.registers[kAtime] = 0xFF;
  state_.registers[kId] = kTcsIdentity;
  context.snapshots.add(state_);
}

void Tcs34725Part::register_with(PartRegistry& registry) {
  context_.board.connect(*this);
  registry.ticking.push_back(this);
}

SimTime Tcs34725Part::integration() const { return kCycle * (256 - state_.registers[kAtime]); }

void Tcs34725Part::set(std::uint8_t number, std::uint8_t value, SimTime t) {
  const auto to = static_cast<std::uint8_t>(number & 0x1F);  // without the command bits
  if (to >= kId) return;
  state_.registers[to] = value;
  if (to != kEnableRegister && to != kAtime) return;
  const bool on = (state_.registers[kEnableRegister] & kOn) == kOn;
  if (!on) state_.registers[kStatus] &= static_cast<std::uint8_t>(~kValid);
  state_.ready_at = on ? t + integration() : kNever;
}

void Tcs34725Part::begin_tick(SimTime t) {
  while (state_.ready_at < t + kTick) {
    measure(std::max(t, state_.ready_at));
    state_.ready_at += integration();
  }
}

void Tcs34725Part::measure(SimTime t) {
  const Pose pose = context_.view.pose_at(t);
  const Vec2 left{-pose.heading.y, pose.heading.x};
  const Vec2 place = pose.position + pose.heading * spec_.at.x + left * spec_.at.y;
  const double full = std::min(kMostCounts, kCountsOfCycle * (256 - state_.registers[kAtime]));
  const double gain = kGains[state_.registers[kControl] & 3];
  std::array<double, 4> share{};  // clear, red, green, blue
  for (std::size_t i = 1; i < share.size(); ++i) {
    const double dark = context_.view.floor->darkness(place, state_.probe, kBands[i - 1]);
    share[i] = kOfColour[i - 1] * kOfWhite * (1.0 - dark * (1.0 - kOfLine));
    share[0] += share[i];
  }
  state_.clear = std::min(full, full * gain * share[0]);
  for (std::size_t i = 0; i < share.size(); ++i) {
    const auto counts = static_cast<unsigned>(std::min(full, full * gain * share[i]) + 0.5);
    state_.registers[kClear + 2 * i] = static_cast<std::uint8_t>(counts);
    state_.registers[kClear + 2 * i + 1] = static_cast<std::uint8_t>(counts >> 8);
  }
  state_.registers[kStatus] |= kValid;
}

void Tcs34725Part::read(std::vector<Reading>& readings) const {
  readings.push_back({spec_.name, state_.clear});
}

}  // namespace robosim::robot
