// Models the sample-and-hold capacitor of an AVR's ADC (ATmega328P, DS40002061B, 24.6.1 and figure 24-8):
// 14 pF in series with 1 to 100 kOhm by the data sheet, and with 10 kOhm here. The source at the pin must
// charge the capacitor from the voltage of the previous channel:
//
//   tau = 14 pF (10 kOhm + source)        e^(-t / tau) of the old voltage remains
//
// t runs from the selection of the channel to the sample, but starts no earlier than the end of the previous
// conversion. In analogRead() on an Uno, t is 12 to 20 us. Up to some 100 kOhm nothing remains; at 1 MOhm,
// 24 to 43 % remain. A source without a stated resistance counts as 0 Ohm.
#pragma once

namespace robosim {

constexpr double kAdcFarads = 14e-12, kAdcOhms = 10e3;

/// Returns e^-x for a small x = `part` >= 0. Its 16th power, adc_decay(), is accurate within 1e-5.
constexpr double adc_decay_16(double part) {
  return 1.0 / (1.0 + part * (1.0 + part / 2.0 * (1.0 + part / 3.0 * (1.0 + part / 4.0))));
}
constexpr double adc_square(double x) { return x * x; }
constexpr double adc_decay(double x) {
  return adc_square(adc_square(adc_square(adc_square(adc_decay_16(x / 16.0)))));
}

/// Returns the capacitor's voltage after a source of `volts` has charged it for `seconds`.
constexpr double adc_charged(double before, double volts, double source_ohms, double seconds) {
  return volts + (before - volts) *
                     adc_decay((seconds > 0.0 ? seconds : 0.0) / (kAdcFarads * (kAdcOhms + source_ohms)));
}

}  // namespace robosim
