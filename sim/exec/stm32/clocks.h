// RCC: where the clock comes from, and which peripherals have one (RM0008 7).
//
// Modelled: HSI (8 MHz), HSE (an 8 MHz crystal, as on a Blue Pill, there after 2 ms: DS5319 table 22), the
// PLL (locks within 200 us: table 27), AHB at SYSCLK, APB1 at up to 36 MHz, APB2 at AHB's frequency. Other
// prescalers are refused, as not modelled.
#pragma once

#include "sim/exec/stm32/link.h"

namespace robosim::exec::stm32 {

class Clocks {
 public:
  explicit Clocks(Link& link) : link_(link) {}

  static bool owns(Address address) {
    return address >= robosim::stm32::kRcc && address <= robosim::stm32::kRccCsr;
  }
  std::uint32_t read(Address address);
  /// False for what is not modelled.
  bool write(Address address, std::uint32_t value);

  /// Of a peripheral behind APB1 or APB2 (RM0008 7.3.7, 7.3.8).
  bool has_clock(Address address) const {
    return (robosim::stm32::behind_apb2(address) ? apb2_ : apb1_) & robosim::stm32::clock_bit(address);
  }
  /// Whether RCC_APB1RSTR or RCC_APB2RSTR holds it in its reset (7.3.3, 7.3.4).
  bool holds_in_reset(Address address) const {
    return (robosim::stm32::behind_apb2(address) ? apb2_reset_ : apb1_reset_) &
           robosim::stm32::clock_bit(address);
  }
  /// What the processor's frequency is divided by for APB1.
  std::uint32_t apb1_divider() const {
    const std::uint32_t bits = configuration_ >> 8 & 7;
    return bits < 4 ? 1 : 2u << (bits - 4);
  }
  /// What APB2's frequency is divided by for the ADC.
  std::uint32_t adc_divider() const { return 2 * ((configuration_ >> 14 & 3) + 1); }
  /// Flash's wait states are set elsewhere; too few for the frequency make a real chip fail.
  std::uint32_t hz() const;

 private:
  bool pll_ready() const;
  std::uint32_t pll_hz() const;
  bool switch_clock();

  Link& link_;
  std::uint32_t control_ = robosim::stm32::kHsiOn | 0x80;
  std::uint32_t configuration_ = 0, interrupts_ = 0, backup_ = 0;
  std::uint32_t ahb_ = 0x14, apb1_ = 0, apb2_ = 0, apb1_reset_ = 0, apb2_reset_ = 0;
  SimTime hse_ready_ = 0, pll_ready_ = 0;
};

}  // namespace robosim::exec::stm32
