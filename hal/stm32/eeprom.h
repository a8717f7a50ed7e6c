// An EEPROM of 1024 bytes in the last four pages of flash (PM0075 2: a page of 1 KB is erased at once, half
// words are programmed one at a time).
//
// Two banks of two pages alternate. A bank:
//
//   0x000  0x5AA5 once the bank is complete; its number, one more than the previous bank's
//   0x004  1024 bytes: the EEPROM's content when the bank was made
//   0x404  up to 255 later changes: the byte's value | 0xA500, its address
//
// The bank with the higher number is valid. A change counts only if both halves are present, so a power-off
// during a change does no harm. A bank without its mark is ignored.
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
