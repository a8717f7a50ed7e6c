#include "sim/robot/parts/shift_register.h"

#include <fmt/format.h>

#include <algorithm>

#include "sim/base/did_you_mean.h"
#include "sim/robot/parts/motor_driver.h"

namespace robosim::robot {
namespace {

// A register other than the first of a chain. The part of the first register simulates the whole chain.
class ChainedRegister final : public Part {
 public:
  void register_with(PartRegistry&) override {}
};

std::vector<const ShiftRegisterSpec*> registers_of(const Description& robot) {
  std::vector<const ShiftRegisterSpec*> registers;
  for (const auto& part : robot.parts)
    if (part->type == "shift-register")
      registers.push_back(static_cast<const ShiftRegisterSpec*>(part.get()));
  return registers;
}

const ShiftRegisterSpec* behind(const std::vector<const ShiftRegisterSpec*>& registers,
                                const std::string& name) {
  const auto found =
      std::find_if(registers.begin(), registers.end(), [&](const auto* r) { return r->after == name; });
  return found == registers.end() ? nullptr : *found;
}

std::vector<std::string> names_of(const std::vector<const ShiftRegisterSpec*>& registers) {
  std::vector<std::string> names;
  for (const ShiftRegisterSpec* each : registers) names.push_back(each->name);
  return names;
}

bool is_high(const PinDrive& drive) { return high_share(drive) >= 0.5; }

}  // namespace

std::shared_ptr<const PartSpec> read_shift_register(PartReader& reader) {
  auto spec = std::make_shared<ShiftRegisterSpec>();
  spec->index = *register_of(reader.terminals().registers, reader.name());
  const ConfigValue& table = reader.table().table();
  if (const ConfigValue* after = reader.table().find("after")) {
    spec->after = as_string(*after, "after");
    spec->after_place = after->place;
    if (const ConfigValue* pins = table.find("pins"))
      throw InputError(pins->place,
                       fmt::format("the key after excludes the key pins: {} follows {} and shares its clock "
                                   "and latch",
                                   reader.name(), spec->after));
    return reader.finish(spec);
  }
  if (!table.find("pins"))
    throw InputError(table.place,
                     fmt::format("{} requires either the key pins (data, clock, latch) or the key "
                                 "after (the shift register before it)",
                                 reader.name()));
  std::size_t wiring = 0;
  const std::vector<Pin> pins =
      reader.pin_table({{"data", "clock", "latch"}, {"data", "clock", "latch", "enable"}}, wiring);
  spec->data = pins[0];
  spec->clock = pins[1];
  spec->latch = pins[2];
  if (wiring == 1) spec->enable = pins[3];
  return reader.finish(spec);
}

void check_chains(const Description& robot) {
  const auto registers = registers_of(robot);
  for (const ShiftRegisterSpec* spec : registers) {
    const ShiftRegisterSpec* at = spec;
    for (std::size_t length = 1; !at->after.empty(); ++length) {
      const auto before = std::find_if(registers.begin(), registers.end(),
                                       [&](const auto* r) { return r->name == at->after; });
      if (before == registers.end())
        throw InputError(at->after_place, fmt::format("after: unknown shift register: {}",
                                                      expected_one_of(at->after, names_of(registers))));
      const ShiftRegisterSpec* first = behind(registers, at->after);
      if (first != at)
        throw InputError(at->after_place,
                         fmt::format("{} and {} both follow {}: expected only one register after each",
                                     first->name, at->name, at->after));
      at = *before;
      if (at == spec || length > registers.size())
        throw InputError(
            spec->after_place,
            fmt::format("{} follows itself in a circle: expected a chain that begins at a register "
                        "with pins",
                        spec->name));
      if (length >= kMostChained)
        throw InputError(
            spec->after_place,
            fmt::format("the chain of shift registers is too long: expected at most {}", kMostChained));
    }
  }
}

std::unique_ptr<Part> ShiftRegisterSpec::make(PartContext& context) const {
  if (!after.empty()) return std::make_unique<ChainedRegister>();
  const auto registers = registers_of(context.description);
  std::vector<int> chain;
  for (const ShiftRegisterSpec* at = this; at; at = behind(registers, at->name)) chain.push_back(at->index);
  return std::make_unique<ShiftRegisterPart>(*this, std::move(chain), context);
}

ShiftRegisterPart::ShiftRegisterPart(const ShiftRegisterSpec& head, std::vector<int> chain,
                                     PartContext& context)
    : spec_(head), context_(context), chain_(std::move(chain)) {
  context.snapshots.add(state_);
}

void ShiftRegisterPart::register_with(PartRegistry& registry) {
  for (const Pin pin : {spec_.clock, spec_.latch, spec_.enable})
    if (pin != kNoPin) context_.netlist.watch(pin, *this);
  registry.supplied.push_back(this);
  forget();
  show(0);
}

void ShiftRegisterPart::pin_changed(Pin pin, const PinDrive& drive, SimTime t) {
  if (pin == spec_.enable) return show(t);
  const bool high = is_high(drive);
  bool& before = pin == spec_.clock ? state_.clock : state_.latch;
  const bool rising = high && !before;
  before = high;
  if (!rising || !state_.on) return;
  if (pin == spec_.clock) {
    state_.shifted = state_.shifted << 1 | (is_high(context_.netlist.drive(spec_.data)) ? 1u : 0u);
  } else {
    state_.latched = state_.shifted;
    show(t);
  }
}

void ShiftRegisterPart::power(bool on, SimTime t) {
  state_.on = on;
  if (on) forget();
  show(t);
}

void ShiftRegisterPart::forget() {
  state_.shifted = state_.latched = 0;
  if (context_.sampler.ideal()) return;
  const NoiseStream stream = context_.sampler.noise(spec_.name, "power-on");
  state_.shifted = stream.bits(state_.power_ons++);
  state_.latched = stream.bits(state_.power_ons++);
}

void ShiftRegisterPart::show(SimTime t) {
  const bool driven = state_.on && (spec_.enable == kNoPin || !is_high(context_.netlist.drive(spec_.enable)));
  for (std::size_t r = 0; r < chain_.size(); ++r) {
    for (int q = 0; q < kRegisterOutputs; ++q) {
      PinDrive drive;
      if (driven)
        drive = PinDrive::constant(state_.latched >> (r * kRegisterOutputs + static_cast<unsigned>(q)) & 1);
      context_.netlist.drive_output(output_pin(chain_[r], q), drive, t);
    }
  }
}

}  // namespace robosim::robot
