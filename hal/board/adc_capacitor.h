// The capacitor on which an AVR's converter holds what it converts (ATmega328P, DS40002061B, 24.6.1 and
// figure 24-8): 14 pF behind a resistance that the data sheet gives as 1 to 100 kOhm; here it is 10. What is
// wired to the pin must charge it from the voltage of the channel before:
//
//   tau = 14 pF (10 kOhm + source)        left of the old voltage: e^(-t / tau)
//
// t runs from when the channel was selected, but not before the end of the conversion before, to the
// sample: in analogRead() on an Uno 12 to 20 us. So up to some 100 kOhm nothing is left; of 1 MOhm 24 to 43
// %. A source that does not say its resistance has none that counts.
#pragma once

namespace robosim {

constexpr double kAdcFarads = 14e-12, kAdcOhms = 10e3;

/// e^-x for x from 0 on, within 1e-5.
constexpr double adc_decay_16(double part) {
  return 1.0 / (1.0 + part * (1.0 + part / 2.0 * (1.0 + part / 3.0 * (1.0 + part / 4.0))));
}
constexpr double adc_square(double x) { return x * x; }
constexpr double adc_decay(double x) {
  return adc_square(adc_square(adc_square(adc_square(adc_decay_16(x / 16.0)))));
}

/// What is on the capacitor, in volts, when a source of `volts` has charged it for `seconds`.
constexpr double adc_charged(double before, double volts, double source_ohms, double seconds) {
  return volts + (before - volts) *
                     adc_decay((seconds > 0.0 ? seconds : 0.0) / (kAdcFarads * (kAdcOhms + source_ohms)));
}

}  // namespace robosim
