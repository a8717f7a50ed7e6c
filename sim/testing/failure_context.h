// Reports the robots' state when an unrelated expectation fails, such as EXPECT_EQ(robot.station(), "3").
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "sim/testing/run_log.h"

namespace robosim::testing {

/// A run that the test is driving. Meanwhile each failure that does not mention a run is followed by
/// state_at_failure(), but only once until something changes.
class FailureContext {
 public:
  explicit FailureContext(std::shared_ptr<const RunLog> log);
  ~FailureContext();
  FailureContext(const FailureContext&) = delete;
  FailureContext& operator=(const FailureContext&) = delete;

 private:
  std::shared_ptr<const RunLog> log_;
};

/// Describes each such run like a failed matcher: the robot, the last events, its place, the command that
/// replays it. Returns "" if the failure mentions a run itself, or there is none.
std::string state_at_failure(const ::testing::TestPartResult& failure);

}  // namespace robosim::testing
