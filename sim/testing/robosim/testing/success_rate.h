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

/// The share of the runs that must succeed; a bare number is at_least().
struct MinimumRate {
  constexpr MinimumRate(double least, bool surely = false)  // NOLINT(google-explicit-constructor)
      : rate(least), sure(surely) {}
  double rate;
  bool sure;
};
/// Of exactly these seeds, at least this share must succeed.
constexpr MinimumRate at_least(double rate) { return {rate, false}; }
/// These seeds must show, at 95 % confidence, that the rate of all seeds is not less: the lower end of
/// Wilson's interval counts. It takes more runs: 381 without a failure for 0.99.
constexpr MinimumRate surely_at_least(double rate) { return {rate, true}; }

/// Runs a trial with each of the seeds, to its verdict. A run succeeds if its goal is reached. Success means
/// that at least this share of the runs did; no more are made than it takes to know that. A failure says
/// which seeds failed and how, where the true rate lies (Wilson's interval, 95 %), and the command that
/// replays the first. ROBOSIM_JOBS=N makes N at a time (else as many as there are processors): the result is
/// the same. Throws as Simulation does, and for a rate that so few seeds cannot show.
::testing::AssertionResult success_rate(const Trial& trial, MinimumRate least,
                                        const std::vector<std::uint64_t>& seeds);

}  // namespace robosim::testing

#define EXPECT_SUCCESS_RATE(trial, least, seeds) \
  EXPECT_TRUE(::robosim::testing::success_rate(trial, least, seeds))
#define ASSERT_SUCCESS_RATE(trial, least, seeds) \
  ASSERT_TRUE(::robosim::testing::success_rate(trial, least, seeds))
