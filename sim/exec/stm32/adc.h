// Models ADC1 and ADC2 (RM0008 11). Each ADC converts the channels of a regular group and of an injected
// group in sequence.
//
//   code = volts / supply * 4096, 0 to 4095     a conversion = (sampling time + 12.5) ADC cycles
//
// The pin is sampled at the end of the sampling time. Channels 0 to 9 are pins. Only ADC1 has channels 16 and
// 17 (DS5319, tables 50 and 12). Channel 16 is the temperature sensor, always at 25 degrees Celsius. Channel
// 17 is the 1.20 V reference. Dual modes are not modelled and are refused. Channels 10 to 15 are refused,
// too, since this chip has no pins for them.
#pragma once

#include "sim/exec/stm32/clocks.h"

namespace robosim::exec::stm32 {

class Adc final : public Peripheral {
 public:
  /// `index` is 0 for ADC1, 1 for ADC2. The two ADCs share the interrupt `line`.
  Adc(Link& link, const Clocks& clocks, SharedLine& line, int index);

  std::uint32_t read(Address address) override;
  bool write(Address address, std::uint32_t value) override;
  void reset(Address block) override;
  Cycle next_event() const override {
    return state_.converts == Group::none ? kNoCycle : std::min(state_.sample_at, state_.done_at);
  }
  // Returns 0 (unknown) for ADC_DR, since reading it clears EOC.
  Cycle same_until(Address address) const override {
    return address == base_ + robosim::stm32::kAdcDr - robosim::stm32::kAdc1 ? 0 : next_event();
  }
  void update() override;
  bool acts_alone() const override { return true; }
  unsigned dma_requests() const override;
  Signals listens() const override;
  void heard(Signals signal) override;

 private:
  enum class Group { none, regular, injected };
  /// State that an ADC reset restores to its defaults.
  struct State {
    std::uint32_t status = 0, control1 = 0, control2 = 0, data = 0, high = 0xFFF, low = 0;
    std::array<std::uint32_t, 2> sample_times{};
    std::array<std::uint32_t, 3> sequence{};
    std::array<std::uint32_t, 4> offsets{}, injected_data{};
    std::uint32_t injected_sequence = 0;

    Group converts = Group::none;
    int regular_at = 0, injected_at = 0;  ///< positions in the two sequences
    int left = 0;                         ///< unfinished regular conversions of the last trigger
    bool regular_waits = false;           ///< a regular conversion waits for the end of the injected group
    bool dma_asks = false;
    std::uint32_t sampled = 0;
    Cycle sample_at = kNoCycle, done_at = 0;
  };

  bool write_register(Address address, std::uint32_t value);
  bool write_control2(std::uint32_t value);
  void refresh_line();

  int regular_length() const;
  int injected_length() const { return static_cast<int>(state_.injected_sequence >> 20 & 3) + 1; }
  unsigned channel_of(Group group, int place) const;
  unsigned channel() const {
    return channel_of(state_.converts,
                      state_.converts == Group::injected ? state_.injected_at : state_.regular_at);
  }
  bool sequences_are_modelled() const;
  void start_regular(Cycle at);
  void start_injected(Cycle at);
  /// Begins the next conversion of the group at the cycle `at`.
  void begin(Group group, Cycle at);
  void finish();
  void finish_regular();
  void finish_injected();
  double volts(unsigned channel);
  void watch(bool guarded);

  Link& link_;
  const Clocks& clocks_;
  SharedLine& line_;
  const int index_;
  const Address base_;
  std::array<Pin, kStm32f103c8.adc.pins> pins_;
  State state_;
};

}  // namespace robosim::exec::stm32
