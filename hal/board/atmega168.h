// Describes the ATmega168 of older Nanos: an ATmega328P with less memory. Source: data sheet 2545W; numbers
// in comments are its sections.
#pragma once

#include "hal/board/atmega328p.h"

namespace robosim {
namespace atmega168 {

constexpr ChipSpec chip() {
  ChipSpec chip = kAtmega328p;
  chip.name = "ATmega168";
  chip.compiler_name = "atmega168";
  chip.macro = "__AVR_ATmega168__";
  chip.registers = "iom168.h";
  chip.avrdude_name = "atmega168";
  chip.signature[1] = 0x94;  // 28.3
  chip.signature[2] = 0x06;
  chip.flash_bytes = 0x4000;  // 8.2 to 8.4
  chip.ram_bytes = 0x400;
  chip.eeprom_bytes = 0x200;
  return chip;
}

}  // namespace atmega168

constexpr ChipSpec kAtmega168 = atmega168::chip();

}  // namespace robosim
