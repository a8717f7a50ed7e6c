// A deadline that breaks when millis() or micros() goes back to 0.
//
//   if (millis() > next) { next = millis() + 50; steer(); }
//
// millis() is a number of 32 bits: after 49.7 days it goes from 4294967295 to 0, micros() after 71.6 minutes.
// A moment that was reckoned before, `next`, is then 50 ms behind 0 already, so that it is passed at once; or
// millis() is behind it for the next 49 days, and steer() is called no more.
//
// So the run is made again with a clock that goes back to 0 on the way, and once more with one that stands
// nearly as high and does not. Where these two differ from there on (another verdict, another way in the next
// 2 s, a pin that changes no more), the sketch is not made for it. Which line ran far more often, or no more,
// is found by counting lines. A robot that parts by a microsecond more or less does so with other clocks that
// pass nothing, or where its clock has a digit or a bit more. Nothing is reported of such a sketch.
//
// The moments that are tried are the middle of the run, and those at which the sketch has just driven a pin
// and then drives none for long, as while it waits. What it cannot see: deadlines that are pending at none of
// them; variables of 16 bits; sketches that look at how long they have been on, or send their clock (in
// microseconds to minutes) among 64 bytes and more each second: its digits are fewer from there on.
//
// Mended by comparing durations, which are right across 0: millis() - start >= 50, both `unsigned long`.
#pragma once

#include <vector>

#include "sim/client/runner.h"
#include "sim/wire/messages.h"

namespace robosim::cli {

/// `request`: of the sketch as it is flashed, on an AVR; `first`: what it came to. Empty if nothing was
/// found.
std::vector<wire::Detected> look_at_wrap(client::Runner& runner, wire::RunRequest request,
                                         const wire::RunResult& first);

}  // namespace robosim::cli
