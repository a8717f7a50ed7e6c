// Detects deadlines that break when millis() or micros() wraps to 0.
//
//   if (millis() > next) { next = millis() + 50; steer(); }
//
// millis() is a number of 32 bits: after 49.7 days it goes from 4294967295 to 0, micros() after 71.6 minutes.
// A deadline computed before, `next`, may already be 50 ms after 0, so that it is passed at once. Or millis()
// is after it for the next 49 days, and steer() is never called.
//
// So the run is repeated with a clock that wraps to 0 during it. Another run has a clock that is nearly as
// high and does not wrap. If these two differ from there on, the sketch cannot handle a wrap. A difference is
// another verdict, another path in the next 2 s, or a pin that stops changing. Line counts show which line
// ran far more often, or stopped running. If a microsecond changes a robot's path, it also differs with
// clocks that pass no wrap or gain a digit. Nothing is reported for such a sketch.
//
// The tested moments are the middle of the run, and moments after which the sketch drives no pin for long.
// Not detected: deadlines that are pending at none of them; variables of 16 bits. Nor sketches that use the
// time since power-on itself, or that send their clock (in microseconds to minutes) among 64 or more bytes
// per second. It has fewer digits after the wrap.
//
// Fix it by comparing durations, which are correct across 0: millis() - start >= 50, both `unsigned long`.
#pragma once

#include <vector>

#include "sim/client/runner.h"
#include "sim/wire/messages.h"

namespace robosim::cli {

/// Returns the findings; empty if there are none. `request`: of the sketch as it is flashed, on an AVR;
/// `first`: its result.
std::vector<wire::Detected> detect_clock_wrap(client::Runner& runner, wire::RunRequest request,
                                              const wire::RunResult& first);

}  // namespace robosim::cli
