// Loads and stores of the processor; RAM's come first, for speed.
#pragma once

#include <cstring>

#include "sim/exec/stm32/cpu.h"

namespace robosim::exec::stm32 {

template <unsigned kBytes>
[[gnu::noinline]] bool Cpu::load_elsewhere(Address address, std::uint32_t& value) {
  if (const std::uint8_t* const from = memory(address, kBytes)) {
    value = 0;
    std::memcpy(&value, from, kBytes);
    return true;
  }
  if (address % kBytes != 0 || !has_registers(address)) return false;
  value = bus_.load(address, kBytes);
  accessed();
  return true;
}

template <unsigned kBytes>
[[gnu::noinline]] bool Cpu::store_elsewhere(Address address, std::uint32_t value) {
  if (address % kBytes != 0 || (!has_registers(address) && !bus_.programs(address, kBytes))) return false;
  if constexpr (kBytes < 4) value &= (1u << (8 * kBytes)) - 1;
  bus_.store(address, value, kBytes);
  if (const auto page = bus_.take_changed_page()) forget(*page);
  accessed();
  return true;
}

template <unsigned kBytes>
[[gnu::always_inline]] inline bool Cpu::load(Address address, std::uint32_t& value) {
  if (address - robosim::stm32::kRam > robosim::stm32::kRamBytes - kBytes)
    return load_elsewhere<kBytes>(address, value);
  std::uint32_t read = 0;
  std::memcpy(&read, ram_ + (address - robosim::stm32::kRam), kBytes);
  value = read;
  return true;
}

template <unsigned kBytes>
[[gnu::always_inline]] inline bool Cpu::store(Address address, std::uint32_t value) {
  if (address - robosim::stm32::kRam > robosim::stm32::kRamBytes - kBytes)
    return store_elsewhere<kBytes>(address, value);
  std::memcpy(ram_ + (address - robosim::stm32::kRam), &value, kBytes);
  return true;
}

}  // namespace robosim::exec::stm32
