// Decodes the registers of an AVR's analog-to-digital converter (ATmega328P, data sheet DS40002061B, chapter
// 24), for the target host and for the emulated chip. avr_adc_sample.h samples a board's pins.
//
// A conversion takes 13 ADC clocks, and samples its input after 1.5 clocks. The first conversion after the
// ADC is enabled takes 25 clocks, and samples after 13.5 clocks (table 24-1). A reference is either the
// supply or the bandgap. AVCC selects the supply, and so does AREF, because the pin AREF is not wired. The
// temperature sensor, and the differential channels that some chips have, read 0.
#pragma once

#include <stdint.h>

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

/// Returns the conversion result for the input that ADMUX and ADCSRB select. `pin_volts(channel)` returns the
/// voltage of an analog input, scaled as if the supply were nominal. With the supply as reference, a drop of
/// the supply therefore cancels. With a constant reference, the voltage is multiplied by `supply_share()`,
/// the supply's share of its nominal value. `held` receives the voltage on the converter's capacitor, scaled
/// like the result of `pin_volts`.
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
