// Stores the chip's flash and RAM (RM0008 3.3), which the processor and DMA access.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <vector>

#include "hal/stm32/addresses.h"

namespace robosim::exec::stm32 {

using robosim::stm32::Address;

/// Memory that begins at a multiple of 4096, as libunicorn requires.
class AlignedBytes {
 public:
  /// `size` must be a multiple of 4096. Throws std::bad_alloc if the allocation fails.
  AlignedBytes(std::size_t size, std::uint8_t fill);
  std::uint8_t* data() const { return bytes_.get(); }

 private:
  std::unique_ptr<std::uint8_t[], void (*)(void*)> bytes_;
};

/// The content of flash, which survives power-off.
class FlashMemory : public AlignedBytes {
 public:
  /// Copies `program` and fills the rest of flash with 0xFF.
  explicit FlashMemory(const std::vector<std::uint8_t>& program = {});

  // --- offsets count from the start of flash
  void program(Address offset, std::uint16_t half);
  /// Erases the page that contains `offset`.
  void erase(Address offset);

  using Page = std::array<std::uint8_t, robosim::stm32::kPageBytes>;
  /// The pages that firmware has changed, by their offsets. Copies of a State share their pages.
  using State = std::map<Address, std::shared_ptr<const Page>>;
  State save() const;
  /// Restores `saved` and returns the offsets of the pages that changed.
  std::vector<Address> restore(const State& saved);

 private:
  const std::vector<std::uint8_t> program_;
  mutable State state_;                ///< result of the last save(), or argument of the last restore()
  mutable std::set<Address> unsaved_;  ///< offsets of pages that have changed since the last save()
};

/// Returns the data that the manufacturer has stored in the chip (RM0008 30, PM0075 2.5). These are the flash
/// size, the unique number, and the factory option bytes. All simulated chips have the same unique number.
/// Returns null for other addresses.
const std::uint8_t* chip_facts(Address address, unsigned bytes);

/// The content of RAM.
class RamMemory : public AlignedBytes {
 public:
  RamMemory() : AlignedBytes(robosim::stm32::kRamBytes, 0) {}
  /// Returns a pointer to `bytes` bytes of RAM at `address`; null if these are not in RAM.
  std::uint8_t* at(Address address, unsigned bytes) const {
    using namespace robosim::stm32;
    return address - kRam <= kRamBytes - bytes ? data() + (address - kRam) : nullptr;
  }
};

}  // namespace robosim::exec::stm32
