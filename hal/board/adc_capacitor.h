// Models the sample-and-hold capacitor of an AVR's ADC (ATmega328P, DS40002061B, 24.6.1 and figure 24-8). The
// capacitor has 14 pF. Its series resistance is 1 to 100 kOhm by the data sheet, and 10 kOhm in this model.
// The source at the pin charges the capacitor, which starts at the voltage of the previous channel:
//
//   tau = 14 pF (10 kOhm + source)        e^(-t / tau) of the old voltage remains
//
// t is the time from the selection of the channel to the sample. If the previous conversion ends later than
// the selection, t begins at that end. In analogRead() on an Uno, t is 12 to 20 us. With a source of up to
// about 100 kOhm, nothing of the old voltage remains. With 1 MOhm, 24 to 43 % remain. A Source
// (board.h) has 0 Ohm unless it states a resistance.
#pragma once

#include "hal/board/board.h"

namespace robosim {

constexpr double kAdcFarads = 14e-12, kAdcOhms = 10e3;

/// Returns an approximation of e^-part for a small `part` >= 0. adc_decay() raises it to the 16th power. The
/// result of adc_decay() is accurate within 1e-5.
constexpr double adc_decay_16(double part) {
  return 1.0 / (1.0 + part * (1.0 + part / 2.0 * (1.0 + part / 3.0 * (1.0 + part / 4.0))));
}
constexpr double adc_square(double x) { return x * x; }
constexpr double adc_decay(double x) {
  return adc_square(adc_square(adc_square(adc_square(adc_decay_16(x / 16.0)))));
}

/// The capacitor at the last sample of a pin.
struct AdcCapacitor {
  double volts = 0.0;
  double error = 0.0;  ///< `volts` minus the source's voltage
  bool slow = false;   ///< the source had a resistance

  /// Charges the capacitor from `source` for `seconds`. Not inlined, because few robots have slow sources.
  __attribute__((noinline, cold)) void charge(Source source, double seconds) {
    slow = source.ohms > 0.0;
    error = slow ? (volts - source.volts) *
                       adc_decay((seconds > 0.0 ? seconds : 0.0) / (kAdcFarads * (kAdcOhms + source.ohms)))
                 : 0.0;
    volts = source.volts + error;
  }
};

}  // namespace robosim
