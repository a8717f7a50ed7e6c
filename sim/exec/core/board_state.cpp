#include "sim/exec/core/board_state.h"

#include <algorithm>

namespace robosim::exec {

BoardState::BoardState(const BoardSpec& spec)
    : spec_(spec), pins_(spec.pin_count + 1u), eeprom_(spec.eeprom_bytes, 0xFF) {}

void BoardState::set_drive(Pin pin, const PinDrive& drive, SimTime t) {
  if (pin >= spec_.pin_count) return;
  PinState& state = pins_[pin];
  if (state.drive == drive) return;
  state.drive = drive;
  if (state.wants_edges && drive.mode == PinMode::output) state.last_level = level_on(pin, t);
  for (PinWatcher* watcher : state.watchers) watcher->pin_changed(pin, drive, t);
}

bool BoardState::level_on(Pin pin, SimTime t) {
  const PinState& state = pins_[pin];
  if (state.drive.mode == PinMode::output)
    return state.drive.pwm ? state.drive.duty >= 0.5 : state.drive.level;
  if (state.source) return state.source->level(t);
  return state.drive.mode == PinMode::input_pullup;
}

bool BoardState::read_level(Pin pin, SimTime t) {
  if (pin >= spec_.pin_count) return false;
  const bool level = level_on(pin, t);
  if (input_watcher_) input_watcher_->level_seen(pin, level, t);
  return level;
}

SimTime BoardState::same_until(Pin pin, SimTime t) const {
  if (input_watcher_) return t;
  const PinState& state = state_of(pin);
  return state.drive.mode == PinMode::output || !state.source ? kNever : state.source->same_until(t);
}

double BoardState::read_volts(Pin pin, SimTime t) {
  if (pin >= spec_.pin_count) return 0.0;
  const PinState& state = pins_[pin];
  const bool sourced = state.drive.mode != PinMode::output && state.source;
  const double volts = sourced ? state.source->volts(t) : level_on(pin, t) ? spec_.supply_volts : 0.0;
  if (input_watcher_) input_watcher_->volts_seen(pin, volts, t);
  return volts;
}

void BoardState::send_byte(std::uint8_t byte, SimTime t) {
  for (SerialWatcher* watcher : serial_watchers_) watcher->byte_sent(byte, t);
}

void BoardState::write_eeprom(std::uint16_t address, std::uint8_t value, SimTime t) {
  if (address >= eeprom_.size()) return;
  const std::uint8_t before = eeprom_[address];
  eeprom_[address] = value;
  if (eeprom_watcher_) eeprom_watcher_->eeprom_written(address, before, value, t);
}

void BoardState::connect(Pin pin, PinSource& source) {
  if (pin < spec_.pin_count) pins_[pin].source = &source;
}

void BoardState::watch(Pin pin, PinWatcher& watcher) {
  if (pin < spec_.pin_count) pins_[pin].watchers.push_back(&watcher);
}

void BoardState::schedule_edge(Pin pin, bool level, SimTime at) {
  if (pin >= spec_.pin_count) return;
  PinState& state = pins_[pin];
  if (state.wants_edges && level == state.last_level) return;
  state.last_level = level;
  const BoardInput edge{BoardInput::Kind::edge, pin, level, at};
  const auto later = [](SimTime time, const BoardInput& other) { return time < other.at; };
  edges_.insert(std::upper_bound(edges_.begin(), edges_.end(), at, later), edge);
  if (state.wants_edges) next_input_ = std::min(next_input_, at);
}

void BoardState::receive_byte(std::uint8_t byte, SimTime at) {
  const auto later = [](SimTime time, const Byte& other) { return time < other.sent; };
  bytes_.insert(std::upper_bound(bytes_.begin(), bytes_.end(), at, later), Byte{byte, at});
  refresh_next();
}

void BoardState::reset(SimTime t) {
  for (Pin pin = 0; pin < spec_.pin_count; ++pin) {
    set_drive(pin, PinDrive{}, t);
    pins_[pin].wants_edges = false;
  }
  wanted_pins_ = 0;
  edges_.clear();
  bytes_.clear();
  byte_time_ = 0;
  next_input_ = kNever;
}

bool BoardState::set_wants_edges(Pin pin, bool wanted, SimTime now) {
  if (pin >= spec_.pin_count || pins_[pin].wants_edges == wanted) return false;
  PinState& state = pins_[pin];
  state.wants_edges = wanted;
  wanted_pins_ += wanted ? 1 : -1;
  const bool level = wanted && read_level(pin, now);
  if (wanted) {
    state.last_level = level;
    std::erase_if(edges_, [&](const BoardInput& edge) {
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
  if (byte_time_ == 0) std::erase_if(bytes_, [now](const Byte& byte) { return byte.sent < now; });
  byte_time_ = byte_time;
  refresh_next();
}

const BoardState::Byte* BoardState::next_byte() const {
  return byte_time_ > 0 && !bytes_.empty() ? &bytes_.front() : nullptr;
}

SimTime BoardState::arrival(const Byte& byte) const {
  return std::max(byte.sent, last_arrival_) + byte_time_;
}

std::size_t BoardState::next_edge() const {
  std::size_t i = 0;
  while (i < edges_.size() && !pins_[edges_[i].pin].wants_edges) ++i;
  return i;
}

void BoardState::refresh_next() {
  const std::size_t edge = next_edge();
  next_input_ = edge < edges_.size() ? edges_[edge].at : kNever;
  if (const Byte* byte = next_byte()) next_input_ = std::min(next_input_, arrival(*byte));
}

bool BoardState::take_input(SimTime until, BoardInput& input) {
  if (next_input_ > until) return false;
  const std::size_t edge = next_edge();
  if (edge < edges_.size() && edges_[edge].at == next_input_) {
    input = edges_[edge];
    edges_.erase(edges_.begin() + static_cast<std::ptrdiff_t>(edge));
    if (input_watcher_) input_watcher_->level_seen(input.pin, input.value != 0, input.at);
  } else {
    last_arrival_ = next_input_;
    input = {BoardInput::Kind::byte, kNoPin, bytes_.front().value, next_input_};
    bytes_.erase(bytes_.begin());
    if (input_watcher_) input_watcher_->byte_received(input.value, input.at);
  }
  refresh_next();
  return true;
}

void BoardState::forget_edges(SimTime t) {
  if (edges_.empty()) return;
  std::erase_if(edges_, [&](const BoardInput& edge) { return edge.at < t && !pins_[edge.pin].wants_edges; });
}

}  // namespace robosim::exec
