// Chooses the faults of a random world, at random.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim/campaign/random_worlds/random_source.h"

namespace robosim::random_worlds {

/// The possible faults, with their maximum severity; 0 = the fault never occurs. docs/reference/robots.md
/// describes each fault.
struct FaultLimits {
  int at_most = 1;               ///< maximum number of faults per run
  int from_ms = 0;               ///< first possible beginning
  int until_ms = 20'000;         ///< last possible beginning
  double sensor_offset = 0.05;   ///< share of the range from white to black, in either direction
  double sensor_noise = 0.03;    ///< standard deviation, share of the range from white to black
  std::int64_t covered_us = 0;   ///< duration for which a sensor reads black
  double motor_weakness = 0.1;   ///< share of the voltage that a motor loses
  double clock_drift_ppm = 5e3;  ///< in either direction
};

struct Fault {
  enum class Kind { offset, noisy, cover, weak, drift };
  static constexpr int kLevels = 10;

  Kind kind = Kind::offset;
  std::string part;  ///< "" for drift
  int at_ms = 0;
  int level = kLevels;    ///< severity, from 1 to kLevels (the limit)
  bool negative = false;  ///< for offset and drift
};

struct FaultPlan {
  std::vector<Fault> faults;  ///< sorted by time

  std::vector<FaultPlan> smaller() const;
  std::string script(const FaultLimits& limits) const;
};

/// The parts that may fail.
struct Breakable {
  std::vector<std::string> sensors, motors;
};
/// Draws at most `most` faults.
FaultPlan draw_up(const FaultLimits& limits, int most, const Breakable& parts, const RandomSource& rng);

}  // namespace robosim::random_worlds
