#include "sim/robot/parts/ir_receiver.h"

#include <fmt/format.h>

#include <algorithm>

#include "sim/base/error.h"
#include "sim/base/parse_unsigned.h"

namespace robosim::robot {
namespace {

constexpr SimTime kUnit = 562'500;  // ns
constexpr SimTime kFrame = 108 * kMillisecond;
constexpr SimTime kLongestHeld = 60 * kSecond;
constexpr SimTime kPause = 40 * kMillisecond;  // between two keys

constexpr FaultKind kIrReceiverFaults[] = {
    {Failure::ok, "works again"},
    {Failure::dead, "nothing arrives"},
};

/// Adds light for `on`, then a pause for `off`. Returns the end of the pause.
SimTime add_mark(PulseTrain& line, SimTime at, SimTime on, SimTime off) {
  line.flip(at);
  line.flip(at + on);
  return at + on + off;
}

}  // namespace

std::shared_ptr<const PartSpec> read_ir_receiver(PartReader& reader) {
  auto spec = std::make_shared<IrReceiverSpec>();
  spec->pin = reader.pin("pin", PinUse::digital);
  spec->address = static_cast<std::uint8_t>(reader.table().integer("address", 0, 0, 255));
  return reader.finish(spec);
}

std::unique_ptr<Part> IrReceiverSpec::make(PartContext& context) const {
  return std::make_unique<IrReceiverPart>(*this, context);
}

IrReceiverPart::IrReceiverPart(const IrReceiverSpec& spec, PartContext& context)
    : spec_(spec), context_(context) {
  context.snapshots.add(state_);
}

void IrReceiverPart::register_with(PartRegistry& registry) {
  context_.board.connect(spec_.pin, *this);
  registry.ticking.push_back(this);
  registry.breakable.push_back(this);
  registry.receivers.push_back(this);
}

void IrReceiverPart::check(const Message& message) const {
  if (message.held > kLongestHeld)
    throw InputError(
        fmt::format("send {} {}: the key is held too long: expected at most 60 s", spec_.name, message.text));
  if (parse_unsigned(message.text).value_or(256) > 255)
    throw InputError(fmt::format("send {}: expected a command from 0 to 255, such as 0x45, got “{}”",
                                 spec_.name, message.text));
}

void IrReceiverPart::send(const Message& message, SimTime t) {
  if (state_.dead) return;
  const std::uint32_t command = static_cast<std::uint32_t>(parse_unsigned(message.text).value_or(0));
  const std::uint32_t address = spec_.address;
  const std::uint32_t bits = address | (address ^ 0xFF) << 8 | command << 16 | (command ^ 0xFF) << 24;
  const SimTime begin = state_.line.empty() ? t : std::max(t, state_.line.end() + kPause);
  SimTime at = add_mark(state_.line, begin, 16 * kUnit, 8 * kUnit);
  for (int bit = 0; bit < 32; ++bit)
    at = add_mark(state_.line, at, kUnit, (bits >> bit & 1) ? 3 * kUnit : kUnit);
  add_mark(state_.line, at, kUnit, 0);
  for (SimTime again = begin + kFrame; again < begin + message.held; again += kFrame)
    add_mark(state_.line, add_mark(state_.line, again, 16 * kUnit, 4 * kUnit), kUnit, 0);
}

void IrReceiverPart::begin_tick(SimTime t) {
  if (!state_.line.empty()) state_.line.begin_tick(context_.board, spec_.pin, t);
}

void IrReceiverPart::read(std::vector<Reading>& readings) const {
  readings.push_back({spec_.name, state_.line.empty() ? 0.0 : 1.0});
}

std::span<const FaultKind> IrReceiverPart::fault_kinds() const { return kIrReceiverFaults; }

void IrReceiverPart::fail(const Fault& fault) { state_.dead = fault.failure == Failure::dead; }

}  // namespace robosim::robot
