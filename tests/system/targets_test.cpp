// Tests that sketches behave correctly, and that equal runs are bit-identical, on every target. Also tests
// faults that only a chip reveals.

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>

#include "sim/base/file.h"
#include "tests/support/temporary_folder.h"
#include "tests/system/system_test.h"

namespace robosim::test {
namespace targets_test {

using testing::AllOf;
using testing::HasSubstr;

class OnEveryTarget : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override { needs_target(GetParam()); }
};

INSTANTIATE_TEST_SUITE_P(Of, OnEveryTarget, testing::Values("host", "avr", "stm32"),
                         [](const auto& target) { return std::string(target.param); });

TEST_P(OnEveryTarget, PidFollowerFollowsTheOval) {
  const std::uint64_t usual = std::string(GetParam()) == "stm32" ? 1 : 3;
  for (std::uint64_t seed = 1; seed <= std::max(seeds_asked_for(), usual); ++seed) {
    const result::RunResult r = run({.sketch = "PidFollower",
                                     .robot = "uno5",
                                     .goal = "laps:1",
                                     .seed = seed,
                                     .for_s = 60.0,
                                     .target = GetParam()});
    ASSERT_EQ(r.verdict, "reached") << "seed " << seed << ": " << r.why;
    EXPECT_LE(r.metrics.cross_track_rms_mm, 8.0) << "seed " << seed;
  }
}

TEST_P(OnEveryTarget, LeftPathAndRightPathVisitAllStationsEachByItsOwnHand) {
  const bool slow = std::string(GetParam()) == "stm32";
  test::Run tour{.map = slow ? "b" : "d", .robot = "uno3", .goal = "tour", .target = GetParam()};
  std::vector<std::string> right{"1", "2", "3", "4"};
  if (!slow) right.insert(right.end(), {"5", "6", "7"});
  std::vector<std::string> left(right.rbegin(), right.rend());
  std::rotate(left.begin(), left.end() - 1, left.end());
  tour.sketch = "RightPath";
  result::RunResult r = run(tour);
  EXPECT_EQ(r.verdict, "reached") << r.why;
  EXPECT_EQ(r.metrics.stations, right);
  tour.sketch = "LeftPath";
  r = run(tour);
  EXPECT_EQ(r.verdict, "reached") << r.why;
  EXPECT_EQ(r.metrics.stations, left);
}

TEST_P(OnEveryTarget, DivisionsThatHaveNoResultGiveWhatTheyGiveOnTheHost) {
  const char* const robot = std::string(GetParam()) == "stm32" ? "bluepill5" : "uno5";
  const auto said = [&](const char* target) {
    return run({.sketch = "DividesByZeroInAllWidths",
                .robot = robot,
                .goal = "none",
                .for_s = 1.0,
                .target = target})
        .serial;
  };
  EXPECT_EQ(said(GetParam()), said("host"));
}

class Paths : public testing::TestWithParam<Trial> {
 protected:
  void SetUp() override { needs_target(GetParam().target); }
};

INSTANTIATE_TEST_SUITE_P(On, Paths, testing::ValuesIn(trials({"a", "b", "c", "d", "e", "f"}, "a")), name_of);

TEST_P(Paths, LeftAndRightComeHomeFromEveryStation) {
  const auto [target, map] = GetParam();
  for (const char* sketch : {"LeftPath", "RightPath"}) {
    for (std::uint64_t seed = 1; seed <= seeds_of(GetParam()); ++seed) {
      const result::RunResult r = run(
          {.sketch = sketch, .map = map, .robot = "uno3", .goal = "tour", .seed = seed, .target = target});
      EXPECT_EQ(r.verdict, "reached") << sketch << " on " << map << ", seed " << seed << ": " << r.why;
    }
  }
}

TEST_P(OnEveryTarget, TwoRunsOfEverySketchAreTheSameBitForBit) {
  const std::string scan = "at 300ms press start 100ms", pony_scan = "at 300ms press scan 100ms";
  for (const test::Run& sketch :
       {test::Run{.sketch = "PidFollower"}, test::Run{.sketch = "LeftPath", .map = "d", .robot = "uno3"},
        test::Run{.sketch = "RightPath", .map = "d", .robot = "uno3"},
        test::Run{.sketch = "AiNavigator", .map = "d", .script = scan},
        test::Run{.sketch = "PonyNavigator", .map = "d", .robot = "pony", .script = pony_scan}}) {
    // The navigators, which have scripts, are slow on the STM32. They run there only with ROBOSIM_TEST_SEEDS.
    if (GetParam() == std::string("stm32") && !sketch.script.empty() && seeds_asked_for() == 0) continue;
    test::Run once = sketch;
    once.goal = "none";
    once.seed = 7;
    once.for_s = 5.0;
    once.target = GetParam();
    const result::RunResult first = run(once);
    EXPECT_GT(first.metrics.distance_m, 0.05) << once.sketch;
    EXPECT_EQ(first.trace_hash, run(once).trace_hash) << once.sketch;
  }
}

TEST_P(OnEveryTarget, PressedButtonsAndSentBytesReachTheSketch) {
  const result::RunResult r = run({.sketch = "WaitsForFlag",
                                   .robot = (sketch_folder("WaitsForFlag") / "robot.toml").string(),
                                   .goal = "none",
                                   .script = "at 500ms press go",
                                   .for_s = 1.0,
                                   .target = GetParam()});
  EXPECT_EQ(r.verdict, "reached") << r.why;
  EXPECT_EQ(r.serial, "went on\r\n");
}

TEST_P(OnEveryTarget, AnInterruptAttachedOverBlackMeetsNoEdge) {
  const result::RunResult r = run({.sketch = "EdgesOverBlack",
                                   .robot = (sketch_folder("EdgesOverBlack") / "robot.toml").string(),
                                   .goal = "none",
                                   .for_s = 0.5,
                                   .target = GetParam()});
  EXPECT_EQ(r.serial, "0\r\n");
}

// The radius is base / tan(angle). Pulses of 544 to 2400 us turn a servo to 0 to 180 degrees. digitalWrite()
// and the Arduino core's interrupts lengthen a pulse by up to 12 us. The radius is then 6 % smaller.
TEST_P(OnEveryTarget, CarsAndTricyclesDriveOnTheRadiusThatTheirServosPulsesSay) {
  constexpr double kDegrees = 180.0 * 250.0 / (2400.0 - 544.0);
  const double expected = 95.0 / std::tan(kDegrees * std::numbers::pi / 180.0);
  TemporaryFolder folder;
  const std::filesystem::path car = sketch_folder("SteersLeft") / "robot.toml";
  for (const int wheels : {1, 2}) {
    const std::filesystem::path robot = folder.path() / "steered.toml";
    std::ofstream(robot) << "base = \"" << car.string()
                         << "\"\n[chassis]\nsteering = { servo = \"front\", base = "
                         << "\"95 mm\", limit = \"45 deg\", wheels = " << wheels << " }\n";
    const result::RunResult r = run({.sketch = "SteersLeft",
                                     .robot = robot.string(),
                                     .goal = "none",
                                     .for_s = 2.5,
                                     .target = GetParam()});
    const double x = r.end.x_mm - 1050.0, y = r.end.y_mm - 250.0;  // from the start
    const double radius = (x * x + y * y) / (2.0 * y);
    EXPECT_GT(r.metrics.distance_m, 0.3) << r.why;
    EXPECT_LT(radius, 1.01 * expected);
    EXPECT_GT(radius, 0.93 * expected);
  }
}

class OnTheChip : public testing::Test {
 protected:
  void SetUp() override { needs_target("avr"); }
};

TEST_F(OnTheChip, TheTextbooksWeightedSumLosesTheLineThatItFollowsOnTheHost) {
  EXPECT_EQ(run({.sketch = "ChipSum", .for_s = 60.0}).verdict, "reached");
  const result::RunResult chip = run({.sketch = "ChipSum", .for_s = 60.0, .target = "avr"});
  EXPECT_EQ(chip.verdict, "lost");
  EXPECT_EQ(chip.next_by, "host");
  EXPECT_THAT(chip.next, HasSubstr("int has 16 bits"));
}

TEST_F(OnTheChip, DivisionsAreEqualAtEveryLevelOfOptimisation) {
  const auto said = [&](const char* target) {
    return run({.sketch = "DividesAtEveryLevel", .goal = "none", .for_s = 3.0, .target = target}).serial;
  };
  const std::string serial = said("host");
  EXPECT_EQ(std::count(serial.begin(), serial.end(), '\n'), 3 * 8 * 4 * 4);
  EXPECT_EQ(said("avr"), serial);
}

TEST_F(OnTheChip, AFollowersRunIsPinned) {
  build::Request request{sketch_folder("PidFollower"), *find_board("uno")};
  request.target = "avr";
  const std::string compiler = build::build(request).compiler;
  const char* const hash = compiler == "gcc 5.4.0 avr"    ? "1:9fbebd1df5d48061"
                           : compiler == "gcc 14.2.0 avr" ? "1:215c323c1f694d28"
                                                          : nullptr;
  if (!hash) GTEST_SKIP() << "pinned for the compilers of Debian 12 and 13, but this is " << compiler;
  const result::RunResult r = run({.sketch = "PidFollower", .goal = "none", .for_s = 5.0, .target = "avr"});
  EXPECT_EQ(r.trace_hash, hash) << r.why;
}

TEST_F(OnTheChip, MillisWrapsInATest) {
  const test::Run soon{.sketch = "ChipClock", .goal = "none", .for_s = 1.0, .target = "avr"};
  test::Run wraps = soon;
  wraps.clock_s = 4294967.0;
  EXPECT_EQ(run(soon).serial, "0000000000\r\n");
  EXPECT_EQ(run(wraps).serial, "0000000100\r\n") << "the wrong comparison says yes at once";
}

TEST_F(OnTheChip, AHangIsFoundThoughTimer0GoesOnInterrupting) {
  const result::RunResult r = run({.sketch = "ChipHang", .target = "avr"});
  EXPECT_EQ(r.verdict, "hung");
  EXPECT_THAT(r.why, AllOf(HasSubstr("wait"), HasSubstr("ChipHang.ino:5")));
}

TEST_F(OnTheChip, ACrashHasItsCallsAndRegisters) {
  const result::RunResult r = run({.sketch = "ChipWildCall", .target = "avr"});
  EXPECT_EQ(r.verdict, "crashed");
  ASSERT_TRUE(r.crash);
  EXPECT_EQ(r.crash->where.function, "call");
  ASSERT_FALSE(r.crash->calls.empty());
  EXPECT_THAT(r.crash->registers, AllOf(HasSubstr("PC 0x"), HasSubstr("r31")));
}

TEST_F(OnTheChip, ResourcesAreMeasuredAndABudgetEndsTheRun) {
  const test::TemporaryFolder folder;
  const std::filesystem::path robot = folder / "tight.toml";
  write_file(robot, "base = \"uno5\"\n[budget]\nloop = \"5500 us\"\n");
  test::Run follower{.sketch = "PidFollower", .goal = "none", .for_s = 2.0, .target = "avr"};
  const result::RunResult free = run(follower);
  ASSERT_TRUE(free.resources);
  EXPECT_GT(free.resources->stack_bytes_max, 20);
  EXPECT_GT(free.resources->loop_us_max, 5500.0) << "delay(5) and some arithmetic";
  EXPECT_GT(free.resources->interrupt_share, 0.001);
  follower.robot = robot.string();
  const result::RunResult r = run(follower);
  EXPECT_EQ(r.verdict, "over_budget");
  EXPECT_EQ(r.status, 1);
  EXPECT_THAT(r.why, HasSubstr("the robot file allows 5.500 ms"));
}

}  // namespace targets_test
}  // namespace robosim::test
