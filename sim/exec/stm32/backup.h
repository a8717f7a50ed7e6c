// Power control and the backup domain (RM0008 5, 6, 18), which a reset of the chip does not change.
//
//   Power    PWR_CR, whose DBP unlocks the rest; the supply is always above the detector's threshold
//   Backup   ten registers of 16 bits
//   Rtc      counts up by 1 each PRL + 1 periods of its clock: LSE 32768 Hz, LSI 40 kHz, or HSE / 128
//
// All of it loses its content with the power: a Blue Pill's VBAT has no battery. Writes to the RTC take
// effect at once: RTOFF and RSF are always 1.
#pragma once

#include "sim/exec/stm32/clocks.h"

namespace robosim::exec::stm32 {

class Power final : public Peripheral {
 public:
  explicit Power(Link& link) { link.snapshots.add(state_); }

  std::uint32_t read(Address address) override;
  bool write(Address address, std::uint32_t value) override;
  void reset(Address) override { state_.control = state_.status = 0; }
  /// Returns whether the backup domain can be written.
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
  /// Resets the domain, by RCC_BDCR's BDRST.
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
  /// Calls `alarmed` when the counter reaches the alarm: EXTI's line 17.
  Rtc(Link& link, const Power& power, std::function<void()> alarmed)
      : link_(link), power_(power), alarmed_(std::move(alarmed)) {
    link.snapshots.add(state_);
  }

  std::uint32_t read(Address address) override;
  bool write(Address address, std::uint32_t value) override;
  /// Resets only its interrupts: the rest belongs to the backup domain.
  void reset(Address block) override;
  void reset_domain();
  Cycle next_event() const override;
  void update() override;
  /// Sets its clock in Hz; 0 = stopped.
  void set_clock(std::uint32_t hz);

 private:
  struct State {
    std::uint32_t hz = 0, enabled = 0, flags = 0, divider = 0x8000, alarm = 0xFFFFFFFF;
    bool configures = false;
    std::uint32_t began_with = 0;  ///< the counter
    SimTime began = 0;
    std::uint64_t told = 0;  ///< ticks counted since
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
