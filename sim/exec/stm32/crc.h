// Models the CRC unit (RM0008 4), which computes a CRC with the polynomial 0x04C11DB7, one word at a time.
// The result is available without delay.
#pragma once

#include "sim/exec/stm32/peripheral.h"

namespace robosim::exec::stm32 {

class Crc final : public Peripheral {
 public:
  explicit Crc(Link& link) { link.snapshots.add(state_); }

  std::uint32_t read(Address address) override {
    return address == robosim::stm32::kCrc ? state_.remainder : address == kIndependent ? state_.kept : 0;
  }
  bool write(Address address, std::uint32_t value) override {
    if (address == kIndependent) state_.kept = value & 0xFF;
    if (address == kControl && value & 1) state_.remainder = 0xFFFFFFFF;
    if (address != robosim::stm32::kCrc) return true;
    state_.remainder ^= value;
    for (int bit = 0; bit < 32; ++bit)
      state_.remainder = state_.remainder << 1 ^ (state_.remainder >> 31 ? 0x04C11DB7u : 0);
    return true;
  }
  void reset(Address) override {
    state_.remainder = 0xFFFFFFFF;
    state_.kept = 0;
  }

 private:
  struct State {
    std::uint32_t remainder = 0xFFFFFFFF, kept = 0;
  };

  static constexpr Address kIndependent = robosim::stm32::kCrc + 4, kControl = robosim::stm32::kCrc + 8;
  State state_;
};

}  // namespace robosim::exec::stm32
