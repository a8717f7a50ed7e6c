#include "hal/stm32/eeprom.h"

#include <avr/io.h>

#include "hal/stm32/registers.h"

using namespace robosim::stm32;

namespace {

constexpr Address kBanks[2] = {kEepromFlash, kEepromFlash + kBankBytes};

bool complete(Address bank) { return load_half(bank) == kBankMark; }

/// Returns the valid bank, or 0 before the first write.
Address current_bank() {
  const bool first = complete(kBanks[0]), second = complete(kBanks[1]);
  if (first && second)  // the bank numbers wrap around, so the difference is compared modulo 65536
    return kBanks[static_cast<uint16_t>(load_half(kBanks[1] + 2) - load_half(kBanks[0] + 2)) < 0x8000];
  return first ? kBanks[0] : second ? kBanks[1] : 0;
}

Address change(Address bank, uint32_t number) { return bank + kChangesAt + 4 * number; }

/// Returns the number of used entries for changes in a bank. The first half word of a used entry is not
/// 0xFFFF.
uint32_t changes_in(Address bank) {
  uint32_t low = 0, high = kChanges;
  while (low < high) {
    const uint32_t middle = (low + high) / 2;
    if (load_half(change(bank, middle)) != 0xFFFF)
      low = middle + 1;
    else
      high = middle;
  }
  return low;
}

uint8_t read(Address bank, uint16_t address, uint32_t changes) {
  if (!bank) return 0xFF;
  while (changes > 0) {
    --changes;
    const uint16_t value = load_half(change(bank, changes));
    if ((value & 0xFF00) == kChangeMark && load_half(change(bank, changes) + 2) == address)
      return static_cast<uint8_t>(value);
  }
  const uint16_t half = load_half(bank + 4 + (address & ~1u));
  return static_cast<uint8_t>(address & 1 ? half >> 8 : half);
}

void await_flash() { at(kFlashSr).await(kFlashBusy, 0); }

/// Keeps flash unlocked for writing while the object exists (PM0075 2.3.2).
class Unlocked {
 public:
  Unlocked() {
    if (!(load(kFlashCr) & kFlashLock)) return;
    at(kFlashKeyr) = kFlashKey1;
    at(kFlashKeyr) = kFlashKey2;
  }
  ~Unlocked() { at(kFlashCr) = kFlashLock; }
};

// Programs a half word of flash (PM0075 2.3.3).
void program(Address address, uint16_t value) {
  at(kFlashCr) = kFlashPg;
  store_half(address, value);
  await_flash();
  at(kFlashCr) = 0;
}

// Erases a page of flash (PM0075 2.3.4).
void erase_page(Address page) {
  at(kFlashCr) = kFlashPer;
  at(kFlashAr) = page;
  at(kFlashCr) = kFlashPer | kFlashStart;
  await_flash();
  at(kFlashCr) = 0;
}

/// Copies the bank `from`, with its changes applied, to the other bank. Returns the other bank.
Address renew(Address from, uint32_t changes) {
  const Address to = from == kBanks[0] ? kBanks[1] : kBanks[0];
  erase_page(to);
  erase_page(to + kPageBytes);
  for (uint16_t i = 0; i < kEepromBytes; i = static_cast<uint16_t>(i + 2)) {
    const auto half = static_cast<uint16_t>(read(from, i, changes) |
                                            read(from, static_cast<uint16_t>(i + 1), changes) << 8);
    if (half != 0xFFFF) program(to + 4 + i, half);
  }
  program(to + 2, from ? static_cast<uint16_t>(load_half(from + 2) + 1) : 0);
  program(to, kBankMark);
  return to;
}

}  // namespace

extern "C" {

uint8_t robosim_eeprom_read(uint16_t address) {
  const Address bank = current_bank();
  return read(bank, address % kEepromBytes, bank ? changes_in(bank) : 0);
}

void robosim_eeprom_write(uint16_t address, uint8_t value) {
  address %= kEepromBytes;
  const Unlocked unlocked;
  Address bank = current_bank();
  uint32_t changes = bank ? changes_in(bank) : 0;
  if (!bank || changes == kChanges) {
    bank = renew(bank, changes);
    changes = 0;
  }
  // Writes the address last, because the address makes the change valid.
  program(change(bank, changes), static_cast<uint16_t>(kChangeMark | value));
  program(change(bank, changes) + 2, address);
}

}  // extern "C"
