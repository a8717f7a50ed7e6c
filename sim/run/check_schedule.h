// Schedules the checks of an agent that only some ticks need.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "hal/board/sim_time.h"

namespace robosim::run {

constexpr SimTime kRestSpan = 20 * kMillisecond;  ///< period in which an agent runs each of its checks
constexpr int kSensorCheckEvery = 4;              ///< ticks between two checks of all sensors
constexpr int kSideCheckEvery = 10;               ///< ticks between two checks of the line's side

/// The checks that are due at the end of a tick.
struct DueChecks {
  bool at_sensors, aside;
  int next;  ///< number of ticks until the next check
};

/// The checks for each tick of a period of kRestSpan: 6 of its 20 ticks have checks. Reading this table is
/// faster than computing several remainders.
constexpr auto kCheckSchedule = [] {
  std::array<DueChecks, kRestSpan / kTick> looks{};
  static_assert(looks.size() % kSensorCheckEvery == 0 && looks.size() % kSideCheckEvery == 0);
  for (int i = 0; i < static_cast<int>(looks.size()); ++i) {
    const auto after = [i](int every) { return every - i % every; };
    looks[static_cast<std::size_t>(i)] = {i % kSensorCheckEvery == 0, i % kSideCheckEvery == 0,
                                          std::min(after(kSensorCheckEvery), after(kSideCheckEvery))};
  }
  return looks;
}();

inline const DueChecks& checks_at(SimTime end) {
  return kCheckSchedule[static_cast<std::uint64_t>(end / kTick) % kCheckSchedule.size()];
}

}  // namespace robosim::run
