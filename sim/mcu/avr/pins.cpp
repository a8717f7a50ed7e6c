#include "sim/mcu/avr/pins.h"

#include <algorithm>

#include "hal/board/avr_registers.h"

namespace robosim::avr {
namespace {

constexpr Cycle kSynchroniserCycles = 2;

constexpr std::uint8_t mask_of(int bit) { return static_cast<std::uint8_t>(1 << bit); }

}  // namespace

Pins::Pins(Core& core) : core_(core), port_at_(core.chip.ram_address, -1) {
  for (auto& bits : pin_at_) bits.fill(-1);
  analog_at_.fill(-1);
  for (int pin = 0; pin < core.chip.pin_count; ++pin) {
    const ChipPin& place = core.chip.pins[pin];
    if (place.port >= 0) pin_at_[static_cast<std::size_t>(place.port)][place.bit] = pin;
    if (place.analog_channel >= 0) analog_at_[static_cast<std::size_t>(place.analog_channel)] = pin;
  }
  for (int port = 0; port < core.chip.port_count; ++port) {
    for (std::size_t i = 0; i < 3; ++i) port_at_[core.chip.ports[port].address + i] = port;
    core.cpu.on_read<&Pins::read_pins>(pin_register(port), this);
    core.cpu.on_forecast<&Pins::forecast>(pin_register(port), this);
    core.cpu.on_write<&Pins::toggle>(pin_register(port), this);
    core.cpu.on_write_bit<&Pins::toggle_bit>(pin_register(port), this);
    core.cpu.on_write<&Pins::write_direction>(direction_register(port), this);
    core.cpu.on_write<&Pins::write_latch>(latch_register(port), this);
  }
  core.cpu.on_write<&Pins::write_control>(reg::kMcucr, this);
  for (const std::uint16_t at : core.chip.at.digital_off)
    core.cpu.on_write<&Pins::write_digital_off>(at, this);
  core.keep(state_);
}

void Pins::reset(Cycle) {
  state_.taken.fill({});
  state_.listening = 0;
  state_.some_off = false;
  for (PortState& port : state_.ports) port = {};
  for (int pin = 0; pin < core_.chip.pin_count; ++pin) {
    if (core_.chip.pins[pin].port < 0) continue;
    tell_drive(pin);
    core_.environment.wants_edges(pin, false, core_.now());
  }
}

int Pins::at(char letter, int bit) const {
  for (int port = 0; port < core_.chip.port_count; ++port)
    if (core_.chip.ports[port].letter == letter)
      return pin_at_[static_cast<std::size_t>(port)][static_cast<std::size_t>(bit)];
  return -1;
}

int Pins::named(std::string_view name) const {
  for (int pin = 0; pin < core_.chip.pin_count; ++pin)
    if (name == core_.chip.pins[pin].name) return pin;
  return -1;
}

bool Pins::is_output(int pin) const {
  const Taken& taken = state_.taken[static_cast<std::size_t>(pin)];
  if (taken.taken && taken.even_input) return taken.drive.mode == PinMode::output;
  const ChipPin& place = core_.chip.pins[pin];
  return core_.cpu.data[direction_register(place.port)] & mask_of(place.bit);
}

bool Pins::is_wave(int pin) const {
  const Taken& taken = state_.taken[static_cast<std::size_t>(pin)];
  return taken.taken && taken.drive.pwm && waves_[static_cast<std::size_t>(pin)].level;
}

bool Pins::output_level(int pin) const {
  const Taken& taken = state_.taken[static_cast<std::size_t>(pin)];
  if (is_wave(pin)) {
    const Wave& wave = waves_[static_cast<std::size_t>(pin)];
    return wave.level(wave.self, pin);
  }
  if (taken.taken && !taken.drive.pwm) return taken.drive.level;
  const ChipPin& place = core_.chip.pins[pin];
  return core_.cpu.data[latch_register(place.port)] & mask_of(place.bit);
}

bool Pins::level(int pin) {
  if (is_output(pin)) return output_level(pin);
  return core_.environment.level(pin, is_pulled_up(pin), core_.now(), ReadIntent::port);
}

Source Pins::source(int pin, Cycle at) {
  return pin < 0 ? Source() : core_.environment.source(pin, is_high_by_itself(pin), at);
}

bool Pins::is_high_by_itself(int pin) const {
  const bool in_port = core_.chip.pins[pin].port >= 0;
  return in_port && (is_output(pin) ? output_level(pin) : is_pulled_up(pin));
}

bool Pins::is_pulled_up(int pin) const {
  const ChipPin& place = core_.chip.pins[pin];
  return core_.cpu.data[latch_register(place.port)] & mask_of(place.bit) && has_pull_ups();
}

bool Pins::has_pull_ups() const { return !(core_.cpu.data[reg::kMcucr] & core_.chip.at.pull_ups_off); }

void Pins::write_control(Address address, std::uint8_t value) {
  const bool before = has_pull_ups();
  core_.at(address) = value;
  if (before == has_pull_ups()) return;
  for (int pin = 0; pin < core_.chip.pin_count; ++pin)
    if (core_.chip.pins[pin].port >= 0 && !is_output(pin)) tell_drive(pin);
}

void Pins::write_digital_off(Address address, std::uint8_t value) {
  core_.at(address) = value;
  state_.some_off = false;
  for (const std::uint16_t at : core_.chip.at.digital_off) state_.some_off |= core_.at(at) != 0;
}

// Returns whether the digital input of a pin is on, according to DIDR0 and DIDR1 (24.9.5, 23.3.2). DIDR2, if
// the chip has it, contains the bits of the analog inputs from 8 on. On an ATtiny85, DIDR0 contains one bit
// per pin of the port.
bool Pins::is_read(int pin) const {
  if (!state_.some_off) [[likely]]
    return true;
  const auto& data = core_.cpu.data;
  const auto& [first, second, third] = core_.chip.at.digital_off;
  const ChipPin& place = core_.chip.pins[pin];
  if (first == second) return !(data[first] >> place.bit & 1);
  const int analog = data[first] | data[third] << 8, comparator = data[second];
  if (place.analog_channel >= 0 && analog >> place.analog_channel & 1) return false;
  return !(comparator & 1 && pin == named(core_.chip.comparator.positive)) &&
         !(comparator & 2 && pin == named(core_.chip.comparator.negative));
}

std::uint8_t Pins::read_pins(Address address) {
  const int number = port_at_[address];
  PortState& port = state_.ports[static_cast<std::size_t>(number)];
  // Reads only the bits that the instruction uses. Reading a sensor can be slow, and can consume a sample of
  // the sensor's noise.
  const std::uint8_t asked = core_.cpu.bits_read(core_.cpu.last_pc());
  const Cycle now = core_.now();
  const bool settled = now >= port.changed_at + kSynchroniserCycles;
  const std::uint8_t latch_then = settled ? core_.at(latch_register(number)) : port.latch_before;
  const std::uint8_t output_then = settled ? core_.at(direction_register(number)) : port.direction_before;
  const std::uint8_t tested = core_.cpu.bits_tested(core_.cpu.last_pc());
  Pin read = kNoPin;
  for (int bit = 0; bit < 8; ++bit) {
    const std::uint8_t mask = mask_of(bit);
    const int pin = pin_at_[static_cast<std::size_t>(number)][static_cast<std::size_t>(bit)];
    if (!(asked & mask) || pin < 0) continue;
    const Taken& taken = state_.taken[static_cast<std::size_t>(pin)];
    bool level = latch_then & mask;
    if (!is_read(pin)) {
      level = false;
    } else if (taken.taken && is_output(pin)) {
      level = output_level(pin);
    } else if (!(output_then & mask)) {
      const bool pull_up = level && has_pull_ups();
      level = core_.environment.level(pin, pull_up, now,
                                      asked == Cpu::kAllBits ? ReadIntent::port : ReadIntent::pin);
      state_.last_read = pin;
      state_.last_read_at = now;
      if (tested & mask) read = read == kNoPin ? static_cast<Pin>(pin) : InputReads::kSeveral;
    }
    port.seen = static_cast<std::uint8_t>(level ? port.seen | mask : port.seen & ~mask);
  }
  if (read != kNoPin) note(read);
  core_.at(address) = port.seen;
  return port.seen;
}

ReadForecast Pins::forecast(Address address, std::uint8_t bits) {
  const int number = port_at_[address];
  const PortState& port = state_.ports[static_cast<std::size_t>(number)];
  const Cycle now = core_.now();
  if (now < port.changed_at + kSynchroniserCycles) return {};
  ReadForecast forecast{kNoCycle, static_cast<std::uint8_t>(port.seen & ~bits)};
  for (int bit = 0; bit < 8; ++bit) {
    const std::uint8_t mask = mask_of(bit);
    const int pin = pin_at_[static_cast<std::size_t>(number)][static_cast<std::size_t>(bit)];
    if (!(bits & mask)) continue;
    if (pin < 0 || !is_read(pin)) {
      forecast.value |= pin < 0 ? port.seen & mask : 0;
      continue;
    }
    if (is_wave(pin)) return {};
    if (!is_output(pin)) forecast.until = std::min(forecast.until, core_.environment.level_until(pin, now));
    if (forecast.until <= now) return {};
    if (level(pin)) forecast.value |= mask;
  }
  return forecast;
}

void Pins::toggle(Address address, std::uint8_t value) {
  const int port = port_at_[address];
  set_latch(port, core_.at(latch_register(port)) ^ value);
}

void Pins::toggle_bit(Address address, std::uint8_t, std::uint8_t bit) { toggle(address, bit); }

void Pins::write_latch(Address address, std::uint8_t value) { set_latch(port_at_[address], value); }

void Pins::will_change(int port) {
  PortState& state = state_.ports[static_cast<std::size_t>(port)];
  state.latch_before = core_.at(latch_register(port));
  state.direction_before = core_.at(direction_register(port));
  state.changed_at = core_.now();
}

void Pins::set_latch(int port, std::uint8_t value) {
  const std::uint8_t bits = core_.at(latch_register(port)) ^ value;
  if (!bits) return;
  will_change(port);
  core_.at(latch_register(port)) = value;
  changed(port, bits);
}

void Pins::write_direction(Address address, std::uint8_t value) {
  const int port = port_at_[address];
  const std::uint8_t bits = core_.at(address) ^ value;
  if (!bits) return;
  will_change(port);
  core_.at(address) = value;
  changed(port, bits);
}

void Pins::changed(int port, std::uint8_t bits) {
  for (int bit = 0; bit < 8; ++bit) {
    const int pin = pin_at_[static_cast<std::size_t>(port)][static_cast<std::size_t>(bit)];
    if (!(bits & mask_of(bit)) || pin < 0) continue;
    tell_drive(pin);
    if (is_heard(pin)) tell_listeners(pin, level(pin), core_.now());
  }
}

void Pins::tell_drive(int pin) {
  const Taken& taken = state_.taken[static_cast<std::size_t>(pin)];
  const ChipPin& place = core_.chip.pins[pin];
  const bool latch = core_.at(latch_register(place.port)) & mask_of(place.bit);
  PinDrive drive;
  if (taken.taken && is_output(pin)) {
    drive = taken.drive;
  } else if (!is_output(pin)) {
    drive.mode = latch && has_pull_ups() ? PinMode::input_pullup : PinMode::input;
  } else {
    drive = PinDrive::constant(latch);
  }
  core_.environment.driven(pin, drive, core_.now());
}

void Pins::take(int pin, const PinDrive& drive, bool even_input) {
  state_.taken[static_cast<std::size_t>(pin)] = {true, even_input, drive};
  tell_drive(pin);
  if (is_heard(pin) && !is_wave(pin)) tell_listeners(pin, level(pin), core_.now());
}

void Pins::give_back(int pin) {
  Taken& taken = state_.taken[static_cast<std::size_t>(pin)];
  if (!taken.taken) return;
  taken = {};
  tell_drive(pin);
  if (is_heard(pin)) tell_listeners(pin, level(pin), core_.now());
}

bool Pins::is_heard(int pin) const {
  for (std::size_t i = 0; i < listeners_.size(); ++i)
    if (listeners_[i].pin == pin && state_.listening >> i & 1) return true;
  return false;
}

void Pins::listen(int listener, bool on) {
  const std::uint64_t bit = std::uint64_t{1} << listener;
  if (static_cast<bool>(state_.listening & bit) == on) return;
  const int pin = listeners_[static_cast<std::size_t>(listener)].pin;
  const bool before = is_heard(pin);
  state_.listening ^= bit;
  const bool now = is_heard(pin);
  if (before == now) return;
  const bool found = core_.environment.wants_edges(pin, now, core_.now());
  if (now) state_.heard_level[static_cast<std::size_t>(pin)] = is_output(pin) ? output_level(pin) : found;
  if (const Wave& wave = waves_[static_cast<std::size_t>(pin)]; wave.heard) wave.heard(wave.self, pin, now);
}

void Pins::edge(int pin, bool level, Cycle at) {
  if (!is_output(pin)) tell_listeners(pin, level, at);
}

void Pins::tell_listeners(int pin, bool level, Cycle at) {
  bool& heard = state_.heard_level[static_cast<std::size_t>(pin)];
  if (heard == level) return;
  heard = level;
  for (std::size_t i = 0; i < listeners_.size(); ++i)
    if (listeners_[i].pin == pin && state_.listening >> i & 1)
      listeners_[i].listener.call(listeners_[i].listener.self, pin, level, at);
}

}  // namespace robosim::avr
