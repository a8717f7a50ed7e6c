// The CRC unit (RM0008 4): polynomial 0x04C11DB7, a word at a time, at once.
#pragma once

#include "sim/exec/stm32/peripheral.h"

namespace robosim::exec::stm32 {

class Crc final : public Peripheral {
 public:
  std::uint32_t read(Address address) override {
    return address == robosim::stm32::kCrc ? remainder_ : address == kIndependent ? kept_ : 0;
  }
  bool write(Address address, std::uint32_t value) override {
    if (address == kIndependent) kept_ = value & 0xFF;
    if (address == kControl && value & 1) remainder_ = 0xFFFFFFFF;
    if (address != robosim::stm32::kCrc) return true;
    remainder_ ^= value;
    for (int bit = 0; bit < 32; ++bit) remainder_ = remainder_ << 1 ^ (remainder_ >> 31 ? 0x04C11DB7u : 0);
    return true;
  }
  void reset(Address) override {
    remainder_ = 0xFFFFFFFF;
    kept_ = 0;
  }

 private:
  static constexpr Address kIndependent = robosim::stm32::kCrc + 4, kControl = robosim::stm32::kCrc + 8;

  std::uint32_t remainder_ = 0xFFFFFFFF, kept_ = 0;
};

}  // namespace robosim::exec::stm32
