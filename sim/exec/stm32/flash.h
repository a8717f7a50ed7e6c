// The flash interface (RM0008 3.3.3; PM0075), by which a program may change any half of a word or page of
// flash, its own code too. The processor stands still while flash is busy, as it does on the chip, where it
// would fetch from it: 52.5 us for half a word, 30 ms for a page (DS5319, table 28: 20 to 40 ms).
#pragma once

#include <optional>
#include <utility>

#include "sim/exec/stm32/memory.h"
#include "sim/exec/stm32/peripheral.h"

namespace robosim::exec::stm32 {

class Flash final : public Peripheral {
 public:
  Flash(Link& link, FlashMemory& memory) : link_(link), memory_(memory) { link.kept.add(state_); }

  std::uint32_t read(Address address) override;
  bool write(Address address, std::uint32_t value) override;
  void reset(Address block) override;
  Cycle same_until(Address) const override { return kNoCycle; }

  static bool owns_memory(Address address) {
    return address - robosim::stm32::kFlash < robosim::stm32::kFlashBytes;
  }
  /// `address` is in flash; 0xFF behind its end.
  std::uint32_t read_memory(Address address, unsigned size) const;
  /// Whether a store to flash programs it: nothing but half a word does, and that only while FLASH_CR allows.
  bool programs(Address address, unsigned size) const;
  void program(Address address, std::uint32_t value);
  /// The page that has changed since the last call; nothing if none has.
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
