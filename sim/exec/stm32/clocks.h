// Models RCC, which selects the clock source and enables the peripherals' clocks (RM0008 7).
//
// HSI (8 MHz), HSE, the PLL and all prescalers are modelled. HSE is an 8 MHz crystal, as on a Blue Pill, and
// is ready after 2 ms (DS5319 table 22). The PLL locks within 200 us (table 27).
#pragma once

#include "sim/exec/stm32/peripheral.h"

namespace robosim::exec::stm32 {

/// First address of the AHB. Peripherals below it are on the APBs (RM0008 3.3).
constexpr robosim::stm32::Address kAhb = 0x40018000;

/// Reports whether a peripheral has a clock (RM0008 7.3.6 to 7.3.8), and whether RCC holds the peripheral in
/// reset (7.3.3, 7.3.4).
struct Gate {
  const std::uint32_t* enabled = nullptr;  ///< register with the enable bit; null = always clocked
  const std::uint32_t* reset = nullptr;
  std::uint32_t bit = 0;

  bool has_clock() const { return !enabled || *enabled & bit; }
  bool holds_in_reset() const { return reset && *reset & bit; }
};

class Power;

class Clocks final : public Peripheral {
 public:
  /// `power` determines whether firmware can write RCC_BDCR.
  Clocks(Link& link, const Power& power) : link_(link), power_(power) { link.snapshots.add(state_); }

  std::uint32_t read(Address address) override;
  bool write(Address address, std::uint32_t value) override;
  void reset(Address block) override;
  Cycle same_until(Address address) const override;
  /// Records the cause of a chip reset, which RCC_CSR then reports.
  void note(Reset cause);

  /// Returns the gate of the peripheral whose registers begin at `block`.
  Gate gate(Address block) const;
  /// Returns the prescaler of the bus (APB1 or APB2) of the peripheral at `address`: the processor's
  /// frequency, divided by the frequency of the bus.
  std::uint32_t bus_divider(Address address) const {
    return robosim::stm32::behind_apb2(address) ? divider(state_.configuration >> 11)
                                                : divider(state_.configuration >> 8);
  }
  std::uint32_t apb1_divider() const { return divider(state_.configuration >> 8); }
  /// Returns the divisor for the timers on a bus: half the bus divisor, at least 1 (7.2, figure 8).
  std::uint32_t timer_divider(Address address) const { return std::max(bus_divider(address) / 2, 1u); }
  /// Returns the processor's frequency divided by the ADC's frequency.
  std::uint32_t adc_divider() const {
    return divider(state_.configuration >> 11) * 2 * ((state_.configuration >> 14 & 3) + 1);
  }
  /// Returns the frequency of the RTC's clock; 0 if this clock is off (7.3.9).
  std::uint32_t rtc_hz() const;
  bool resets_backup_domain() const { return state_.backup & 1u << 16; }
  /// Returns the processor's frequency. Ignores the wait states in FLASH_ACR, although a real chip fails if
  /// there are too few wait states.
  std::uint32_t hz() const;

 private:
  /// Registers that a chip reset restores to their defaults.
  struct Registers {
    std::uint32_t control = robosim::stm32::kHsiOn | 0x80;
    std::uint32_t configuration = 0, interrupts = 0, status = 0;
    std::uint32_t ahb = 0x14, apb1 = 0, apb2 = 0, apb1_reset = 0, apb2_reset = 0;
    SimTime hse_ready = 0, pll_ready = 0;
  };
  struct State : Registers {
    std::uint32_t backup = 0;  ///< RCC_BDCR, which survives chip resets
    SimTime lse_ready = 0;
    std::uint32_t reset_flags = robosim::stm32::kPinReset | robosim::stm32::kPowerOnReset;
  };

  /// Returns the divisor that PPRE1 or PPRE2 selects.
  static std::uint32_t divider(std::uint32_t bits) { return (bits & 7) < 4 ? 1 : 2u << ((bits & 7) - 4); }
  bool pll_ready() const;
  std::uint32_t pll_hz() const;
  bool switch_clock();

  Link& link_;
  const Power& power_;
  State state_;
};

}  // namespace robosim::exec::stm32
