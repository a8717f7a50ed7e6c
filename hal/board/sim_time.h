// The simulation's only clock. Wall time is never an input to the simulation.
#pragma once

#include <stdint.h>

namespace robosim {

/// Simulated time in nanoseconds since the world's power-on; 2^63 ns are 292 years. CPU cycles are converted
/// as a total since power-on, not in increments, so that no rounding error accumulates.
using SimTime = int64_t;

constexpr SimTime kNanosecond = 1;
constexpr SimTime kMicrosecond = 1000;
constexpr SimTime kMillisecond = 1000 * kMicrosecond;
constexpr SimTime kSecond = 1000 * kMillisecond;

/// The step of the world. Firmware and world synchronise at every multiple of this step.
constexpr SimTime kTick = kMillisecond;

/// A time later than any event.
constexpr SimTime kNever = INT64_MAX;

}  // namespace robosim
