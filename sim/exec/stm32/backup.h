// Models power control and the backup domain: backup registers and RTC (RM0008 5, 6, 18). A chip reset does
// not change the backup domain.
//
//   Power    PWR_CR, whose DBP bit unlocks Backup and Rtc; the voltage detector (PVD) sees no low supply
//   Backup   ten registers of 16 bits
//   Rtc      counts up by 1 every PRL + 1 periods of its clock: LSE 32768 Hz, LSI 40 kHz, or HSE / 128
//
// The backup domain is lost at power-off, since a Blue Pill has no battery at VBAT. Writes to the RTC take
// effect at once, so RTOFF and RSF are always 1.
#pragma once

#include "sim/exec/stm32/clocks.h"

namespace robosim::exec::stm32 {

class Power final : public Peripheral {
 public:
  explicit Power(Link& link) { link.snapshots.add(state_); }

  std::uint32_t read(Address address) override;
  bool write(Address address, std::uint32_t value) override;
  void reset(Address) override { state_.control = state_.status = 0; }
  /// Returns whether firmware can write the backup domain.
  bool allows() const { return state_.control & 1u << 8; }

 private:
  struct State {
    std::uint32_t control = 0, status = 0;
  };
  State state_;
};

class Backup final : public Peripheral {
 public:
  Backup(Link& link, const Power& power) : power_(power) { link.snapshots.add(state_); }

  std::uint32_t read(Address address) override;
  bool write(Address address, std::uint32_t value) override;
  void reset(Address) override {}
  /// Resets the registers when firmware sets BDRST in RCC_BDCR.
  void reset_domain() { state_.data = {}; }

 private:
  struct State {
    std::array<std::uint32_t, 14> data{};
  };

  static std::size_t place(Address address);

  const Power& power_;
  State state_;
};

class Rtc final : public Peripheral {
 public:
  /// Calls `alarmed`, which drives EXTI line 17, when the counter reaches the alarm value.
  Rtc(Link& link, const Power& power, std::function<void()> alarmed)
      : link_(link), power_(power), alarmed_(std::move(alarmed)) {
    link.snapshots.add(state_);
  }

  std::uint32_t read(Address address) override;
  bool write(Address address, std::uint32_t value) override;
  /// Resets only the interrupt state, since the other registers belong to the backup domain.
  void reset(Address block) override;
  void reset_domain();
  Cycle next_event() const override;
  void update() override;
  /// Sets the clock frequency in Hz; 0 stops the RTC.
  void set_clock(std::uint32_t hz);

 private:
  struct State {
    std::uint32_t hz = 0, enabled = 0, flags = 0, divider = 0x8000, alarm = 0xFFFFFFFF;
    bool configures = false;
    std::uint32_t began_with = 0;  ///< counter value at `began`
    SimTime began = 0;
    std::uint64_t told = 0;  ///< number of ticks since `began` whose events have been handled
  };

  SimTime now() const { return link_.clock.time_of(link_.clock.now); }
  SimTime time_of(std::uint64_t ticks) const;
  std::uint64_t ticks() const;
  void restart(std::uint32_t counter);
  void refresh_line();

  Link& link_;
  const Power& power_;
  const std::function<void()> alarmed_;
  State state_;
};

}  // namespace robosim::exec::stm32
