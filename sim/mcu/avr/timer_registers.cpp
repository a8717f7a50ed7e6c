// Implements the registers of a timer (DS40002061B: 15.9; 16.3, 16 bits through TEMP; 16.11, 18.11).
#include "sim/mcu/avr/timer.h"

namespace robosim::avr {
namespace {

constexpr Address high(std::uint16_t address) { return static_cast<Address>(address + 1); }

}  // namespace

void Timer::hook_registers() {
  Cpu& cpu = core_.cpu;
  const auto control = static_cast<Address>(spec_.control);
  const auto keeps = [&](Address plain) {
    cpu.on_read<&Timer::read_plain>(plain, this);
    cpu.is_steady(plain);
  };
  keeps(control);
  if (spec_.top) {
    hook_pll_registers();
  } else {
    cpu.on_write<&Timer::write_control_a>(control, this);
    cpu.on_write<&Timer::write_control_b>(control_b_, this);
    keeps(control_b_);
  }
  if (!shares_flags(spec_)) {
    cpu.on_write<&Timer::write_enables>(spec_.enables, this);
    keeps(spec_.enables);
    cpu.on_read<&Timer::read_flags>(spec_.flags, this);
    cpu.on_write<&Timer::write_flags>(spec_.flags, this);
    cpu.on_write_bit<&Timer::write_flag>(spec_.flags, this);
    cpu.on_forecast<&Timer::forecast_of_flags>(spec_.flags, this);
  }
  cpu.on_read<&Timer::read_count>(spec_.count, this);
  if (!is_wide()) cpu.on_forecast<&Timer::forecast_of_count>(spec_.count, this);
  cpu.on_write<&Timer::write_count>(spec_.count, this);
  for (const std::uint16_t compare : compares()) {
    cpu.on_write<&Timer::write_compare>(compare, this);
    keeps(compare);
  }
  if (!is_wide()) return;
  for (const std::uint16_t compare : compares()) cpu.on_read<&Timer::read_plain>(high(compare), this);
  cpu.on_write<&Timer::write_control_c>(static_cast<Address>(control + 2), this);
  for (const std::uint16_t low : {spec_.count, spec_.capture})
    cpu.on_write<&Timer::write_temp>(high(low), this);
  for (const std::uint16_t compare : compares()) cpu.on_write<&Timer::write_temp>(high(compare), this);
  cpu.on_read<&Timer::read_temp>(high(spec_.count), this);
  cpu.on_read<&Timer::read_temp>(high(spec_.capture), this);
  cpu.on_read<&Timer::read_capture>(spec_.capture, this);
  cpu.on_write<&Timer::write_capture>(spec_.capture, this);
}

void Timer::write_control_a(Address address, std::uint8_t value) {
  count_to(core_.now());
  if (!state_.runs) return;
  core_.at(address) = state_.control_a = value;
  set_mode();
  settle();
}

void Timer::write_control_b(Address address, std::uint8_t value) {
  count_to(core_.now());
  if (!state_.runs) return;
  const std::uint8_t before = core_.at(address);
  core_.at(address) = state_.control_b =
      is_wide() ? value : static_cast<std::uint8_t>(value & ~(kFoca | kFocb));
  if (spec_.capture) {
    if (value & ~before & kIcnc) state_.canceler.begin(capture_level());
    if (value & (kIcnc | kIces)) want_captures();
  }
  set_mode();
  if (!is_wide()) force(value);
  settle();
}

void Timer::write_control_c(Address, std::uint8_t value) {
  count_to(core_.now());
  if (!state_.runs) return;
  force(value);
  settle();
}

void Timer::write_enables(Address address, std::uint8_t value) {
  count_to(core_.now());
  if (!state_.runs) return;
  core_.at(address) = value & flags_there_are();
  set_enables(core_.at(address));
}

void Timer::set_enables(std::uint8_t enables) {
  state_.enables = enables;
  if (enables & kCaptured) want_captures();
  settle();
}

std::uint8_t Timer::in_register(std::uint8_t flags) const {
  unsigned bits = 0;
  for (unsigned flag = 0; flag < std::size(spec_.flag_bits); ++flag)
    bits |= (flags >> flag & 1u) << spec_.flag_bits[flag];
  return static_cast<std::uint8_t>(bits);
}

std::uint8_t Timer::of_register(std::uint8_t bits) const {
  unsigned flags = 0;
  for (unsigned flag = 0; flag < std::size(spec_.flag_bits); ++flag)
    flags |= (bits >> spec_.flag_bits[flag] & 1u) << flag;
  return static_cast<std::uint8_t>(flags);
}

std::uint8_t Timer::flags_in_register() {
  if (!state_.runs) return 0;
  count_to(before_now());
  return in_register(state_.flags);
}

void Timer::enable_in_register(std::uint8_t flags) {
  count_to(core_.now());
  if (state_.runs) set_enables(of_register(flags));
}

std::uint8_t Timer::read_flags(Address address) {
  if (!state_.runs) return 0;
  count_to(before_now());
  want_captures();
  return core_.at(address) = state_.flags;
}

// Predicts reads of the flags. A flag that a tick sets still reads as 0 in the cycle of the tick.
ReadForecast Timer::forecast_of_flags(Address, std::uint8_t) {
  if (!state_.runs) return {kNoCycle, 0};
  count_to(before_now());
  if (next_edge() != kNoCycle) return {};
  const auto unset = static_cast<std::uint8_t>(flags_of_ticks() & ~state_.flags);
  const Cycle tick = ticks_come() && unset ? tick_after(state_.at, state_.counter.ticks_to(unset)) : kNoCycle;
  return {tick == kNoCycle ? kNoCycle : tick + 1, state_.flags};
}

void Timer::write_flags(Address, std::uint8_t value) { clear_flags(value); }

void Timer::write_flag(Address, std::uint8_t value, std::uint8_t bit) { clear_flags(value & bit); }

void Timer::clear_flags(std::uint8_t flags) {
  count_to(before_now());
  if (!state_.runs) return;
  if (flags & kCaptured) want_captures();
  state_.flags &= static_cast<std::uint8_t>(~flags);
  settle();
}

std::uint16_t Timer::with_temp(std::uint8_t low) const {
  return static_cast<std::uint16_t>(is_wide() ? state_.temp << 8 | low : low);
}

void Timer::write_temp(Address, std::uint8_t value) {
  if (state_.runs) state_.temp = value;
}

std::uint8_t Timer::show(Address address, std::uint16_t value) {
  core_.at(address) = static_cast<std::uint8_t>(value);
  if (is_wide()) core_.at(high(address)) = static_cast<std::uint8_t>(value >> 8);
  return core_.at(address);
}

std::uint8_t Timer::read_count(Address address) {
  if (!state_.runs) return 0;
  count_to(before_now());
  const std::uint16_t value = state_.counter.value();
  state_.temp = static_cast<std::uint8_t>(value >> 8);
  return show(address, value);
}

ReadForecast Timer::forecast_of_count(Address, std::uint8_t) {
  if (!state_.runs) return {kNoCycle, 0};
  count_to(before_now());
  const auto value = static_cast<std::uint8_t>(state_.counter.value());
  if (next_edge() != kNoCycle) return {};
  if (!ticks_come()) return {kNoCycle, value};
  const Cycle turn = tick_after(state_.at, state_.counter.ticks_upwards() + 1);
  return {turn + 1, value, tick_after(state_.at, 1) + 1, Cycle{1} << state_.shift};
}

void Timer::write_count(Address, std::uint8_t value) {
  count_to(core_.now());
  if (!state_.runs) return;
  state_.counter.set_value(with_temp(value));
  if (!ticks_come()) state_.drives_stale = true;
  settle();
}

void Timer::write_compare(Address address, std::uint8_t value) {
  count_to(core_.now());
  if (!state_.runs) return;
  const std::uint16_t compare = with_temp(value);
  show(address, compare);
  state_.counter.write_compare(channel_at(address), compare);
  if (!state_.counter.waits()) state_.drives_stale = true;
  settle();
}

std::uint8_t Timer::read_capture(Address address) {
  if (!state_.runs) return 0;
  count_to(before_now());
  want_captures();
  const std::uint16_t value = state_.counter.capture();
  state_.temp = static_cast<std::uint8_t>(value >> 8);
  return show(address, value);
}

// Writes ICRn, which is writable only while it is TOP (16.11.7).
void Timer::write_capture(Address address, std::uint8_t value) {
  count_to(core_.now());
  if (!state_.runs || state_.counter.how().top != Counting::Top::capture) return;
  state_.counter.set_capture(with_temp(value));
  show(address, with_temp(value));
  state_.drives_stale = true;
  settle();
}

}  // namespace robosim::avr
