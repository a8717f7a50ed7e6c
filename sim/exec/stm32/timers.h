// TIM1 to TIM4, counting up: PWM, and interrupts at the update event (RM0008 14, 15).
//
//   a period = (PSC + 1) * (ARR + 1) cycles     duty (PWM mode 1) = min(CCR / (ARR + 1), 1), mode 2 the rest
//
// New values count at once, not only at the next update. Refused, as not modelled: other ways of counting,
// input capture, slave modes, interrupts at a compare, DMA, outputs other than PWM.
#pragma once

#include <array>

#include "sim/exec/stm32/peripheral.h"

namespace robosim::exec::stm32 {

/// What a reset of a timer resets.
struct TimerRegisters {
  std::uint32_t control_ = 0, control2_ = 0, interrupts_ = 0, status_ = 0, outputs_ = 0, dead_time_ = 0;
  std::array<std::uint32_t, 2> modes_{};
  std::uint32_t prescaler_ = 0, waiting_prescaler_ = 0, top_ = 0xFFFF, repetition_ = 0;
  std::array<std::uint32_t, 4> compare_{};
  std::uint32_t held_ = 0;  ///< the count while it stands still
  Cycle update_at_ = 0;     ///< the next overflow while it runs
};

class Timer final : public Peripheral, TimerRegisters {
 public:
  struct Place {
    Address base;
    robosim::stm32::Irq irq;
    std::array<ChipPin, 4> pins;
  };

  Timer(Link& link, const Place& place) : link_(link), place_(place) {}

  std::uint32_t read(Address address) override;
  bool write(Address address, std::uint32_t value) override;
  void reset(Address block) override;
  bool drives(ChipPin pin, PinDrive& drive) const override;
  Cycle next_event() const override {
    return enabled() && interrupts_ & robosim::stm32::kUie ? update_at_ : kNoCycle;
  }
  void update() override;

 private:
  bool enabled() const { return control_ & robosim::stm32::kCen; }
  bool advanced() const { return place_.base == robosim::stm32::kTim1; }
  Cycle step() const { return Cycle{prescaler_} + 1; }
  Cycle period() const { return step() * (Cycle{top_} + 1); }
  std::uint32_t count() const;
  void start_from(std::uint32_t count);
  void update_event(bool flag);
  void refresh();
  bool supported_modes() const;
  PinDrive drive_of(int channel) const;

  Link& link_;
  Place place_;
};

}  // namespace robosim::exec::stm32
