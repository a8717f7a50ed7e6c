// The analog-digital converter: sampled 1.5 of its clocks after a conversion's start (13.5 after it was
// switched on), done after 13 (25). Code = volts / reference * 1024, rounded down, at most 1023 (datasheet,
// chapter 24).
//
// References: AVCC = the supply; AREF, where nothing is wired to it here, = the supply too; 1.1 V. Channels
// 0-7, the bandgap (14) and ground (15); the temperature sensor (8) reads 0. Triggers other than software and
// free running are not modelled, nor is the settling time of a reference.
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
  std::uint16_t sample() const;
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
