// The flash interface (RM0008 3.3.3; PM0075), and the pages that a program may change: those of the emulated
// EEPROM. The processor stands still while flash is busy, as it does on the chip, where it would fetch from
// it: 52.5 us for half a word, 30 ms for a page (DS5319, table 28: 20 to 40 ms).
#pragma once

#include <vector>

#include "sim/exec/stm32/link.h"

namespace robosim::exec::stm32 {

/// Content of the EEPROM's pages; outlives the power.
using EepromPages = std::vector<std::uint8_t>;

class Flash {
 public:
  Flash(Link& link, EepromPages& pages) : link_(link), pages_(pages) {}

  static bool owns(Address address) {
    return address >= robosim::stm32::kFlashIf && address <= robosim::stm32::kFlashIf + 0x20;
  }
  std::uint32_t read(Address address) const;
  bool write(Address address, std::uint32_t value);

  static bool owns_page(Address address) {
    return address >= robosim::stm32::kEepromFlash &&
           address < robosim::stm32::kFlash + robosim::stm32::kFlashBytes;
  }
  std::uint32_t read_page(Address address, unsigned size) const;
  /// False where the chip would refuse: flash is locked, or more or less than half a word is written.
  bool program(Address address, std::uint32_t value, unsigned size);

 private:
  void erase();

  Link& link_;
  EepromPages& pages_;
  std::uint32_t access_ = 0x30, control_ = robosim::stm32::kFlashLock, status_ = 0, address_ = 0;
  bool first_key_ = false;
};

}  // namespace robosim::exec::stm32
