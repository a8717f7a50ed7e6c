// Tests that the explanation of a verdict names a fault that the script caused before the verdict.

#include <gmock/gmock.h>

#include "tests/support/built_in_driver.h"
#include "tests/support/one_robot.h"

namespace robosim::judge::faults_explained_test {

using testing::HasSubstr;
using testing::Not;

std::string why(const std::string& script, const char* goal = "laps:3", SimTime limit = 20 * kSecond) {
  test::BuiltInDriver driver;
  return test::OneRobot(driver, goal, script).run(limit).why;
}

TEST(FaultsExplained, TheSensorThatWasStuckWhenTheLineWasLost) {
  EXPECT_THAT(why("at 2s fault S5 stuck 1023\n"),
              testing::ContainsRegex("lost the line.* near column .*, "
                                     "[0-9.]+ s after S5 was stuck at 1023 by the "
                                     "script"));
}

TEST(FaultsExplained, NotOneThatWasOverLongBefore) {
  const std::string text = why("at 1s fault S5 stuck 1023 for 10ms\nat 5s fault right dead\n");
  EXPECT_THAT(text, HasSubstr("after right was made dead by the script"));
  EXPECT_THAT(text, Not(HasSubstr("S5")));
}

TEST(FaultsExplained, NotInARunThatReachedItsGoal) {
  EXPECT_THAT(why("at 1s fault S5 noisy 1%\n", "none", 2 * kSecond), Not(HasSubstr("script")));
}

TEST(FaultsExplained, NoneWhereTheScriptBrokeNothing) {
  EXPECT_THAT(why("at 2s lift\n", "laps:1", 5 * kSecond), Not(HasSubstr("by the script")));
}

}  // namespace robosim::judge::faults_explained_test
