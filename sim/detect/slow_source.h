// Finds a pin whose source is too weak for the ADC. The voltage of the previous pin then distorts its
// readings.
//
//   left = analogRead(A0);  right = analogRead(A1);        // A1: a photo diode with 2.2 MOhm to 5 V
//
// "The ADC is optimized for analog signals with an output impedance of approximately 10 kOhm or less"
// (ATmega328P, DS40002061B, 24.6.1): a source of higher impedance does not charge the converter's capacitor
// in time (hal/board/adc_capacitor.h). A finding consists of readings of one pin that
//
//   - are off by 0.8 % of the supply (8 of 1024) or more for this reason,
//   - occur three times or more,
//   - and are each followed by a reading of another pin. Sketches that average, or that read twice and drop
//     the first reading, are not reported.
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
    double volts = 0.0;  ///< error of the reading
    SimTime at = 0;
  };
  struct Found {
    Reading worst;
    SimTime first = 0;
    std::int64_t times = 0;
    exec::SourceLine where;
  };
  struct State {
    Reading last;              ///< the last reading; its pin is kNoPin if it was correct
    std::vector<Found> found;  ///< by pin
  };
  Found& of(const Reading& reading);

  exec::Executor& executor_;
  State state_;
};

}  // namespace robosim::detect
