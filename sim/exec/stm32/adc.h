// ADC1 and ADC2: one conversion at a time, started by software (RM0008 11).
//
//   code = volts / supply * 4096, 0 to 4095     a conversion = (sampling time + 12.5) ADC cycles
//
// The pin is sampled at the end of the sampling time. Channels 0 to 9 are pins. Refused, as not modelled:
// dual mode, scans, continuous and injected conversions, triggers, DMA, the watchdog, the temperature sensor.
#pragma once

#include "sim/exec/stm32/clocks.h"

namespace robosim::exec::stm32 {

/// What a reset of the ADC resets.
struct AdcRegisters {
  std::uint32_t status_ = 0, control1_ = 0, control2_ = 0, data_ = 0, sampled_ = 0;
  std::array<std::uint32_t, 2> sample_times_{};
  std::array<std::uint32_t, 3> sequence_{};
  bool converts_ = false;
  Cycle sample_at_ = kNoCycle, done_at_ = 0;
};

class Adc final : public Peripheral, AdcRegisters {
 public:
  /// `index`: 0 is ADC1; both share `line`.
  Adc(Link& link, const Clocks& clocks, SharedLine& line, int index);

  std::uint32_t read(Address address) override;
  bool write(Address address, std::uint32_t value) override;
  void reset(Address block) override;
  /// When the pin is sampled, or an interrupt comes.
  Cycle next_event() const override {
    return sample_at_ != kNoCycle ? sample_at_ : converts_ ? done_at_ : kNoCycle;
  }
  void update() override;

 private:
  static constexpr std::uint32_t kEocie = 1u << 5;  // ADC_CR1

  bool start();
  bool write_register(Address address, std::uint32_t value);
  void refresh_line() { line_.set(index_, status_ & robosim::stm32::kEoc && control1_ & kEocie); }
  int channel() const { return static_cast<int>(sequence_[2] & 31); }

  Link& link_;
  const Clocks& clocks_;
  SharedLine& line_;
  int index_;
  Address base_;
  std::array<Pin, kStm32f103c8.adc.pins> pins_;
};

}  // namespace robosim::exec::stm32
