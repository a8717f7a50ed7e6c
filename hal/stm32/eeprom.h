// Emulates an EEPROM of 1024 bytes in the last four pages of flash. Flash is erased in pages of 1 KB, and
// programmed in half words (PM0075 2).
//
// The emulation alternates between two banks of two pages each. Layout of a bank:
//
//   0x000  two half words: 0x5AA5 once the bank is complete, and the bank's number (the previous one + 1)
//   0x004  1024 bytes: the EEPROM's content when the bank was written
//   0x404  up to 255 later changes, two half words each: the byte's value | 0xA500, and the byte's address
//
// The bank with the higher number is valid. A change counts only if both half words are present, so a
// power-off during a change does no harm. A bank without 0x5AA5 is ignored.
#pragma once

#include <stdint.h>

#include "hal/stm32/addresses.h"

namespace robosim {
namespace stm32 {

constexpr uint16_t kEepromBytes = 1024;
constexpr uint32_t kBankBytes = 2 * kPageBytes;
constexpr uint16_t kBankMark = 0x5AA5, kChangeMark = 0xA500;
constexpr uint32_t kChangesAt = 4 + kEepromBytes, kChanges = (kBankBytes - kChangesAt) / 4;

}  // namespace stm32
}  // namespace robosim
