#include "sim/exec/core/board_state.h"

#include <algorithm>

namespace robosim::exec {

BoardState::BoardState(const BoardSpec& spec)
    : spec_(spec), wires_(spec.pin_count + 1u), supply_volts_(&spec.supply_volts) {
  state_.pins.resize(spec.pin_count + 1u);
  state_.eeprom.assign(spec.eeprom_bytes, 0xFF);
}

void BoardState::set_drive(Pin pin, const PinDrive& drive, SimTime t) {
  if (pin >= spec_.pin_count) return;
  PinState& state = state_.pins[pin];
  if (state.drive == drive) return;
  state.drive = drive;
  state.use.pulled_up |= drive.mode == PinMode::input_pullup;
  if (state.wants_edges && drive.mode == PinMode::output) state.last_level = level_on(pin, t);
  for (PinWatcher* watcher : wires_[pin].watchers) watcher->pin_changed(pin, drive, t);
}

void BoardState::set_drive_heard(Pin pin, const PinDrive& drive, SimTime t) {
  if (drive.mode == PinMode::output && !drive.pwm && wants_edges(pin)) schedule_edge(pin, drive.level, t);
  set_drive(pin, drive, t);
}

bool BoardState::level_on(Pin pin, SimTime t) {
  const PinState& state = state_.pins[pin];
  if (state.drive.mode == PinMode::output)
    return state.drive.pwm ? state.drive.duty >= 0.5 : state.drive.level;
  if (PinSource* source = wires_[pin].source) return source->level(t);
  return state.drive.mode == PinMode::input_pullup;
}

bool BoardState::read_level(Pin pin, SimTime t, ReadIntent intent) {
  if (pin >= spec_.pin_count) return false;
  const bool level = level_on(pin, t);
  PinUse& use = state_.pins[pin].use;
  use.read = true;
  use.looked_at |= intent == ReadIntent::pin;
  use.last_seen = t;
  (level ? use.was_high : use.was_low) = true;
  if (input_watcher_) input_watcher_->level_seen(pin, level, t);
  return level;
}

SimTime BoardState::same_until(Pin pin, SimTime t) const {
  if (input_watcher_) return t;
  if (pin >= spec_.pin_count || drive(pin).mode == PinMode::output) return kNever;
  PinSource* const source = wires_[pin].source;
  return source ? source->same_until(t) : kNever;
}

Source BoardState::read_source(Pin pin, SimTime t) {
  const Pin place = std::min(pin, spec_.pin_count);
  PinState& state = state_.pins[place];
  PinSource* const source = state.drive.mode == PinMode::output ? nullptr : wires_[place].source;
  double volts = 0.0, ohms = 0.0;
  if (source) {
    const Source seen = source->output(t, *supply_volts_);
    volts = seen.volts;
    ohms = seen.ohms;
  } else if (level_on(place, t)) {
    volts = *supply_volts_;
  }
  PinUse& use = state.use;
  use.lowest_volts = use.measured ? std::min(use.lowest_volts, volts) : volts;
  use.highest_volts = use.measured ? std::max(use.highest_volts, volts) : volts;
  use.measured = true;
  use.last_seen = t;
  if (input_watcher_) [[unlikely]]
    if (pin < spec_.pin_count) input_watcher_->volts_seen(pin, volts, t);
  return {volts, ohms};
}

void BoardState::send_byte(std::uint8_t byte, SimTime t) {
  for (SerialWatcher* watcher : serial_watchers_) watcher->byte_sent(byte, t);
}

bool BoardState::two_wire_address(std::uint8_t address, SimTime t) {
  two_wire_stop(t);
  for (const char* name : {spec_.chip->twi.data, spec_.chip->twi.clock})
    if (const Pin pin = find_pin(spec_, name); pin != kNoPin) state_.pins[pin].use.read = true;
  for (std::size_t i = 0; i < two_wire_.size() && state_.spoken_to == kNobody; ++i)
    if (two_wire_[i]->address(static_cast<std::uint8_t>(address >> 1), address & 1, t)) state_.spoken_to = i;
  return state_.spoken_to != kNobody;
}

bool BoardState::two_wire_write(std::uint8_t byte, SimTime t) {
  TwoWireDevice* const device = spoken_to();
  return device && device->write(byte, t);
}

std::uint8_t BoardState::two_wire_read(SimTime t) {
  TwoWireDevice* const device = spoken_to();
  return device ? device->read(t) : 0xFF;
}

void BoardState::two_wire_stop(SimTime t) {
  if (TwoWireDevice* const device = spoken_to()) device->stop(t);
  state_.spoken_to = kNobody;
}

void BoardState::write_eeprom(std::uint16_t address, std::uint8_t value, SimTime t) {
  if (address >= state_.eeprom.size()) return;
  const std::uint8_t before = state_.eeprom[address];
  state_.eeprom[address] = value;
  for (EepromWatcher* const watcher : eeprom_watchers_) watcher->eeprom_written(address, before, value, t);
}

void BoardState::connect(Pin pin, PinSource& source) {
  if (pin < spec_.pin_count) wires_[pin].source = &source;
}

void BoardState::watch(Pin pin, PinWatcher& watcher) {
  if (pin < spec_.pin_count) wires_[pin].watchers.push_back(&watcher);
}

void BoardState::schedule_edge(Pin pin, bool level, SimTime at) {
  if (pin >= spec_.pin_count) return;
  PinState& state = state_.pins[pin];
  if (state.wants_edges && level == state.last_level) return;
  state.last_level = level;
  const BoardInput edge{BoardInput::Kind::edge, pin, level, at};
  const auto later = [](SimTime time, const BoardInput& other) { return time < other.at; };
  state_.edges.insert(std::upper_bound(state_.edges.begin(), state_.edges.end(), at, later), edge);
  if (state.wants_edges) state_.next_input = std::min(state_.next_input, at);
}

void BoardState::receive_byte(std::uint8_t byte, SimTime at) {
  const auto later = [](SimTime time, const Byte& other) { return time < other.sent; };
  state_.bytes.insert(std::upper_bound(state_.bytes.begin(), state_.bytes.end(), at, later), Byte{byte, at});
  refresh_next();
}

void BoardState::reset(SimTime t) {
  for (Pin pin = 0; pin < spec_.pin_count; ++pin) {
    set_drive(pin, PinDrive{}, t);
    state_.pins[pin].wants_edges = false;
  }
  state_.wanted_pins = 0;
  state_.edges.clear();
  state_.bytes.clear();
  state_.byte_time = 0;
  state_.next_input = kNever;
  state_.spoken_to = kNobody;
}

bool BoardState::set_wants_edges(Pin pin, bool wanted, SimTime now) {
  if (pin >= spec_.pin_count || state_.pins[pin].wants_edges == wanted) return false;
  PinState& state = state_.pins[pin];
  state.wants_edges = wanted;
  state.use.awaited |= wanted;
  state_.wanted_pins += wanted ? 1 : -1;
  const bool level = wanted && read_level(pin, now, ReadIntent::port);
  if (wanted) {
    state.last_level = level;
    std::erase_if(state_.edges, [&](const BoardInput& edge) {
      if (edge.pin != pin) return false;
      const bool changes = edge.at > now && (edge.value != 0) != state.last_level;
      if (changes) state.last_level = edge.value != 0;
      return !changes;
    });
  }
  refresh_next();
  return level;
}

void BoardState::listen(SimTime byte_time, SimTime now) {
  if (state_.byte_time == 0) std::erase_if(state_.bytes, [now](const Byte& byte) { return byte.sent < now; });
  state_.byte_time = byte_time;
  refresh_next();
}

const BoardState::Byte* BoardState::next_byte() const {
  return state_.byte_time > 0 && !state_.bytes.empty() ? &state_.bytes.front() : nullptr;
}

SimTime BoardState::arrival(const Byte& byte) const {
  return std::max(byte.sent, state_.last_arrival) + state_.byte_time;
}

std::size_t BoardState::next_edge() const {
  std::size_t i = 0;
  while (i < state_.edges.size() && !state_.pins[state_.edges[i].pin].wants_edges) ++i;
  return i;
}

void BoardState::refresh_next() {
  const std::size_t edge = next_edge();
  state_.next_input = edge < state_.edges.size() ? state_.edges[edge].at : kNever;
  if (const Byte* byte = next_byte()) state_.next_input = std::min(state_.next_input, arrival(*byte));
}

bool BoardState::take_input(SimTime until, BoardInput& input) {
  if (state_.next_input > until) return false;
  const std::size_t edge = next_edge();
  if (edge < state_.edges.size() && state_.edges[edge].at == state_.next_input) {
    input = state_.edges[edge];
    state_.edges.erase(state_.edges.begin() + static_cast<std::ptrdiff_t>(edge));
    if (input_watcher_) input_watcher_->level_seen(input.pin, input.value != 0, input.at);
  } else {
    state_.last_arrival = state_.next_input;
    input = {BoardInput::Kind::byte, kNoPin, state_.bytes.front().value, state_.next_input};
    state_.bytes.erase(state_.bytes.begin());
    if (input_watcher_) input_watcher_->byte_received(input.value, input.at);
  }
  refresh_next();
  return true;
}

void BoardState::forget_all_edges(SimTime t) {
  std::erase_if(state_.edges,
                [&](const BoardInput& edge) { return edge.at < t && !state_.pins[edge.pin].wants_edges; });
}

}  // namespace robosim::exec
