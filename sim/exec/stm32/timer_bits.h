// Defines bits of the timers' registers (RM0008 14.4, 15.4) that hal/stm32 does not use.
#pragma once

#include <cstdint>

namespace robosim::exec::stm32 {

// TIM_CR1, TIM_CR2
constexpr std::uint32_t kUdis = 1u << 1, kDir = 1u << 4, kCms = 3u << 5, kCkd = 3u << 8;
constexpr std::uint32_t kCcpc = 1u << 0, kCcus = 1u << 2, kMmsShift = 4;
// TIM_SMCR
enum SlaveMode : std::uint32_t {
  kEncoder1 = 1,
  kEncoder2 = 2,
  kEncoder3 = 3,
  kResets = 4,
  kGates = 5,
  kStarts = 6,
  kClocks = 7
};
enum TriggerInput : std::uint32_t { kAnyEdgeOf1 = 4, kInput1 = 5, kInput2 = 6, kExternal = 7 };
constexpr std::uint32_t kExternalClock = 1u << 14;
// TIM_DIER, TIM_SR, TIM_EGR: bit x belongs to channel x, 1 to 4.
constexpr std::uint32_t kComEvent = 1u << 5, kTriggerEvent = 1u << 6, kBreakEvent = 1u << 7, kUde = 1u << 8,
                        kTde = 1u << 14;
constexpr std::uint32_t channel_event(int channel) { return 2u << channel; }
constexpr std::uint32_t channel_dma(int channel) { return 0x200u << channel; }
constexpr std::uint32_t overcapture(int channel) { return 0x200u << channel; }

}  // namespace robosim::exec::stm32
