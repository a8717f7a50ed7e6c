#include "sim/robot/parts/pca9685.h"

#include <fmt/format.h>

#include <cmath>

namespace robosim::robot {
namespace {

constexpr int kUsualPcaAddress = 0x40;
constexpr int kChannels = 16;
constexpr std::uint8_t kMode1 = 0x00, kMode2 = 0x01, kFirstChannel = 0x06, kAllChannels = 0xFA,
                       kPrescale = 0xFE;
constexpr std::uint8_t kAsleep = 0x10, kIncrements = 0x20, kRestart = 0x80, kAlways = 0x10;
constexpr double kOscillator = 25e6;  // Hz
constexpr int kCounts = 4096, kBytesOfChannel = 4;

}  // namespace

std::shared_ptr<const PartSpec> read_pca9685(PartReader& reader) {
  auto spec = std::make_shared<Pca9685Spec>();
  spec->address = read_two_wire(reader, kUsualPcaAddress);
  spec->index = *register_of(reader.terminals().registers, reader.name());
  return reader.finish(spec);
}

std::unique_ptr<Part> Pca9685Spec::make(PartContext& context) const {
  return std::make_unique<Pca9685Part>(*this, context);
}

Pca9685Part::Pca9685Part(const Pca9685Spec& spec, PartContext& context)
    : RegisterDevice(spec.address, state_.cursor), spec_(spec), context_(context) {
  state_.registers[kMode1] = 0x11;
  state_.registers[kMode2] = 0x04;
  state_.registers[kPrescale] = 0x1E;
  for (int n = 0; n < kChannels; ++n)
    state_.registers[static_cast<std::size_t>(kFirstChannel + kBytesOfChannel * n + 3)] = kAlways;
  context.snapshots.add(state_);
}

void Pca9685Part::register_with(PartRegistry& registry) {
  context_.board.connect(*this);
  registry.text_outputs.push_back(this);
}

std::uint8_t Pca9685Part::behind(std::uint8_t number) const {
  return static_cast<std::uint8_t>(number + (state_.registers[kMode1] & kIncrements ? 1 : 0));
}

void Pca9685Part::set(std::uint8_t number, std::uint8_t value, SimTime t) {
  if (number == kPrescale) {
    if (state_.registers[kMode1] & kAsleep) state_.registers[number] = value < 3 ? 3 : value;
  } else if (number == kMode1) {
    state_.registers[number] = value & static_cast<std::uint8_t>(~kRestart);
  } else if (number >= kAllChannels && number < kPrescale) {
    for (int n = 0; n < kChannels; ++n)
      state_
          .registers[static_cast<std::size_t>(kFirstChannel + kBytesOfChannel * n + number - kAllChannels)] =
          value;
  } else {
    state_.registers[number] = value;
  }
  state_.changed_at = t;
}

PinDrive Pca9685Part::channel(int n) const {
  const auto at = [&](int i) {
    return state_.registers[static_cast<std::size_t>(kFirstChannel + kBytesOfChannel * n + i)];
  };
  PinDrive drive;
  drive.mode = PinMode::output;
  if (state_.registers[kMode1] & kAsleep || at(3) & kAlways) return drive;
  const int on = at(0) | (at(1) & 0x0F) << 8, off = at(2) | (at(3) & 0x0F) << 8;
  const int counts = (off - on + kCounts) % kCounts;
  drive.level = (at(1) & kAlways) != 0;
  drive.pwm = !drive.level && counts > 0;
  drive.duty = drive.level ? 1.0 : static_cast<double>(counts) / kCounts;
  if (drive.pwm)
    drive.period_us = static_cast<std::uint32_t>(
        std::lround(kCounts * (state_.registers[kPrescale] + 1) / kOscillator * 1e6));
  return drive;
}

std::string Pca9685Part::pulse(int n) const {
  const PinDrive drive = channel(n);
  if (drive.level) return "on";
  return drive.pwm ? fmt::format("{}us", std::lround(drive.duty * drive.period_us)) : "";
}

void Pca9685Part::stop(SimTime t) {
  for (int n = 0; n < kChannels; ++n)
    context_.netlist.drive_output(output_pin(spec_.index, n), channel(n), t);
}

std::string Pca9685Part::poll_text(SimTime t) {
  if (!state_.text.is_due(state_.changed_at, t)) return {};
  std::string text;
  for (int n = 0; n < kChannels; ++n)
    if (const std::string given = pulse(n); !given.empty())
      text += fmt::format("{}{}:{}", text.empty() ? "" : " ", n, given);
  return state_.text.poll_text(state_.changed_at, text);
}

void Pca9685Part::read(std::vector<Reading>& readings) const {
  int on = 0;
  for (int n = 0; n < kChannels; ++n) on += pulse(n).empty() ? 0 : 1;
  readings.push_back({spec_.name, static_cast<double>(on)});
}

}  // namespace robosim::robot
