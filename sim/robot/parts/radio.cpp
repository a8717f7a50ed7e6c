#include "sim/robot/parts/radio.h"

#include <fmt/format.h>

#include <algorithm>

#include "sim/base/error.h"
#include "sim/base/parse_unsigned.h"

namespace robosim::robot {
namespace {

constexpr FaultKind kRadioFaults[] = {
    {Failure::ok, "works again"},
    {Failure::dead, "nothing arrives"},
    {Failure::noisy, "this share of the bits arrives wrong, such as 0.1 or 10%", FaultKind::Argument::number,
     0.0, 1.0},
};

constexpr std::size_t kMostRadioBits = 64;  // of one message

/// Returns the bits of a message; empty if the message is invalid.
std::vector<bool> bits_of(const std::string& text) {
  std::vector<bool> bits;
  if (text.starts_with("0b")) {
    const std::string digits = text.substr(2);
    if (digits.size() > kMostRadioBits || digits.find_first_not_of("01") != std::string::npos) return {};
    for (const char digit : digits) bits.push_back(digit == '1');
  } else if (const auto byte = parse_unsigned(text); byte && *byte <= 255) {
    for (int bit = 7; bit >= 0; --bit) bits.push_back((*byte >> bit & 1) != 0);
  }
  return bits;
}

}  // namespace

std::shared_ptr<const PartSpec> read_radio(PartReader& reader) {
  auto spec = std::make_shared<RadioSpec>();
  std::size_t wiring = 0;
  const std::vector<Pin> pins = reader.pin_table({{"data", "clock", "enable"}}, wiring);
  spec->data = pins[0];
  spec->clock = pins[1];
  spec->enable = pins[2];
  spec->bit = reader.figure("bit", Dimension::time, {1e-3, 0.0}, 20e-6, 0.1);
  return reader.finish(spec);
}

std::unique_ptr<Part> RadioSpec::make(PartContext& context) const {
  return std::make_unique<RadioPart>(*this, context);
}

RadioPart::RadioPart(const RadioSpec& spec, PartContext& context)
    : spec_(spec),
      context_(context),
      outputs_{{*this, data}, {*this, clock}, {*this, enable}},
      stream_(context.sampler.noise(spec.name, "air")),
      bit_(static_cast<SimTime>(context.sampler.draw(spec.bit, spec.name, "bit") * 1e9)) {
  context.snapshots.add(state_);
}

void RadioPart::register_with(PartRegistry& registry) {
  for (const Line line : {data, clock, enable}) context_.board.connect(pin_of(line), outputs_[line]);
  registry.ticking.push_back(this);
  registry.breakable.push_back(this);
  registry.receivers.push_back(this);
}

Pin RadioPart::pin_of(Line line) const {
  return line == data ? spec_.data : line == clock ? spec_.clock : spec_.enable;
}

void RadioPart::check(const Message& message) const {
  if (bits_of(message.text).empty())
    throw InputError(
        fmt::format("send {}: expected a byte, 0 to 255, or at most {} bits such as 0b101, got \"{}\"",
                    spec_.name, kMostRadioBits, message.text));
}

void RadioPart::send(const Message& message, SimTime t) {
  if (state_.dead) return;
  if (state_.announced == state_.changes.size()) {
    state_.changes.clear();
    state_.announced = 0;
  }
  SimTime at = std::max(t, state_.free_at);
  state_.changes.push_back({at, enable, true});
  at += bit_ / 2;
  for (const bool bit : bits_of(message.text)) {
    const bool wrong = stream_.uniform(state_.bits_sent++) < state_.turned;
    state_.changes.push_back({at, data, bit != wrong});
    state_.changes.push_back({at + bit_ / 2, clock, true});
    at += bit_;
    state_.changes.push_back({at, clock, false});
  }
  state_.changes.push_back({at, data, false});
  at += bit_ / 2;
  state_.changes.push_back({at, enable, false});
  state_.free_at = at + bit_;
}

bool RadioPart::level(Line line, SimTime t) const {
  bool level = false;
  for (const Change& change : state_.changes) {
    if (change.at > t) break;
    if (change.line == line) level = change.level;
  }
  return level;
}

void RadioPart::begin_tick(SimTime t) {
  for (; state_.announced < state_.changes.size() && state_.changes[state_.announced].at < t + kTick;
       ++state_.announced) {
    const Change& change = state_.changes[state_.announced];
    const Pin pin = pin_of(change.line);
    if (context_.board.wants_edges(pin))
      context_.board.schedule_edge(pin, change.level, std::max(change.at, t));
  }
}

void RadioPart::read(std::vector<Reading>& readings) const {
  readings.push_back({spec_.name, level(enable, context_.view.tick_start) ? 1.0 : 0.0});
}

std::span<const FaultKind> RadioPart::fault_kinds() const { return kRadioFaults; }

void RadioPart::fail(const Fault& fault) {
  state_.dead = fault.failure == Failure::dead;
  state_.turned = fault.failure == Failure::noisy ? fault.number : 0.0;
}

}  // namespace robosim::robot
