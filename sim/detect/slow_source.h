// Finds an analog pin whose voltage source has too high an impedance for the ADC. The voltage of the
// previously read pin distorts the readings of such a pin.
//
//   left = analogRead(A0);  right = analogRead(A1);        // A1: a photo diode with 2.2 MOhm to 5 V
//
// "The ADC is optimized for analog signals with an output impedance of approximately 10 kOhm or less"
// (ATmega328P, DS40002061B, 24.6.1). A source of higher impedance does not charge the ADC's capacitor in time
// (hal/board/adc_capacitor.h). A finding is a pin with at least three readings that
//
//   - are wrong by 0.8 % of the supply voltage (8 of 1024) or more for this reason, and
//   - are each followed by a reading of another pin. Therefore sketches that average readings, or that read
//     twice and drop the first reading, are not reported.
//
// Only sources with `source_ohms` in the robot file are examined. To fix a finding, read the pin twice, add
// 100 nF to ground, or use a source of lower resistance.
#pragma once

#include <vector>

#include "sim/detect/firmware_detector.h"

namespace robosim::detect {

class SlowSource final : public FirmwareDetector, public AdcWatcher {
 public:
  SlowSource(exec::Executor& executor, SnapshotRegistry& snapshots);

  void converted(Pin pin, double volts, SimTime t) override;
  std::vector<exec::Detected> found(SimTime) const override;

 private:
  struct Reading {
    Pin pin = kNoPin;
    double volts = 0.0;  ///< error of the reading; positive if the reading was too high
    SimTime at = 0;
  };
  struct Found {
    Reading worst;
    SimTime first = 0;
    std::int64_t times = 0;
    exec::SourceLine where;
  };
  struct State {
    Reading last;              ///< the last reading; `last.pin` is kNoPin if the reading was correct
    std::vector<Found> found;  ///< one element for each pin with a wrong reading
  };
  Found& of(const Reading& reading);

  exec::Executor& executor_;
  State state_;
};

}  // namespace robosim::detect
