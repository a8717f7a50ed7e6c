// Registers of an AVR's analog-digital converter (ATmega328P, data sheet DS40002061B, chapter 24). The host
// target and the emulated chip share them. avr_adc_sample.h samples a board's pins.
//
// A conversion takes 13 ADC clocks, and samples after 1.5 clocks. The first one after switching on takes 12
// clocks more, and samples 12 clocks later (table 24-1). The references are the supply (selected by AVCC, and
// by the unwired AREF) and the bandgap. The temperature sensor and the differential channels of some chips
// read 0.
#pragma once

#include <stdint.h>

#include "hal/board/chip_spec.h"

namespace robosim {
namespace avr {

/// Returns the processor cycles per ADC clock that ADCSRA selects (table 24-5).
constexpr int adc_prescaler(uint8_t control) { return (control & 7) == 0 ? 2 : 1 << (control & 7); }

/// Return the ADC half clocks from a conversion's start to its sample, and the ADC clocks to its end.
constexpr int adc_half_clocks_to_sample(bool first) { return first ? 27 : 3; }
constexpr int adc_clocks(bool first) { return first ? 25 : 13; }

/// Returns the bits MUX of ADMUX and, if present, MUX5 of ADCSRB: table 24-4.
constexpr int adc_selection(const AdcSpec& adc, uint8_t multiplexer, uint8_t control_b) {
  return (multiplexer & adc.multiplexer_bits) | (control_b & adc.high_channels ? 0x20 : 0);
}

/// Returns the single-ended analog input that `selection` connects, or -1. MUX5 selects
/// inputs from 8 on.
constexpr int adc_channel(const AdcSpec& adc, int selection) {
  return (selection & 0x18) != 0 || (selection & 7) + (selection & 0x20 ? 8 : 0) >= adc.pins
             ? -1
             : (selection & 7) + (selection & 0x20 ? 8 : 0);
}

/// Returns the bits REFS of ADMUX: table 24-3.
constexpr int adc_reference(const AdcSpec& adc, uint8_t multiplexer) {
  return (multiplexer >> 6) + (multiplexer & adc.reference_bit ? 4 : 0);
}

/// Returns the selected reference in volts.
constexpr double adc_reference_volts(const AdcSpec& adc, uint8_t multiplexer, double supply_volts) {
  return adc.references[adc_reference(adc, multiplexer)] != 0.0
             ? adc.references[adc_reference(adc, multiplexer)]
             : supply_volts;
}

/// Returns the code of a voltage: 1024 times its share of the reference, rounded down, 0 to 1023 (24.7).
constexpr uint16_t adc_code(double volts, double reference_volts) {
  return volts / reference_volts * 1024.0 <= 0.0 ? uint16_t{0}
         : volts / reference_volts * 1024.0 >= 1023.0
             ? uint16_t{1023}
             : static_cast<uint16_t>(volts / reference_volts * 1024.0);
}

/// Returns ADCH and ADCL together, adjusted as ADMUX selects (24.9.3).
constexpr uint16_t adc_data(uint8_t multiplexer, uint16_t code) {
  return multiplexer & 0x20 ? static_cast<uint16_t>(code << 6) : code;
}

/// Returns the code of the input that ADMUX and ADCSRB select. `pin_volts(channel)` returns the volts at an
/// analog input, scaled as if the supply were nominal. If the reference is the supply, its nominal value is
/// therefore used: a drop cancels. For a constant reference they are multiplied by `supply_share()`. `held`
/// receives the volts on the converter's capacitor, scaled like those of `pin_volts`.
template <typename SupplyShare, typename PinVolts>
uint16_t adc_sample(const AdcSpec& adc, uint8_t multiplexer, uint8_t control_b, double supply_volts,
                    SupplyShare supply_share, PinVolts pin_volts, double& held) {
  const bool by_supply = adc.references[adc_reference(adc, multiplexer)] == 0.0;
  const int selection = adc_selection(adc, multiplexer, control_b), channel = adc_channel(adc, selection);
  double volts = 0.0;
  held = channel >= 0                       ? pin_volts(channel)
         : selection == adc.bandgap_channel ? adc.bandgap_volts / supply_share()
                                            : 0.0;
  if (channel >= 0) {
    volts = by_supply ? held : held * supply_share();
  } else if (selection == adc.bandgap_channel) {
    volts = by_supply ? held : adc.bandgap_volts;
  }
  return adc_code(volts, adc_reference_volts(adc, multiplexer, supply_volts));
}

}  // namespace avr
}  // namespace robosim
