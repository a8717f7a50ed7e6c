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
// Only sources with `source_ohms` in the robot file are examined. The ADC reports its readings
// (FirmwareAction::Kind::conversion). To fix a finding, read the pin twice, add 100 nF to ground, or use a
// source of lower resistance.
#pragma once

#include <functional>
#include <vector>

#include "hal/board/board_spec.h"
#include "sim/result/run_result.h"

namespace robosim::detect {

class SlowSource {
 public:
  explicit SlowSource(const BoardSpec& board) : board_(&board) {}

  using Where = std::function<result::SourceLine()>;

  /// Examines a reading of `pin` at `t`, which was wrong by `volts`.
  void converted(Pin pin, double volts, SimTime t, const Where& where);
  std::vector<result::Detected> found() const;

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
    result::SourceLine where;
  };
  Found& of(const Reading& reading, const Where& where);

  const BoardSpec* board_;
  Reading last_;              ///< the last reading; `last_.pin` is kNoPin if the reading was correct
  std::vector<Found> found_;  ///< one element for each pin with a wrong reading
};

}  // namespace robosim::detect
