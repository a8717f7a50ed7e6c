// Where robots are when an expectation fails that knows nothing of them: EXPECT_EQ(robot.station(), "3").
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "sim/testing/run_log.h"

namespace robosim::testing {

/// A run whose robot is in the test's hands. While it is, each failure that does not tell of a run is
/// followed by what robots_then() says; once where nothing has changed since the last.
class Standing {
 public:
  explicit Standing(std::shared_ptr<const RunLog> log);
  ~Standing();
  Standing(const Standing&) = delete;
  Standing& operator=(const Standing&) = delete;

 private:
  std::shared_ptr<const RunLog> log_;
};

/// Of each standing run, as a failed matcher tells it: the robot, the last events, where it is, the command
/// that replays it. "" if the failure tells of a run itself, or there is none.
std::string robots_then(const ::testing::TestPartResult& failure);

}  // namespace robosim::testing
