// Detects deadlines that break when millis() or micros() wraps to 0.
//
//   if (millis() > next) { next = millis() + 50; steer(); }
//
// millis() is a 32-bit number: after 49.7 days it goes from 4294967295 to 0. micros() wraps after 71.6
// minutes. If `next` is computed just before the wrap, it may wrap as well, and the deadline passes at once.
// Or `next` does not wrap: then millis() is less than `next` for 49 days, and steer() is not called.
//
// The detector repeats the run twice. In one run, the clock wraps to 0. In the other run, the clock is nearly
// as high and does not wrap. If these two runs differ after the wrap, the sketch does not handle the wrap. A
// difference is another verdict, another path in the next 2 s, or a pin that stops changing. Line counts show
// which line ran far more often, or stopped running. The runs of some sketches also differ with other clocks
// that do not wrap: a microsecond changes the robot's path. Nothing is reported for such sketches.
//
// The clock wraps in the middle of the run, or after a pin change that precedes a long pause. The detector
// misses wraps of 16-bit variables, and deadlines that are not pending at any of these moments. It skips
// sketches whose behaviour depends on the time since power-on. It also skips sketches that send 64 or more
// bytes per second, including their clock in any unit from microseconds to minutes. After the wrap, such a
// sketch sends fewer digits, which takes less time.
//
// To fix such a sketch, compare durations, which are correct across 0: millis() - start >= 50, with an
// `unsigned long` start.
#pragma once

#include <vector>

#include "sim/launch/client/runner.h"
#include "sim/wire/messages.h"

namespace robosim::campaign {

/// Returns the findings. `request` describes the run of the sketch as flashed, on an AVR. `first` is its
/// result.
std::vector<result::Detected> detect_clock_wrap(client::Runner& runner, wire::RunRequest request,
                                                const result::RunResult& first);

}  // namespace robosim::campaign
