// Byte access to the EEPROM (datasheet, chapter 8.4): a write goes on by itself for kEepromWriteTime, and
// whatever comes next waits for it.
#include "hal/board/board_spec.h"
#include "hal/host/api.h"
#include "hal/host/registers.h"

namespace host = robosim::host;

namespace {

robosim::SimTime ready;

uint16_t place_of(uint16_t address) { return address % host::board->spec().eeprom_bytes; }

}  // namespace

extern "C" {

uint8_t robosim_eeprom_read(uint16_t address) {
  host::note_call("EEPROM.read", robosim::kNoPin, 1, address);
  host::wait_until(ready);
  host::spend(host::cost::kEepromAccess);
  return host::board->eeprom()[place_of(address)];
}

void robosim_eeprom_write(uint16_t address, uint8_t value) {
  host::note_call("EEPROM.write", robosim::kNoPin, 2, address, value);
  host::wait_until(ready);
  host::spend(host::cost::kEepromAccess);
  host::board->write_eeprom(place_of(address), value, host::state.now);
  ready = host::state.now + robosim::kEepromWriteTime;
}

}  // extern "C"
