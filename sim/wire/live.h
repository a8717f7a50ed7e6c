// Defines the requests that a run in step with the wall clock (`robosim run --live`) accepts at any time. The
// answers are those of a run that is driven step by step (driven.h).
#pragma once

#include <cstdint>
#include <variant>

#include "sim/wire/driven.h"

namespace robosim::wire {

/// Continues until the next request.
struct Play {
  static constexpr const char* kDo = "play";
  double speed = 1.0;
};

template <class V>
void fields(V& v, Same<V, Play>& p) {
  v("speed", p.speed, "simulated seconds per second of wall time; 0 = as fast as possible",
    {.presence = kOptional});
}

/// Pauses the run.
struct Pause {
  static constexpr const char* kDo = "pause";
};
template <class V>
void fields(V&, Same<V, Pause>&) {}

/// Continues for this duration, then pauses.
struct StepOn {
  static constexpr const char* kDo = "step";
  std::int64_t ms = 1;
};

template <class V>
void fields(V& v, Same<V, StepOn>& s) {
  v("ms", s.ms, "simulated time for which the run continues",
    {.unit = "ms", .presence = kOptional, .least = 1, .most = 3'600'000});
}

using LiveRequest = std::variant<Play, Pause, StepOn, Act, End>;

}  // namespace robosim::wire
