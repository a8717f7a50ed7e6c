// A pin whose source is too weak for the ADC: what was read before is still in the reading.
//
//   left = analogRead(A0);  right = analogRead(A1);        A1: a photo diode with 2.2 MOhm to 5 V
//
// "The ADC is optimized for analog signals with an output impedance of approximately 10 kOhm or less"
// (ATmega328P, DS40002061B, 24.6.1): more of it does not charge the converter's capacitor in time
// (hal/board/adc_capacitor.h). What is found are readings
//
//   that are off by 0.8 % of the supply (8 of 1024) or more, for this reason,
//   three times or more, of the same pin,
//   and behind each of which another pin is read: who reads twice and drops the first one is not told of,
//   nor who averages.
//
// It knows only sources whose `source_ohms` the robot file says. Mended by a second reading, 100 nF between
// the pin and ground, or a source of less resistance.
#pragma once

#include <vector>

#include "sim/exec/core/executor.h"

namespace robosim::judge {

class SlowSource {
 public:
  explicit SlowSource(const BoardSpec& board) : board_(&board) {}

  /// Of every pin that is converted, while `executor` runs: RobotPort::watch_adc.
  void converted(Pin pin, double volts, SimTime t, exec::Executor& executor);
  std::vector<exec::Detected> found() const;

 private:
  struct Reading {
    Pin pin = kNoPin;
    double volts = 0.0;  ///< that it is off by
    SimTime at = 0;
  };
  struct Found {
    Reading worst;
    SimTime first = 0;
    std::int64_t times = 0;
    exec::SourceLine where;
  };
  Found& of(const Reading& reading, exec::Executor& executor);

  const BoardSpec* board_;
  Reading last_;              ///< kNoPin = it was good
  std::vector<Found> found_;  ///< by pin
};

}  // namespace robosim::judge
