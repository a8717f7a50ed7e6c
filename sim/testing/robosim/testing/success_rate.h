// Success rates: many runs that differ only in their seed.
//
//   const Trial laps{.sketch = "MyFollower", .map = "oval", .goal = "laps:2"};
//   EXPECT_SUCCESS_RATE(laps, at_least(0.99), seeds(1000));
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "robosim/testing/parameters.h"
#include "robosim/testing/simulation.h"

namespace robosim::testing {

/// The share of the runs that must succeed; a bare number means at_least().
struct MinimumRate {
  constexpr MinimumRate(double least, bool surely = false)  // NOLINT(google-explicit-constructor)
      : rate(least), sure(surely) {}
  double rate;
  bool sure;
};
/// Requires this share of exactly these seeds.
constexpr MinimumRate at_least(double rate) { return {rate, false}; }
/// Requires these seeds to show, at 95 % confidence, this rate for all seeds: the lower end of Wilson's
/// interval counts. It takes more runs: 381 without a failure for 0.99.
constexpr MinimumRate surely_at_least(double rate) { return {rate, true}; }

/// Runs a trial with each of the seeds to its verdict. Passes if at least this share of the runs reaches
/// its goal. Stops as soon as the result is certain. A failure prints which seeds failed and how, the
/// interval of the true rate (Wilson's, 95 %), and the command that replays the first one.
///
/// ROBOSIM_JOBS=N runs N at a time (default: the number of processors); the result is the same. Throws as
/// Simulation does, and for a rate that these seeds are too few to show.
::testing::AssertionResult success_rate(const Trial& trial, MinimumRate least,
                                        const std::vector<std::uint64_t>& seeds);

}  // namespace robosim::testing

#define EXPECT_SUCCESS_RATE(trial, least, seeds) \
  EXPECT_TRUE(::robosim::testing::success_rate(trial, least, seeds))
#define ASSERT_SUCCESS_RATE(trial, least, seeds) \
  ASSERT_TRUE(::robosim::testing::success_rate(trial, least, seeds))
