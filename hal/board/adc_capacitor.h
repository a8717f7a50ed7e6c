// Models the sample-and-hold capacitor of an AVR's ADC (ATmega328P, DS40002061B, 24.6.1 and figure 24-8). The
// capacitor has 14 pF. Its series resistance is 1 to 100 kOhm by the data sheet, and 10 kOhm in this model.
// The source at the pin charges the capacitor, which starts at the voltage of the previous channel:
//
//   tau = 14 pF (10 kOhm + source)        e^(-t / tau) of the old voltage remains
//
// t is the time from the selection of the channel to the sample. If the previous conversion ends later than
// the selection, t begins at that end. In analogRead() on an Uno, t is 12 to 20 us. With a source of up to
// about 100 kOhm, nothing of the old voltage remains. With 1 MOhm, 24 to 43 % remain. A source whose
// resistance is not stated counts as 0 Ohm.
#pragma once

namespace robosim {

constexpr double kAdcFarads = 14e-12, kAdcOhms = 10e3;

/// Returns an approximation of e^-part for a small `part` >= 0. adc_decay() returns the 16th power of the
/// approximation, which is accurate within 1e-5.
constexpr double adc_decay_16(double part) {
  return 1.0 / (1.0 + part * (1.0 + part / 2.0 * (1.0 + part / 3.0 * (1.0 + part / 4.0))));
}
constexpr double adc_square(double x) { return x * x; }
constexpr double adc_decay(double x) {
  return adc_square(adc_square(adc_square(adc_square(adc_decay_16(x / 16.0)))));
}

/// Returns the capacitor's voltage after a source of `volts` has charged the capacitor for `seconds`,
/// starting at the voltage `before`.
constexpr double adc_charged(double before, double volts, double source_ohms, double seconds) {
  return volts + (before - volts) *
                     adc_decay((seconds > 0.0 ? seconds : 0.0) / (kAdcFarads * (kAdcOhms + source_ohms)));
}

}  // namespace robosim
