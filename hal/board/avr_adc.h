// Decodes the registers of an AVR's analog-to-digital converter (ATmega328P, data sheet DS40002061B, chapter
// 24), for the target host and for the emulated chip.
//
// A conversion takes 13 ADC clocks, and samples its input after 1.5 clocks. The first conversion after the
// ADC is enabled takes 25 clocks, and samples after 13.5 clocks (table 24-1). A reference is either the
// supply or an internal voltage. AVCC selects the supply, and so does AREF, because the pin AREF is not
// wired. The temperature sensor, and the differential channels that some chips have, read 0.
#pragma once

#include <stdint.h>

#include "hal/board/adc_capacitor.h"
#include "hal/board/chip_spec.h"

namespace robosim {
namespace avr {

/// Returns the number of processor cycles per ADC clock that ADCSRA selects (table 24-5).
constexpr int adc_prescaler(uint8_t control) { return (control & 7) == 0 ? 2 : 1 << (control & 7); }

/// Return the duration from a conversion's start to its sample (in half ADC clocks) or to its end (in ADC
/// clocks).
constexpr int adc_half_clocks_to_sample(bool first) { return first ? 27 : 3; }
constexpr int adc_clocks(bool first) { return first ? 25 : 13; }

/// Returns the selected input: the bits MUX of ADMUX and, if the chip has it, the bit MUX5 of ADCSRB (table
/// 24-4).
constexpr int adc_selection(const AdcSpec& adc, uint8_t multiplexer, uint8_t control_b) {
  return (multiplexer & adc.multiplexer_bits) | (control_b & adc.high_channels ? 0x20 : 0);
}

/// Returns the number of the single-ended analog input that `selection` connects, or -1 for any other input.
/// MUX5 selects inputs from 8 on.
constexpr int adc_channel(const AdcSpec& adc, int selection) {
  return (selection & 0x18) != 0 || (selection & 7) + (selection & 0x20 ? 8 : 0) >= adc.pins
             ? -1
             : (selection & 7) + (selection & 0x20 ? 8 : 0);
}

/// Returns the bits REFS of ADMUX (table 24-3), which are an index of AdcSpec::references.
constexpr int adc_reference(const AdcSpec& adc, uint8_t multiplexer) {
  return (multiplexer >> 6) + (multiplexer & adc.reference_bit ? 4 : 0);
}

/// Returns the selected reference in volts.
constexpr double adc_reference_volts(const AdcSpec& adc, uint8_t multiplexer, double supply_volts) {
  return adc.references[adc_reference(adc, multiplexer)] != 0.0
             ? adc.references[adc_reference(adc, multiplexer)]
             : supply_volts;
}

/// Returns the result of converting a voltage: 1024 volts / reference, rounded down, from 0 to 1023 (24.7).
constexpr uint16_t adc_code(double volts, double reference_volts) {
  return volts / reference_volts * 1024.0 <= 0.0 ? uint16_t{0}
         : volts / reference_volts * 1024.0 >= 1023.0
             ? uint16_t{1023}
             : static_cast<uint16_t>(volts / reference_volts * 1024.0);
}

/// Returns the 16 bits of ADCH and ADCL. The result is left-adjusted if ADLAR is set in ADMUX (24.9.3).
constexpr uint16_t adc_data(uint8_t multiplexer, uint16_t code) {
  return multiplexer & 0x20 ? static_cast<uint16_t>(code << 6) : code;
}

/// Samples the input that ADMUX and ADCSRB select, and returns the conversion result. `source(channel)`
/// returns the source at an analog input. This source charges `capacitor` for `seconds()`. Calls
/// `report(channel)` if this source or the previous one has a resistance.
template <typename Seconds, typename SourceAt, typename Report>
__attribute__((always_inline)) inline uint16_t adc_sample(const AdcSpec& adc, uint8_t multiplexer,
                                                          uint8_t control_b, double supply_volts,
                                                          Seconds seconds, AdcCapacitor& capacitor,
                                                          SourceAt source, Report report) {
  const int selection = adc_selection(adc, multiplexer, control_b), channel = adc_channel(adc, selection);
  if (channel >= 0) {
    const Source input = source(channel);
    if (__builtin_expect(input.ohms > 0.0 || capacitor.slow, 0)) {
      capacitor.charge(input, seconds());
      report(channel);
    } else {
      capacitor.volts = input.volts;
    }
  } else {
    capacitor.volts = selection == adc.bandgap_channel ? adc.bandgap_volts : 0.0;
  }
  return adc_code(capacitor.volts, adc_reference_volts(adc, multiplexer, supply_volts));
}

}  // namespace avr
}  // namespace robosim
