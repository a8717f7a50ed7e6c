// Tests power cuts at every EEPROM write of a sketch that writes two bytes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <robosim/testing.h>

#include <set>

#include "tests/support/caught_failures.h"

namespace power_cuts_test {

using namespace robosim::testing;
using robosim::test::caught_failures;
using testing::ElementsAre;
using testing::HasSubstr;

Trial diary() { return {.sketch = SYSTEM_SKETCHES "/Diary"}; }

TEST(AtEveryPowerCut, RunsTheTrialAsItIsAndThenWithThreeCutsOfEachByte) {
  std::vector<std::string> scripts;
  Trial trial = diary();
  trial.script = "at 1ms send \"x\"";
  AtEveryPowerCut(trial, [&](Simulation& robot) {
    robot.run_for(100_ms);
    scripts.push_back(robot.trial().script.substr(trial.script.size()));
  });
  EXPECT_THAT(scripts, ElementsAre("", "\nafter eeprom 1 power off for 20ms byte old\n",
                                   "\nafter eeprom 1 power off for 20ms byte erased\n",
                                   "\nafter eeprom 1 power off for 20ms byte new\n",
                                   "\nafter eeprom 2 power off for 20ms byte old\n",
                                   "\nafter eeprom 2 power off for 20ms byte erased\n",
                                   "\nafter eeprom 2 power off for 20ms byte new\n"));
}

TEST(AtEveryPowerCut, LeavesTheByteOldErasedOrNew) {
  // All bytes of a new EEPROM are 255. The sketch writes 0 to two bytes.
  std::vector<std::string> second_starts;
  AtEveryPowerCut(diary(), [&](Simulation& robot) {
    robot.run_for(100_ms);
    const std::size_t again = robot.serial().find("was", 1);
    second_starts.push_back(again == std::string::npos ? "none" : robot.serial().substr(again));
  });
  EXPECT_THAT(second_starts, ElementsAre("none", "was 255 255\r\n", "was 255 255\r\n", "was 0 255\r\n",
                                         "was 0 255\r\n", "was 0 255\r\n", "was 0 0\r\n"));
}

TEST(AtEveryPowerCut, EndsWithTheFirstRunThatFailsAndNamesTheWrite) {
  int runs = 0;
  const std::vector<std::string> failures = caught_failures([&] {
    AtEveryPowerCut(diary(), [&](Simulation& robot) {
      ++runs;
      robot.run_for(100_ms);
      EXPECT_THAT(robot.serial(), Not(HasSubstr("was 0")));
    });
  });
  ASSERT_EQ(failures.size(), 1u);
  EXPECT_THAT(failures[0],
              HasSubstr("in a run with a power cut during write 1 to the EEPROM, its byte left new"));
  EXPECT_THAT(failures[0], HasSubstr(", with the command that replays it"));
  EXPECT_EQ(runs, 1 + 3 + 1) << "the failing run is repeated to report it";
}

TEST(AtEveryPowerCut, FailsWithoutACutIfTheBodyDoes) {
  const std::vector<std::string> failures =
      caught_failures([] { AtEveryPowerCut(diary(), [](Simulation& robot) { robot.press("nose"); }); });
  ASSERT_EQ(failures.size(), 1u);
  EXPECT_THAT(failures[0], HasSubstr("nose"));
  EXPECT_THAT(failures[0], HasSubstr("in a run without a power cut"));
  EXPECT_THAT(failures[0], HasSubstr(", with the command that replays it"));
}

TEST(AtEveryPowerCut, FailsIfNothingIsWritten) {
  const std::vector<std::string> failures = caught_failures(
      [] { AtEveryPowerCut({.sketch = "PidFollower"}, [](Simulation& robot) { robot.run_for(10_ms); }); });
  EXPECT_THAT(failures, ElementsAre(AllOf(HasSubstr("the sketch wrote nothing to its EEPROM"),
                                          HasSubstr(", with the command that replays it"))));
}

}  // namespace power_cuts_test
