#include "hal/host/eeprom.h"

#include "hal/board/board_spec.h"
#include "hal/host/api.h"
#include "hal/host/interrupts.h"
#include "hal/host/registers.h"

namespace robosim {
namespace host {

Eeprom eeprom;

namespace {

constexpr uint8_t kEepm = 0x30, kEempe = 0x04, kEepe = 0x02, kEere = 0x01;
constexpr uint8_t kEraseAndWrite = 0x00, kEraseOnly = 0x10, kWriteOnly = 0x20;
constexpr SimTime kEraseOrWrite = 1800 * kMicrosecond;
constexpr int kWindowCycles = 64;

uint16_t place_of(uint16_t address) { return address % board->spec().eeprom_bytes; }

}  // namespace

uint8_t Eeprom::read(uint16_t address) const { return board->eeprom()[place_of(address)]; }

void Eeprom::write(uint16_t address, uint8_t value, SimTime takes) {
  board->write_eeprom(place_of(address), value, state.now);
  ready_ = state.now + takes;
}

uint8_t Eeprom::control() const {
  return static_cast<uint8_t>(control_ | (state.now <= unlocked_until_ ? kEempe : 0) |
                              (state.now < ready_ ? kEepe : 0));
}

void Eeprom::set_address(uint16_t value) {
  if (state.now >= ready_) address_ = place_of(value);
}

void Eeprom::set_control(uint8_t value) {
  const bool unlocked = state.now <= unlocked_until_, writing = state.now < ready_;
  const uint8_t mode = (writing ? control_ : value) & kEepm;
  control_ = static_cast<uint8_t>((value & kEerie) | mode);
  if (value & kEerie) rare_used = true;
  unlocked_until_ = value & kEempe ? state.now + cycles(kWindowCycles) : -1;
  if (writing) return;
  if (value & kEere) data_ = read(address_);
  if (!(value & kEepe) || !unlocked) return;
  if (mode == kEraseAndWrite) write(address_, data_, kEepromWriteTime);
  if (mode == kEraseOnly) write(address_, 0xFF, kEraseOrWrite);
  if (mode == kWriteOnly) write(address_, read(address_) & data_, kEraseOrWrite);
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
