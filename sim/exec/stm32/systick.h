// Models SysTick, the timer of the processor (PM0056 4.5), which repeatedly counts from LOAD down to 0.
#pragma once

#include "sim/exec/stm32/peripheral.h"

namespace robosim::exec::stm32 {

class SysTick final : public Peripheral {
 public:
  explicit SysTick(Link& link) : link_(link) { link.snapshots.add(state_); }

  static bool owns(Address address) {
    return address >= robosim::stm32::kStkCtrl && address <= robosim::stm32::kStkCalib;
  }
  std::uint32_t read(Address address) override;
  bool write(Address address, std::uint32_t value) override;
  void reset(Address block) override;

  /// Returns when the counter next reaches 0. Returns kNoCycle if the counter is stopped, or if its interrupt
  /// is disabled.
  Cycle next_event() const override;
  Cycle same_until(Address address) const override;
  /// Sets COUNTFLAG and the pending interrupt if the counter has reached 0 since the last call.
  void update() override;

 private:
  struct State {
    std::uint32_t control = 0, load = 0;
    std::uint32_t held = 0;  ///< the counter's value while the counter is stopped
    Cycle zero_at = 0;       ///< while the counter runs, the cycle at which it next reaches 0
    bool counted = false;    ///< COUNTFLAG
  };

  Cycle period() const { return (Cycle{state_.load} + 1) * (by_eight() ? 8 : 1); }
  bool by_eight() const { return !(state_.control & robosim::stm32::kClkSource); }
  bool runs() const { return state_.control & robosim::stm32::kStkEnable && state_.load > 0; }
  std::uint32_t value() const;
  void set_value(std::uint32_t value);

  Link& link_;
  State state_;
};

}  // namespace robosim::exec::stm32
