#include "sim/mcu/avr/external_interrupts.h"

#include <algorithm>

namespace robosim::avr {
namespace {

constexpr Cycle kIntCycles = 2, kPcintCycles = 3;
constexpr std::size_t kSensesPerRegister = 4;  // in EICRA; EICRB has the ISCn of the other lines

constexpr std::uint8_t flag_bit(std::size_t number) { return static_cast<std::uint8_t>(1u << number); }
constexpr std::uint8_t flag_bits(std::size_t count, unsigned from) {
  return static_cast<std::uint8_t>(((1u << count) - 1) << from);
}
/// Returns `kept` with the bits in `mask` replaced by bits of `value`.
constexpr std::uint8_t replaced(std::uint8_t kept, std::uint8_t value, std::uint8_t mask) {
  return static_cast<std::uint8_t>((kept & ~mask) | (value & mask));
}

}  // namespace

ExternalInterrupts::ExternalInterrupts(Core& core, Pins& pins) : core_(core), at_(core.chip.at), pins_(pins) {
  using Self = ExternalInterrupts;
  for (Group& group : groups_) group.pins.fill(-1);
  for (int pin = 0; pin < core.chip.pin_count; ++pin) {
    const ChipPin& place = core.chip.pins[pin];
    if (place.external >= 0)
      lines_[static_cast<std::size_t>(place.external)] = {
          pin, pins.add_listener<&Self::external_changed>(pin, this)};
    if (place.change < 0) continue;
    Group& group = groups_[static_cast<std::size_t>(place.change / 8)];
    const auto bit = static_cast<std::size_t>(place.change % 8);
    group.pins[bit] = pin;
    group.listeners[bit] = pins.add_listener<&Self::pin_changed>(pin, this);
  }
  for (std::size_t number = 0; number < lines(); ++number) {
    if (number % kSensesPerRegister == 0)
      core.cpu.also_on_write<&Self::write_sense>(
          static_cast<Address>(at_.external_sense + number / kSensesPerRegister), this);
    core.interrupts.on_entry<&Self::external_entered>(vector(number), this);
    core.triggers.offer<&Self::awaited>(vector(number), this);
  }
  for (std::size_t group = 0; group < groups(); ++group) {
    core.cpu.on_write<&Self::write_change_mask>(static_cast<Address>(at_.change_masks + group), this);
    core.interrupts.on_entry<&Self::change_entered>(change_vector(group), this);
    core.triggers.offer<&Self::change_awaited>(change_vector(group), this);
  }
  core.cpu.on_write<&Self::write_enables>(at_.external_enables, this);
  core.cpu.on_write<&Self::write_flags>(at_.external_flags, this);
  core.cpu.on_write_bit<&Self::write_flag_bit>(at_.external_flags, this);
  core.cpu.also_on_write<&Self::write_change_enables>(at_.change_enables, this);
  core.cpu.also_on_write<&Self::write_change_flags>(at_.change_flags, this);
  core.cpu.on_write_bit<&Self::write_change_flag_bit>(at_.change_flags, this);
  flags_ = core.events.add<&Self::set_flags>(this);
  core.keep(state_);
}

void ExternalInterrupts::reset(Cycle) { state_ = {}; }

ExternalInterrupts::Sense ExternalInterrupts::sense(std::size_t number) const {
  const std::uint8_t control = core_.cpu.data[at_.external_sense + number / kSensesPerRegister];
  return static_cast<Sense>(control >> (2 * (number % kSensesPerRegister)) & 3);
}

void ExternalInterrupts::listen_or_not(std::size_t number) {
  LineState& line = state_.lines[number];
  const bool listens =
      sense(number) != Sense::low_level || core_.at(at_.external_enables) & external_bit(number);
  if (listens == line.listening || lines_[number].pin < 0) return;
  line.listening = listens;
  pins_.listen(lines_[number].listener, listens);
  if (listens) line.level = pins_.heard_level(lines_[number].pin);
}

std::uint64_t ExternalInterrupts::may_interrupt() const {
  const std::vector<std::uint8_t>& data = core_.cpu.data;
  std::uint64_t vectors = 0;
  for (std::size_t number = 0; number < lines(); ++number)
    vectors |= Interrupts::bit(vector(number), data[at_.external_enables] & external_bit(number));
  for (std::size_t group = 0; group < groups(); ++group)
    vectors |= Interrupts::bit(change_vector(group), data[at_.change_enables] & change_bit(group) &&
                                                         data[at_.change_masks + group] != 0);
  return vectors;
}

void ExternalInterrupts::request(std::size_t number) {
  const std::uint8_t bit = external_bit(number);
  const LineState& line = state_.lines[number];
  const bool by_level = sense(number) == Sense::low_level;
  const bool wanted = by_level ? line.listening && !line.level : (core_.at(at_.external_flags) & bit) != 0;
  core_.request(vector(number), wanted && core_.at(at_.external_enables) & bit);
}

void ExternalInterrupts::request_change(std::size_t group) {
  core_.request(change_vector(group),
                core_.at(at_.change_flags) & core_.at(at_.change_enables) & change_bit(group));
}

void ExternalInterrupts::write_sense(Address address, std::uint8_t value) {
  core_.at(address) = value;
  for (std::size_t number = 0; number < lines(); ++number) {
    if (sense(number) == Sense::low_level) {
      core_.at(at_.external_flags) &= static_cast<std::uint8_t>(~external_bit(number));
      state_.lines[number].flag_at = kNoCycle;
    }
    listen_or_not(number);
    request(number);
  }
  schedule();
}

void ExternalInterrupts::write_enables(Address address, std::uint8_t value) {
  core_.at(address) = replaced(core_.at(address), value, flag_bits(lines(), at_.external_bit));
  for (std::size_t number = 0; number < lines(); ++number) {
    listen_or_not(number);
    request(number);
  }
}

void ExternalInterrupts::write_flags(Address address, std::uint8_t value) {
  core_.at(address) &= static_cast<std::uint8_t>(~value);
  for (std::size_t number = 0; number < lines(); ++number) request(number);
}

void ExternalInterrupts::write_flag_bit(Address address, std::uint8_t value, std::uint8_t bit) {
  write_flags(address, value & bit);
}

void ExternalInterrupts::write_change_enables(Address address, std::uint8_t value) {
  core_.at(address) = replaced(core_.at(address), value, flag_bits(groups(), at_.change_bit));
  for (std::size_t group = 0; group < groups(); ++group) request_change(group);
}

void ExternalInterrupts::write_change_mask(Address address, std::uint8_t value) {
  const Group& group = groups_[static_cast<std::size_t>(address - at_.change_masks)];
  const std::uint8_t changed = core_.at(address) ^ value;
  core_.at(address) = value;
  for (std::size_t bit = 0; bit < 8; ++bit)
    if (changed & flag_bit(bit) && group.pins[bit] >= 0)
      pins_.listen(group.listeners[bit], value & flag_bit(bit));
}

void ExternalInterrupts::write_change_flags(Address address, std::uint8_t value) {
  core_.at(address) &= static_cast<std::uint8_t>(~value);
  for (std::size_t group = 0; group < groups(); ++group) request_change(group);
}

void ExternalInterrupts::write_change_flag_bit(Address address, std::uint8_t value, std::uint8_t bit) {
  write_change_flags(address, value & bit);
}

void ExternalInterrupts::external_changed(int pin, bool level, Cycle at) {
  const auto number = static_cast<std::size_t>(core_.chip.pins[pin].external);
  state_.lines[number].level = level;
  if (sense(number) == Sense::low_level) {
    request(number);
  } else {
    edge(number, level, at);
  }
}

void ExternalInterrupts::edge(std::size_t number, bool level, Cycle at) {
  const Sense wanted = sense(number);
  if (wanted == Sense::low_level || wanted == (level ? Sense::falling : Sense::rising)) return;
  LineState& line = state_.lines[number];
  line.flag_at = std::min(line.flag_at, at + kIntCycles);
  schedule();
}

void ExternalInterrupts::pin_changed(int pin, bool, Cycle at) {
  Cycle& flag_at = state_.change_flag_at[static_cast<std::size_t>(core_.chip.pins[pin].change / 8)];
  flag_at = std::min(flag_at, at + kPcintCycles);
  schedule();
}

void ExternalInterrupts::schedule() {
  Cycle next = kNoCycle;
  for (const LineState& line : state_.lines) next = std::min(next, line.flag_at);
  for (const Cycle flag_at : state_.change_flag_at) next = std::min(next, flag_at);
  if (next != core_.events.due(flags_)) core_.schedule(flags_, next);
}

void ExternalInterrupts::set_flags(Cycle at) {
  for (std::size_t number = 0; number < lines(); ++number) {
    LineState& line = state_.lines[number];
    if (line.flag_at > at) continue;
    line.flag_at = kNoCycle;
    std::uint8_t& flags = core_.at(at_.external_flags);
    const bool rises = !(flags & external_bit(number));
    flags |= external_bit(number);
    request(number);
    if (rises) core_.triggers.raised(vector(number), at);
    if (!rises && core_.at(at_.external_enables) & external_bit(number)) core_.lose(vector(number));
  }
  for (std::size_t group = 0; group < groups(); ++group) {
    if (state_.change_flag_at[group] > at) continue;
    state_.change_flag_at[group] = kNoCycle;
    std::uint8_t& flags = core_.at(at_.change_flags);
    const bool rises = !(flags & change_bit(group));
    flags |= change_bit(group);
    request_change(group);
    if (rises) core_.triggers.raised(change_vector(group), at);
  }
  schedule();
}

void ExternalInterrupts::external_entered(int vector) {
  const auto number = static_cast<std::size_t>(vector - core_.chip.external_vector);
  core_.at(at_.external_flags) &= static_cast<std::uint8_t>(~external_bit(number));
  request(number);
}

void ExternalInterrupts::change_entered(int vector) {
  const auto group = static_cast<std::size_t>(vector - core_.chip.change_vector);
  core_.at(at_.change_flags) &= static_cast<std::uint8_t>(~change_bit(group));
  request_change(group);
}

bool ExternalInterrupts::awaited(int vector, bool) {
  return core_.at(at_.external_flags) &
         external_bit(static_cast<std::size_t>(vector - core_.chip.external_vector));
}

bool ExternalInterrupts::change_awaited(int vector, bool) {
  return core_.at(at_.change_flags) & change_bit(static_cast<std::size_t>(vector - core_.chip.change_vector));
}

}  // namespace robosim::avr
