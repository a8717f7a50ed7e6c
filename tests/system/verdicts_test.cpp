// Tests that every failure of a sketch ends in a verdict with its cause and place.

#include "tests/system/system_test.h"

namespace robosim::test {
namespace verdicts_test {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

TEST(Verdicts, ASketchThatSpinsOnAPinRunsOutOfTimeAndNamesThePin) {
  const result::RunResult r = run({.sketch = "SpinsOnPin", .robot = "uno3", .for_s = 60.0});
  EXPECT_EQ(r.verdict, "timeout");
  EXPECT_EQ(r.status, 4);
  EXPECT_THAT(r.why, AllOf(HasSubstr("pin 2"), HasSubstr("digitalRead(2)"), HasSubstr("SpinsOnPin.ino:5"),
                           HasSubstr("HIGH")));
}

TEST(Verdicts, AnEmptyEndlessLoopHangsWithMotorsOnAndEndsWithMotorsOff) {
  const result::RunResult hung = run({.sketch = "HangsDriving"});
  EXPECT_EQ(hung.verdict, "hung");
  EXPECT_EQ(hung.status, 1);
  EXPECT_THAT(hung.why, HasSubstr("HangsDriving.ino:11"));
  const result::RunResult ended = run({.sketch = "EndsParked"});
  EXPECT_EQ(ended.verdict, "ended");
  EXPECT_THAT(ended.why, HasSubstr("EndsParked.ino:6"));
}

TEST(Verdicts, ARobotThatIsStuckIsToldWhatStopsIt) {
  const std::string is_stuck = "it neither moved 1 mm nor turned 1 degree; it touches ";
  EXPECT_THAT(run({.sketch = "PidFollower", .script = "at 2s obstacle 12,2\n", .for_s = 60.0}).why,
              HasSubstr(is_stuck + "an obstacle ("));
  const result::RunResult wall =
      run({.sketch = "PidFollower", .script = "at 1ms place 60mm,200mm,W\n", .for_s = 60.0});
  EXPECT_THAT(wall.why, HasSubstr(is_stuck + "the map's edge ("));
}

TEST(Verdicts, CrashesNameReasonFunctionFileAndLine) {
  struct Case {
    const char* sketch;
    const char* reason;
    const char* function;
    int line;
  };
  for (const Case& c : {Case{"UsesNullPointer", "null pointer", "report", 6},
                        Case{"RecursesTooDeep", "stack overflow", "depth", 0},
                        Case{"OverrunsHeap", "", "setup", 4}, Case{"Aborts", "abort()", "giveUp", 1}}) {
    const result::RunResult r = run({.sketch = c.sketch});
    EXPECT_EQ(r.verdict, "crashed") << c.sketch << ": " << r.why;
    ASSERT_TRUE(r.crash) << c.sketch;
    EXPECT_THAT(r.crash->reason, HasSubstr(c.reason));
    EXPECT_THAT(r.crash->where.function, HasSubstr(c.function));
    EXPECT_EQ(r.crash->where.file, std::string(c.sketch) + ".ino");
    if (c.line) {
      EXPECT_EQ(r.crash->where.line, c.line) << c.sketch;
    }
    EXPECT_THAT(r.why, HasSubstr(std::string(c.sketch) + ".ino"));
  }
}

TEST(Verdicts, ADivisionByZeroIsToldAndTheRunGoesOn) {
  const result::RunResult r = run({.sketch = "DividesByZero", .for_s = 1.0});
  EXPECT_EQ(r.verdict, "timeout") << r.why;
  EXPECT_THAT(r.serial, StartsWith("-1\r\n-1\r\n"));
  ASSERT_EQ(r.divisions_by_zero.size(), 1u);
  EXPECT_EQ(r.divisions_by_zero[0].where.function, "position");
  EXPECT_EQ(r.divisions_by_zero[0].where.line, 3);
  EXPECT_GT(r.divisions_by_zero[0].times, 10);
  EXPECT_THAT(r.next, HasSubstr("divided by zero in position, DividesByZero.ino:3"));
}

TEST(Verdicts, ACrashInALibraryIsToldByTheLibrarysNameAndFile) {
  const result::RunResult r = run({.sketch = "LibraryCrashes"});
  ASSERT_TRUE(r.crash) << r.why;
  EXPECT_EQ(r.crash->where.file, "libraries/Fragile/Fragile.cpp");
  EXPECT_EQ(r.crash->where.line, 3);
}

TEST(Verdicts, ACrashInALibrarysHeaderIsToldByTheLibrarysName) {
  const result::RunResult r = run({.sketch = "HeaderCrashes"});
  ASSERT_TRUE(r.crash) << r.why;
  EXPECT_EQ(r.crash->where.file, "libraries/Brittle/src/Brittle.h");
  EXPECT_EQ(r.crash->where.line, 3);
}

TEST(Verdicts, ASmallHeapOverrunHarmsNobodyElse) {
  const result::RunResult before = run({.sketch = "PidFollower", .goal = "laps:1"});
  run({.sketch = "OverrunsHeapALittle", .goal = "none", .for_s = 1.0});
  run({.sketch = "OverrunsHeap"});
  const result::RunResult after = run({.sketch = "PidFollower", .goal = "laps:1"});
  EXPECT_EQ(after.verdict, "reached");
  EXPECT_EQ(after.trace_hash, before.trace_hash);
}

TEST(Verdicts, ASketchThatExitsSaysSo) {
  const result::RunResult r = run({.sketch = "Exits"});
  EXPECT_EQ(r.verdict, "ended");
  EXPECT_THAT(r.why, HasSubstr("exit(3)"));
}

TEST(Verdicts, ARobotThatIsNeverDrivenIsToldWhichPinsStayedLowAndWhatItWaitsFor) {
  const result::RunResult r = run({.sketch = "NeverDrives", .for_s = 20.0});
  EXPECT_EQ(r.verdict, "timeout");
  EXPECT_THAT(r.next, AllOf(HasSubstr("never moved"), HasSubstr("motor pins 5, 7, 8, 6, 9 and 10 stayed LOW"),
                            HasSubstr("pin 4"), HasSubstr("press start")));
}

void names_wrong_pins(const char* target) {
  const result::RunResult r =
      run({.sketch = "WrongPins", .robot = "uno2", .goal = "none", .for_s = 1.0, .target = target});
  std::vector<std::string> unwired;
  for (const auto& pin : r.usage.unwired) unwired.push_back(pin.pin + " " + pin.how);
  EXPECT_THAT(unwired, testing::ElementsAre("D2 read", "D3 driven", "A3 read"));
  EXPECT_THAT(r.usage.unused, testing::IsSupersetOf({"left", "right"}));
}

TEST(Verdicts, PinsToWhichNothingIsWiredAreNamed) { names_wrong_pins("host"); }
TEST(Verdicts, PinsToWhichNothingIsWiredAreNamedOnAnAvr) {
  ROBOSIM_NEEDS_TARGET("avr");
  names_wrong_pins("avr");
}

TEST(Verdicts, PressingTheButtonGetsItGoing) {
  const result::RunResult r =
      run({.sketch = "NeverDrives", .script = "at 1s press start 200ms", .for_s = 20.0});
  EXPECT_GT(r.metrics.distance_m, 0.1) << r.why;
}

TEST(Verdicts, ASyntaxErrorNamesTheInoAndItsLine) {
  try {
    request_of({.sketch = "LacksSemicolon"});
    FAIL() << "it compiled";
  } catch (const build::CompileError& error) {
    EXPECT_THAT(error.what(), HasSubstr("LacksSemicolon.ino:2"));
  }
}

TEST(Verdicts, AScriptThatNamesUnknownThingsIsRefusedBeforeTheRun) {
  const auto error_of = [](const char* script) -> std::string {
    try {
      run({.sketch = "PidFollower", .script = script});
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_THAT(error_of("at 2s press nose"),
              AllOf(HasSubstr("script:1"), HasSubstr("nose"), HasSubstr("start")));
  EXPECT_THAT(error_of("\nat 2s fault S2 melt"),
              AllOf(HasSubstr("script:2"), HasSubstr("melt"), HasSubstr("stuck")));
  EXPECT_THAT(error_of("after station 9 press start"), HasSubstr("unknown station “9”"));
}

}  // namespace verdicts_test
}  // namespace robosim::test
