// Tests the verdict of runs on target avr that exceed a budget of the robot file.
#include <gmock/gmock.h>

#include "sim/exec/avr/avr_executor.h"
#include "tests/support/noted_run.h"
#include "tests/support/one_robot.h"
#include "tests/support/require_target.h"

namespace robosim::run::budget_test {

using testing::HasSubstr;

class Budgets : public testing::Test {
 protected:
  void SetUp() override { ROBOSIM_NEEDS_TARGET("avr"); }
  /// Runs PidFollower for 2 s on a robot with this budget. Returns the outcome.
  static judge::Outcome outcome(const robot::Budget& budget) {
    const StockRun follower{"PidFollower", "uno5", "oval", 2 * kSecond};
    exec::AvrExecutor executor(*find_board("uno"), NotedRun::image_of(follower, "avr"));
    test::OneRobot one(executor);
    one.robot.budget = budget;
    return one.run(follower.limit);
  }
};

TEST_F(Budgets, OfTheStackEndsARunThatExceedsIt) {
  const judge::Outcome over = outcome({.stack_bytes = 20});
  EXPECT_EQ(over.verdict, judge::Verdict::over_budget);
  EXPECT_THAT(over.why, testing::MatchesRegex("The sketch is over its budget: its stack took [0-9]+ bytes, "
                                              "but the robot file allows 20 .*"));
  EXPECT_EQ(outcome({.stack_bytes = 1000}).verdict, judge::Verdict::reached);
}

TEST_F(Budgets, OfAPassOfLoopEndsARunThatExceedsIt) {
  const judge::Outcome over = outcome({.loop_s = 0.0055});
  EXPECT_EQ(over.verdict, judge::Verdict::over_budget);
  EXPECT_THAT(over.why, HasSubstr("a pass of loop() took "));
  EXPECT_THAT(over.why, HasSubstr(" ms, but the robot file allows 5.500 ms"));
  EXPECT_EQ(outcome({.loop_s = 0.02}).verdict, judge::Verdict::reached);
}

}  // namespace robosim::run::budget_test
