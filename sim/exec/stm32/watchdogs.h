// Models the two watchdogs: the independent watchdog (RM0008 19) and the window watchdog (20).
//
//   IWDG   resets the chip 4 * 2^PR * (RLR + 1) / 40 kHz after the last reload; also runs in sleep
//   WWDG   counts down by 1 every 4096 * 2^WDGTB cycles of APB1; resets the chip at 0x3F, or on a write while
//          the counter is above the window
//
// A write to IWDG_PR or IWDG_RLR is complete at once, so IWDG_SR reads 0. A new IWDG_RLR is used from the
// next reload on. LSI runs at exactly 40 kHz (DS5319, table 25: 30 to 60 kHz). After a write to WWDG_CR, the
// next count takes its full duration.
#pragma once

#include "sim/exec/stm32/clocks.h"

namespace robosim::exec::stm32 {

class IndependentWatchdog final : public Peripheral {
 public:
  explicit IndependentWatchdog(Link& link) : link_(link) { link.snapshots.add(state_); }

  std::uint32_t read(Address address) override;
  bool write(Address address, std::uint32_t value) override;
  void reset(Address block) override;
  Cycle next_event() const override { return state_.runs ? link_.clock.cycle_at(state_.ends) : kNoCycle; }
  void update() override;

 private:
  struct State {
    bool runs = false, unlocked = false;
    std::uint32_t prescaler = 0, reload = 0xFFF;
    SimTime ends = 0;  ///< time at which the watchdog resets the chip
  };

  /// Returns the duration of one count of the watchdog.
  SimTime step() const;

  Link& link_;
  State state_;
};

class WindowWatchdog final : public Peripheral {
 public:
  WindowWatchdog(Link& link, const Clocks& clocks) : link_(link), clocks_(clocks) {
    link.snapshots.add(state_);
  }

  std::uint32_t read(Address address) override;
  bool write(Address address, std::uint32_t value) override;
  void reset(Address block) override;
  Cycle next_event() const override;
  void update() override;

 private:
  struct State {
    std::uint32_t configuration = 0x7F;
    bool on = false, early = false, told = false;
    std::uint32_t written = 0x7F;
    Cycle written_at = 0;
  };

  Cycle step() const;
  std::uint32_t count() const;
  /// Returns when the counter will reach `value`; kNoCycle if the counter is already below `value`.
  Cycle reaches(std::uint32_t value) const;

  Link& link_;
  const Clocks& clocks_;
  State state_;
};

}  // namespace robosim::exec::stm32
