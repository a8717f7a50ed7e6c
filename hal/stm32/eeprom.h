// An EEPROM of 1024 bytes in the last four pages of flash (PM0075 2: a page of 1 KB is erased at once, halves
// of words are programmed one by one).
//
// Two banks of two pages take turns. A bank:
//
//   0x000  0x5AA5 once it is complete; its number, one more than that of the bank before
//   0x004  1024 bytes: the EEPROM as it was when the bank was made
//   0x404  up to 255 changes since: the byte's value | 0xA500, its address
//
// The bank with the higher number holds. A change that power-off interrupts counts only if both halves are
// there; a bank without its mark does not count at all.
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
