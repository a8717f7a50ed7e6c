#include "hal/host/other_registers.h"

#include "hal/board/avr_registers.h"
#include "hal/host/clock.h"
#include "hal/host/comparator.h"
#include "hal/host/eeprom.h"
#include "hal/host/ports.h"

namespace robosim {
namespace host {
namespace {

using namespace avr::reg;

uint8_t plain[256];

}  // namespace

uint8_t sleep_control() { return plain[kSmcr]; }

uint8_t read_other(uint8_t address) {
  switch (address) {
    case kEecr:
      return eeprom.control();
    case kEedr:
      return eeprom.data();
    case kEearL:
      return static_cast<uint8_t>(eeprom.address());
    case kEearH:
      return static_cast<uint8_t>(eeprom.address() >> 8);
    case kChip.comparator.address:
      return comparator.control();
  }
  return plain[address];
}

void write_other(uint8_t address, uint8_t value) {
  switch (address) {
    case kEecr:
      return eeprom.set_control(value);
    case kEedr:
      return eeprom.set_data(value);
    case kEearL:
      return eeprom.set_address(static_cast<uint16_t>((eeprom.address() & 0xFF00) | value));
    case kEearH:
      return eeprom.set_address(static_cast<uint16_t>((eeprom.address() & 0xFF) | value << 8));
    case kChip.comparator.address:
      return comparator.set_control(value);
  }
  plain[address] = value;
  if (address == kDidr0 || address == kDidr1)
    inputs_off = static_cast<uint16_t>(plain[kDidr0] | plain[kDidr1] << 8);
}

}  // namespace host
}  // namespace robosim
