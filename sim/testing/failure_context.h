// Reports the robots' state when an expectation without a matcher of this library fails, such as
// EXPECT_EQ(robot.station(), "3").
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "sim/testing/run_log.h"

namespace robosim::testing {

/// A run that the test is driving. While this object exists, state_at_failure() is printed after each failure
/// that does not mention a run. Equal states are printed only once.
class FailureContext {
 public:
  explicit FailureContext(std::shared_ptr<const RunLog> log);
  ~FailureContext();
  FailureContext(const FailureContext&) = delete;
  FailureContext& operator=(const FailureContext&) = delete;

 private:
  std::shared_ptr<const RunLog> log_;
};

/// Describes each driven run as a failed matcher would: robot, last events, position, and the replay command.
/// Returns "" if the failure's message already mentions a run, or if no run is driven.
std::string state_at_failure(const ::testing::TestPartResult& failure);

}  // namespace robosim::testing
