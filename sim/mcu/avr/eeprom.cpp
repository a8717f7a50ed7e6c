#include "sim/mcu/avr/eeprom.h"

namespace robosim::avr {
namespace {

constexpr std::uint8_t kEepmMask = 0x30, kEerie = 0x08, kEempe = 0x04, kEepe = 0x02, kEere = 0x01;
constexpr std::uint8_t kEraseAndWrite = 0x00, kEraseOnly = 0x10, kWriteOnly = 0x20;
constexpr std::uint8_t kWholeByte = 0xFF, kErasedByte = 0xFF;
constexpr Cycle kEempeWindow = 4, kReadHalts = 4, kWriteHalts = 2;
constexpr std::int64_t kEraseOrWrite_ns = 1'800'000;

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
  state_.unlocked_until = 0;
  if (!state_.writing) return;
  core_.at(control_) = state_.mode;
  core_.schedule(done_, state_.done_at);
}

std::uint16_t Eeprom::address() const {
  return static_cast<std::uint16_t>(core_.cpu.pair(address_register()) & (core_.chip.eeprom_bytes - 1));
}

std::uint64_t Eeprom::may_interrupt() const {
  return Interrupts::bit(core_.chip.eeprom_vector, core_.cpu.data[control_] & kEerie);
}

void Eeprom::request() {
  core_.request(core_.chip.eeprom_vector, core_.at(control_) & kEerie && !state_.writing);
}

std::uint8_t Eeprom::read_control(Address at) {
  const bool unlocked = core_.now() <= state_.unlocked_until;
  return static_cast<std::uint8_t>(core_.at(at) | (unlocked ? kEempe : 0) | (state_.writing ? kEepe : 0));
}

ReadForecast Eeprom::forecast_of_control(Address at, std::uint8_t) {
  if (core_.now() <= state_.unlocked_until) return {};
  return {kNoCycle, read_control(at)};
}

void Eeprom::write_control(Address, std::uint8_t value) { control(value, kWholeByte); }
void Eeprom::write_control_bit(Address, std::uint8_t value, std::uint8_t bit) { control(value, bit); }

void Eeprom::control(std::uint8_t value, std::uint8_t written) {
  const Cycle now = core_.now();
  const bool unlocked = now <= state_.unlocked_until;
  std::uint8_t& kept = core_.at(control_);
  const std::uint8_t mode = (state_.writing ? kept : value) & kEepmMask;
  kept = static_cast<std::uint8_t>((value & kEerie) | mode);
  if (written & kEempe) state_.unlocked_until = value & kEempe ? now + kEempeWindow : 0;
  if (!state_.writing && value & written & kEere) {
    core_.at(data_register()) = core_.environment.eeprom()[address()];
    core_.cpu.skip_to(now + kReadHalts);
  }
  if (!state_.writing && value & written & kEepe && unlocked) begin();
  request();
}

void Eeprom::begin() {
  const Cycle now = core_.now();
  const std::uint8_t old = core_.environment.eeprom()[address()], data = core_.at(data_register());
  std::uint8_t value = data;
  std::int64_t takes_ns = kEraseOrWrite_ns;
  state_.mode = core_.at(control_) & kEepmMask;
  switch (state_.mode) {
    case kEraseAndWrite:
      takes_ns = kEepromWriteTime;
      break;
    case kEraseOnly:
      value = kErasedByte;
      break;
    case kWriteOnly:
      value = old & data;
      break;
    default:
      return;
  }
  state_.writing = true;
  state_.done_at = now + core_.cycles(takes_ns);
  core_.environment.write_eeprom(address(), value, now);
  core_.schedule(done_, state_.done_at);
  core_.cpu.skip_to(now + kWriteHalts);
}

void Eeprom::done(Cycle) {
  state_.writing = false;
  request();
}

void Eeprom::write_address(Address at, std::uint8_t value) {
  if (state_.writing) return;
  const int high = (core_.chip.eeprom_bytes - 1) >> 8;
  core_.at(at) = at == address_register() ? value : static_cast<std::uint8_t>(value & high);
}

void Eeprom::clock_changed(std::int64_t hz_before) {
  if (!state_.writing) return;
  state_.done_at = core_.rescaled(state_.done_at, hz_before);
  core_.schedule(done_, state_.done_at);
}

}  // namespace robosim::avr
