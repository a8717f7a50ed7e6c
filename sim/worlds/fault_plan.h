// What breaks in a random world.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim/worlds/die.h"

namespace robosim::worlds {

/// What may break, and how badly at most; 0 = never. docs/reference/robots.md says what each does.
struct FaultLimits {
  int at_most = 1;               ///< in a run
  int from_ms = 0;               ///< they begin between these times
  int until_ms = 20'000;         ///<
  double sensor_offset = 0.05;   ///< share of white to black, either way
  double sensor_noise = 0.03;    ///< standard deviation, a share of white to black
  std::int64_t covered_us = 0;   ///< a sensor sees black for so long
  double motor_weakness = 0.1;   ///< share of the voltage that a motor lacks
  double clock_drift_ppm = 5e3;  ///< either way
};

struct Fault {
  enum class Kind { offset, noisy, cover, weak, drift };
  static constexpr int kLevels = 10;

  Kind kind = Kind::offset;
  std::string part;  ///< "" for drift
  int at_ms = 0;
  int level = kLevels;    ///< how bad, from 1 to kLevels: as bad as the limits allow
  bool negative = false;  ///< offset, drift
};

struct FaultPlan {
  std::vector<Fault> faults;  ///< in the order of time

  std::vector<FaultPlan> smaller() const;
  std::string script(const FaultLimits& limits) const;
};

/// What may break.
struct Breakable {
  std::vector<std::string> sensors, motors;
};
/// At most so many faults.
FaultPlan draw_up(const FaultLimits& limits, int most, const Breakable& parts, const Die& die);

}  // namespace robosim::worlds
