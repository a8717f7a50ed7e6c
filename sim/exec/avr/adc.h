// The analog-digital converter (datasheet, chapter 24); what its registers mean is hal/board/avr_adc.h's.
// Triggers other than software and free running are not modelled, nor is the settling time of a
// reference.
#pragma once

#include <cstdint>

#include "sim/exec/avr/link.h"

namespace robosim::exec::avr {

class Adc {
 public:
  explicit Adc(Link& link);

  /// Of ADCL and ADCH.
  std::uint8_t read(reg::Address address);
  void was_reset();

 private:
  static void on_start(avr_irq_t* irq, std::uint32_t value, void* self);
  static avr_cycle_count_t on_sample(avr_t* avr, avr_cycle_count_t when, void* self);
  void finish();

  Link& link_;
  avr_adc_t* module_;
  std::uint8_t multiplexer_ = 0;  ///< ADMUX when the conversion began
  bool converting_ = false;
  Cycle done_at_ = 0;
  std::uint16_t sampled_ = 0;
  std::uint16_t result_ = 0;
  bool locked_ = false;  ///< ADCL was read and ADCH not yet
};

}  // namespace robosim::exec::avr
