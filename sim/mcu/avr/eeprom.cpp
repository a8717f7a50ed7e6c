#include "sim/mcu/avr/eeprom.h"

namespace robosim::avr {
namespace {

constexpr std::uint8_t kWholeByte = 0xFF;
constexpr Cycle kEempeWindow = 4, kReadHalts = 4, kWriteHalts = 2;

}  // namespace

Eeprom::Eeprom(Core& core) : core_(core), control_(core.chip.at.eeprom) {
  core.cpu.on_read<&Eeprom::read_control>(control_, this);
  core.cpu.on_forecast<&Eeprom::forecast_of_control>(control_, this);
  core.cpu.on_write<&Eeprom::write_control>(control_, this);
  core.cpu.on_write_bit<&Eeprom::write_control_bit>(control_, this);
  core.cpu.on_write<&Eeprom::write_address>(address_register(), this);
  core.cpu.on_write<&Eeprom::write_address>(static_cast<Address>(address_register() + 1), this);
  core.on_clock_change<&Eeprom::clock_changed>(this);
  done_ = core.events.add<&Eeprom::done>(this);
  core.keep(state_);
}

void Eeprom::reset(Cycle) {
  state_.control.unlocked_until = 0;
  if (!is_writing()) return;
  core_.at(control_) = state_.mode;
  core_.schedule(done_, state_.control.ready);
}

std::uint16_t Eeprom::address() const {
  return static_cast<std::uint16_t>(core_.cpu.pair(address_register()) & (core_.chip.eeprom_bytes - 1));
}

std::uint64_t Eeprom::may_interrupt() const {
  return Interrupts::bit(core_.chip.eeprom_vector, core_.cpu.data[control_] & kEerie);
}

void Eeprom::request() {
  core_.request(core_.chip.eeprom_vector, state_.control.is_requested(core_.at(control_), core_.now()));
}

std::uint8_t Eeprom::read_control(Address at) { return state_.control.read(core_.at(at), core_.now()); }

ReadForecast Eeprom::forecast_of_control(Address at, std::uint8_t) {
  if (core_.now() <= state_.control.unlocked_until) return {};
  return {kNoCycle, read_control(at)};
}

void Eeprom::write_control(Address, std::uint8_t value) { control(value, kWholeByte); }
void Eeprom::write_control_bit(Address, std::uint8_t value, std::uint8_t bit) { control(value, bit); }

void Eeprom::control(std::uint8_t value, std::uint8_t written) {
  const Cycle now = core_.now();
  const int starts = state_.control.write(core_.at(control_), value, written, now, kEempeWindow);
  if (starts & kEere) {
    core_.at(data_register()) = core_.environment.read_eeprom(address());
    core_.cpu.skip_to(now + kReadHalts);
  }
  if (starts & kEepe) begin();
  request();
}

void Eeprom::begin() {
  const Cycle now = core_.now();
  const std::uint8_t old = core_.environment.read_eeprom(address());
  const EepromWrite write = eeprom_write(core_.at(control_), old, core_.at(data_register()));
  if (write.takes == 0) return;
  state_.mode = core_.at(control_) & kEepm;
  state_.control.ready = now + core_.cycles(write.takes);
  core_.environment.write_eeprom(address(), write.value, now);
  core_.schedule(done_, state_.control.ready);
  core_.cpu.skip_to(now + kWriteHalts);
}

void Eeprom::done(Cycle) { request(); }

void Eeprom::write_address(Address at, std::uint8_t value) {
  if (is_writing()) return;
  const int high = (core_.chip.eeprom_bytes - 1) >> 8;
  core_.at(at) = at == address_register() ? value : static_cast<std::uint8_t>(value & high);
}

void Eeprom::clock_changed(std::int64_t hz_before) {
  if (!is_writing()) return;
  state_.control.ready = core_.rescaled(state_.control.ready, hz_before);
  core_.schedule(done_, state_.control.ready);
}

}  // namespace robosim::avr
