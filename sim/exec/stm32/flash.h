// Models the flash interface (RM0008 3.3.3; PM0075), by which a program can write any halfword and erase any
// page of flash, even its own code. As on the chip, the processor stops while flash is busy, since its
// instructions come from flash. A write takes 52.5 us, and an erase takes 30 ms (DS5319, table 28: 20 to 40
// ms).
#pragma once

#include <optional>
#include <utility>

#include "sim/exec/stm32/memory.h"
#include "sim/exec/stm32/peripheral.h"

namespace robosim::exec::stm32 {

class Flash final : public Peripheral {
 public:
  Flash(Link& link, FlashMemory& memory) : link_(link), memory_(memory) { link.snapshots.add(state_); }

  std::uint32_t read(Address address) override;
  bool write(Address address, std::uint32_t value) override;
  void reset(Address block) override;
  Cycle same_until(Address) const override { return kNoCycle; }

  static bool owns_memory(Address address) {
    return address - robosim::stm32::kFlash < robosim::stm32::kFlashBytes;
  }
  /// Reads flash at `address`. Bytes after the end of flash read as 0xFF.
  std::uint32_t read_memory(Address address, unsigned size) const;
  /// Returns whether a store programs flash. Only a halfword store programs flash, and only while FLASH_CR
  /// allows programming.
  bool programs(Address address, unsigned size) const;
  void program(Address address, std::uint32_t value);
  /// Returns the address of the page that has changed since the last call; nullopt if no page has changed.
  std::optional<Address> take_changed() { return std::exchange(changed_, std::nullopt); }
  const FlashMemory& memory() const { return memory_; }

 private:
  struct State {
    std::uint32_t access = 0x30, control = robosim::stm32::kFlashLock, status = 0, address = 0;
    bool first_key = false;
  };

  void erase();

  Link& link_;
  FlashMemory& memory_;
  std::optional<Address> changed_;
  State state_;
};

}  // namespace robosim::exec::stm32
