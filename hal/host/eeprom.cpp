#include "hal/host/eeprom.h"

#include "hal/board/board_spec.h"
#include "hal/host/api.h"
#include "hal/host/interrupts.h"
#include "hal/host/registers.h"

namespace robosim {
namespace host {

Eeprom eeprom;

namespace {

constexpr int kWindowCycles = 64;

uint16_t place_of(uint16_t address) { return address % board->spec().eeprom_bytes; }

}  // namespace

uint8_t Eeprom::read(uint16_t address) const { return board->read_eeprom(place_of(address)); }

void Eeprom::write(uint16_t address, uint8_t value, SimTime takes) {
  board->write_eeprom(place_of(address), value, state.now);
  eeprom_.ready = state.now + takes;
}

void Eeprom::set_address(uint16_t value) {
  if (!eeprom_.is_writing(state.now)) address_ = place_of(value);
}

void Eeprom::set_control(uint8_t value) {
  if (value & kEerie) rare_used = true;
  const int starts = eeprom_.write(control_, value, 0xFF, state.now, cycles(kWindowCycles));
  if (starts & kEere) data_ = read(address_);
  if (!(starts & kEepe)) return;
  const avr::EepromWrite begun = avr::eeprom_write(control_, read(address_), data_);
  if (begun.takes) write(address_, begun.value, begun.takes);
}

}  // namespace host
}  // namespace robosim

namespace host = robosim::host;

extern "C" {

uint8_t robosim_eeprom_read(uint16_t address) {
  host::note_call("EEPROM.read", robosim::kNoPin, 1, address);
  host::wait_until(host::eeprom.ready());
  host::spend(host::cost::kEepromAccess);
  return host::eeprom.read(address);
}

void robosim_eeprom_write(uint16_t address, uint8_t value) {
  host::note_call("EEPROM.write", robosim::kNoPin, 2, address, value);
  host::wait_until(host::eeprom.ready());
  host::spend(host::cost::kEepromAccess);
  host::eeprom.write(address, value, robosim::kEepromWriteTime);
}

}  // extern "C"
