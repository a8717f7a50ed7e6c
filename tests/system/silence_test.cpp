// Tests sketches that call nothing for a long time. Waiting sketches continue, hanging sketches are reported.

#include "tests/system/system_test.h"

namespace robosim::test {
namespace silence_test {

using testing::AllOf;
using testing::HasSubstr;

class Silence : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override { needs_target(GetParam()); }
  result::RunResult run_for(const std::string& sketch, double seconds, const std::string& script = "",
                            const std::string& robot = "uno5") {
    return run({.sketch = sketch,
                .robot = robot,
                .goal = "none",
                .script = script,
                .for_s = seconds,
                .target = GetParam()});
  }
  static std::string robot_of(const std::string& sketch) {
    return (sketch_folder(sketch) / "robot.toml").string();
  }
};
INSTANTIATE_TEST_SUITE_P(On, Silence, testing::Values("host", "avr", "stm32"),
                         [](const auto& target) { return target.param; });

TEST_P(Silence, ABusyWaitForAFlagGoesOnWhenTheInterruptSetsIt) {
  const result::RunResult pressed = run_for("WaitsForFlag", 6.0, "at 5s press go", robot_of("WaitsForFlag"));
  EXPECT_EQ(pressed.verdict, "reached") << pressed.why;
  EXPECT_EQ(pressed.serial, "went on\r\n");
}

TEST_P(Silence, AWaitThatNobodyEndsRunsOutOfTimeAndTellsWhereItIs) {
  const result::RunResult r = run({.sketch = "WaitsForFlag",
                                   .robot = robot_of("WaitsForFlag"),
                                   .goal = "laps:1",
                                   .for_s = 6.0,
                                   .target = GetParam()});
  EXPECT_EQ(r.verdict, "timeout");
  EXPECT_THAT(r.why,
              AllOf(HasSubstr(std::string(GetParam()) == "host"
                                  ? "has called no Arduino function since 0.0"
                                  : "has used no pin, timer or interface, except in interrupts, since 0.0"),
                    HasSubstr("in setup, WaitsForFlag.ino:10")));
}

TEST_P(Silence, AWaitForEncoderTicksWhileDrivingIsNoHang) {
  const result::RunResult r = run_for("CountsWhileDriving", 20.0);
  EXPECT_EQ(r.verdict, "reached") << r.why;
  EXPECT_EQ(r.serial, "counted\r\n");
}

TEST_P(Silence, ALoopThatReadsACountWithInterruptsOffIsNoHang) {
  const result::RunResult r = run_for("CountsAtomically", 20.0);
  EXPECT_EQ(r.verdict, "reached") << r.why;
  EXPECT_EQ(r.serial, "counted\r\n");
}

TEST_P(Silence, AHandlerThatLooksAtAPinIsLifeEvenWhileItRuns) {
  if (GetParam() == std::string("stm32")) GTEST_SKIP() << "the sketch writes registers of an AVR";
  const result::RunResult r = run_for("LooksInHandler", 14.0, "at 12s press start 100ms");
  EXPECT_EQ(r.verdict, "reached") << r.why;
  EXPECT_THAT(r.serial, HasSubstr("seen"));
}

TEST_P(Silence, AWaitForAByteIsNoEnd) {
  const result::RunResult r = run_for("WaitsForByte", 6.0, "at 5s send \"g\"");
  EXPECT_EQ(r.verdict, "reached") << r.why;
  EXPECT_EQ(r.serial, "heard\r\n");
}

TEST_P(Silence, ATimerThatDoesEverythingUnderAnEmptyLoopIsLife) {
  if (GetParam() == std::string("stm32")) GTEST_SKIP() << "the sketch writes registers of an AVR";
  const result::RunResult r = run_for("TimerDrives", 6.0);
  EXPECT_EQ(r.verdict, "reached") << r.why;
  EXPECT_EQ(r.serial, "drove\r\n");
  EXPECT_GT(r.metrics.distance_m, 0.2);
}

TEST_P(Silence, AHangIsToldThoughTheClockAndSerialInterrupt) {
  EXPECT_EQ(run_for("HangsDriving", 60.0).verdict, "hung");
  EXPECT_EQ(run_for("EndsParked", 60.0).verdict, "ended");
  EXPECT_EQ(run_for("NobodySets", 60.0).verdict, "ended");
  const result::RunResult rests = run_for("SaysAndRests", 60.0);
  EXPECT_EQ(rests.verdict, "ended");
  EXPECT_LT(rests.time_s, 2.1);
}

}  // namespace silence_test
}  // namespace robosim::test
