// Chance made testable: many runs that differ in their seed alone.
//
//   EXPECT_SUCCESS_RATE((Trial{.sketch = "MyFollower", .map = "oval", .goal = "laps:2"}), 0.99, seeds(1,
//   1000));
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "robosim/testing/parameters.h"
#include "robosim/testing/simulation.h"

namespace robosim::testing {

/// Runs a trial with each of the seeds, to its verdict. A run succeeds if its goal is reached. Success means
/// that at least this share of the runs did; no more are made than it takes to know that. A failure says
/// which seeds failed and how, where the true rate lies (Wilson's interval, 95 %), and the command that
/// replays the first. ROBOSIM_JOBS=N makes N at a time (else as many as there are processors): the result is
/// the same.
::testing::AssertionResult success_rate(const Trial& trial, double least,
                                        const std::vector<std::uint64_t>& seeds);

}  // namespace robosim::testing

#define EXPECT_SUCCESS_RATE(trial, least, seeds) \
  EXPECT_TRUE(::robosim::testing::success_rate(trial, least, seeds))
#define ASSERT_SUCCESS_RATE(trial, least, seeds) \
  ASSERT_TRUE(::robosim::testing::success_rate(trial, least, seeds))
