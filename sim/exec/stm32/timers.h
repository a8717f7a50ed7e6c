// Models TIM1 to TIM4 (RM0008 14, 15): counting, comparing, capturing, and triggering one another.
//
//   up, down         a period = (PSC + 1) * (ARR + 1) cycles    duty = min(CCR / (ARR + 1), 1), PWM mode 1
//   centre-aligned              (PSC + 1) * 2 * ARR                    CCR / ARR
//
// timers.cpp implements the registers, timer_counter.cpp the counter, timer_channels.cpp the channels and
// signals. PWM is reported as a duty cycle. A program that reads a pin with PWM gets the pin's present level.
// Other outputs are reported as edges. An input edge captures the count at the time of the edge, without
// filter or synchroniser. Dead time does not change a duty cycle. A preloaded CCR, ARR or PSC takes effect at
// the next update event.
//
// These are not modelled and are refused: external trigger inputs (ETR), gating by another timer, DMA bursts,
// and the break input.
#pragma once

#include <array>

#include "sim/exec/stm32/clocks.h"

namespace robosim::exec::stm32 {

class Timer final : public Peripheral {
 public:
  /// `index` is the timer's position in kStm32f103c8.timers.
  Timer(Link& link, const Clocks& clocks, int index);

  std::uint32_t read(Address address) override;
  bool write(Address address, std::uint32_t value) override;
  void reset(Address block) override;
  bool drives(ChipPin pin, PinDrive& drive) const override;
  Pulse pulse(ChipPin pin) const override;
  bool watches(ChipPin pin) const override;
  void edge(ChipPin pin, bool level, Cycle at) override;
  Cycle next_event() const override;
  void update() override;
  unsigned dma_requests() const override { return state_.dma_pending; }
  void dma_served(int channel) override { state_.dma_pending &= ~dma_channel(channel); }
  Signals listens() const override;
  void heard(Signals signals) override;

 private:
  /// State that a timer reset restores to its defaults.
  struct State {
    std::uint32_t control = 0, control2 = 0, slave = 0, interrupts = 0, status = 0, outputs = 0,
                  dead_time = 0;
    std::array<std::uint32_t, 2> modes{}, waiting_modes{};
    std::uint32_t waiting_outputs = 0;
    std::uint32_t waiting_prescaler = 0, waiting_top = 0xFFFF, repetition = 0;
    std::array<std::uint32_t, 4> waiting_compare{};
    // The values that are in effect. The `waiting_` values above take effect at the next update or
    // commutation event.
    std::uint32_t prescaler = 0, top = 0xFFFF, repetitions_left = 0;
    std::array<std::uint32_t, 4> compare{};
    std::array<bool, 4> active{};             ///< OCxREF, except in PWM modes
    std::array<std::uint32_t, 4> captures{};  ///< edges counted by the capture prescaler
    unsigned dma_pending = 0;

    std::uint32_t held = 0;  ///< the count while the counter has no clock
    Cycle origin = 0;        ///< start of the period while the counter has a clock
    Cycle step = 1;          ///< cycles for each count
    std::int64_t done = -1;  ///< position in the period up to which all events have been handled
    bool steps_down = false;
  };

  static constexpr int kChannels = 4;

  // --- registers
  bool enabled() const { return state_.control & robosim::stm32::kCen; }
  bool advanced() const { return index_ == stm32f103c8::kTim1; }
  int number() const { return index_ + 1; }
  bool write_register(Address offset, std::uint32_t value);
  bool write_compare(std::size_t channel, std::uint32_t value);
  bool slave_is_modelled() const;
  /// Applies the written modes and outputs. Called after the write, or at a commutation (14.3.15).
  void commutate();
  void refresh_lines();
  void refresh_pins();

  // --- counter
  bool is_clocked() const;
  bool centered() const { return state_.control >> 5 & 3; }
  bool counts_down() const { return state_.control & 1u << 4; }
  std::int64_t period() const;
  std::int64_t place(Cycle at) const { return static_cast<std::int64_t>((at - state_.origin) / state_.step); }
  std::uint32_t count_at(std::int64_t place) const;
  std::uint32_t count(Cycle at) const;
  void start_from(std::uint32_t count, Cycle at);
  /// Returns the positions in a period at which the count equals the channel's CCR; -1 = no such position.
  std::array<std::int64_t, 2> places_of(int channel) const;
  bool needs_update_event() const;
  bool needs_compare_event(int channel) const;
  void fall_behind(std::int64_t place);
  void overflow(Cycle at);
  void load_waiting();
  void update_event(bool flag);
  void step(bool up, Cycle at);

  // --- channels
  std::uint32_t mode(int channel) const {
    return state_.modes[static_cast<std::size_t>(channel / 2)] >> (8 * (channel % 2)) & 0xFF;
  }
  bool captures(int channel) const { return mode(channel) & 3; }
  bool is_on(int channel) const { return state_.outputs >> (4 * channel) & 1; }
  bool is_pwm(int channel) const;
  ChipPin pin_of(int channel) const;
  void compared(int channel);
  void capture(int channel, Cycle at);
  void captured_or_compared(int channel);
  double share_of(int channel) const;
  std::uint32_t period_us() const;
  PinDrive drive_of(int channel, bool complement) const;
  bool inverts(int channel, bool complement) const;
  Pulse pulse_of(int channel) const;
  void trigger(Cycle at);
  /// Returns whether TRGO rises at an update event. This is so if TRGO is the OCxREF of a channel in PWM
  /// mode 1.
  bool rises_at_update() const;
  void edge_of_input(int input, bool level, Cycle at);

  Link& link_;
  const Clocks& clocks_;
  const int index_;
  const Address base_;
  const robosim::stm32::Irq irq_;
  std::array<ChipPin, kChannels> usual_pins_{};
  State state_;
};

}  // namespace robosim::exec::stm32
