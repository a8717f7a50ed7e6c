// Measures success rates: many runs that differ only in their seed.
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

/// The share of the runs that must succeed. A plain number means at_least().
struct MinimumRate {
  constexpr MinimumRate(double least, bool surely = false)  // NOLINT(google-explicit-constructor)
      : rate(least), sure(surely) {}
  double rate;
  bool sure;
};
/// Requires that at least the share `rate` of the tested seeds succeeds.
constexpr MinimumRate at_least(double rate) { return {rate, false}; }
/// Requires that the tested seeds prove `rate` for all possible seeds, at 95 % confidence. The lower end of
/// Wilson's interval must reach the rate. This needs more runs: 381 without a failure for 0.99.
constexpr MinimumRate surely_at_least(double rate) { return {rate, true}; }

/// Runs a trial to its verdict with each of the seeds. Passes if the share of runs that reach the goal meets
/// `least`. Stops as soon as the result is certain. A failure prints the failed seeds with the reasons, and
/// the interval of the true rate (Wilson's, 95 %). It also prints the command that replays the first failed
/// run.
///
/// The environment variable ROBOSIM_JOBS=N runs N trials at a time (default: the number of processors), with
/// the same result. Throws the same exceptions as Simulation, and InputError if these seeds are too few to
/// prove the rate.
::testing::AssertionResult success_rate(const Trial& trial, MinimumRate least,
                                        const std::vector<std::uint64_t>& seeds);

}  // namespace robosim::testing

#define EXPECT_SUCCESS_RATE(trial, least, seeds) \
  EXPECT_TRUE(::robosim::testing::success_rate(trial, least, seeds))
#define ASSERT_SUCCESS_RATE(trial, least, seeds) \
  ASSERT_TRUE(::robosim::testing::success_rate(trial, least, seeds))
