// Tests that runs of the built-in driver are bit-identical in all builds: with gcc and clang, with and
// without optimisation, on x86-64 and arm64. CI runs these tests in all these builds.

#include <gtest/gtest.h>

#include "tests/support/built_in_driver.h"
#include "tests/support/one_robot.h"

namespace robosim::run::golden_test {

// A figure eight of arcs and slanted straights that cross.
constexpr const char* kCourse = R"(+++
line = "19 mm"
size = ["2.8 m", "1.4 m"]
[[path]]
from = ["1.4 m", "700 mm"]
heading = "30 deg"
segments = [
  { length = "519.6152422706632 mm" }, { radius = "300 mm", angle = "-240 deg" }, { length = "1039.2304845413264 mm" },
  { radius = "300 mm", angle = "240 deg" }, { length = "519.6152422706632 mm" },
]
+++
)";

judge::Outcome follow(const map::Map& map, robot::Profile profile, std::uint64_t seed,
                      SimTime samples_every = 0) {
  test::BuiltInDriver driver;
  test::OneRobot one(driver, "laps:2");
  one.setup.map = &map;
  one.setup.profile = profile;
  one.setup.seed = seed;
  one.setup.samples_every = samples_every;
  return one.run(60 * kSecond);
}

judge::Outcome follow(const char* map, robot::Profile profile, std::uint64_t seed,
                      SimTime samples_every = 0) {
  return follow(map::read_map(map::find_map(map)), profile, seed, samples_every);
}

TEST(Golden, TheBuiltInDriverLapsACourseOfArcs) {
  const map::Map map = map::parse_map(kCourse, "eight.map");
  const judge::Outcome typical = follow(map, robot::Profile::typical, 1);
  EXPECT_EQ(typical.verdict, judge::Verdict::reached) << typical.why;
  EXPECT_EQ(typical.trace_hash, "1:af177d2cddb50204");
  EXPECT_EQ(follow(map, robot::Profile::ideal, 1).trace_hash, "1:b7cd5d6f8ed906e7");
}

TEST(Golden, TheBuiltInDriverLapsTheOval) {
  const judge::Outcome outcome = follow("oval", robot::Profile::typical, 1);
  EXPECT_EQ(outcome.verdict, judge::Verdict::reached) << outcome.why;
  EXPECT_EQ(outcome.trace_hash, "1:44da347299e4cf48");
}

TEST(Golden, TheBuiltInDriverLapsTheOvalInTypical2) {
  const judge::Outcome outcome = follow("oval", robot::Profile::typical_2, 1);
  EXPECT_EQ(outcome.verdict, judge::Verdict::reached) << outcome.why;
  EXPECT_EQ(outcome.trace_hash, "1:a3aeb8e3c3b24c82");
}

TEST(Golden, TheProfileIdealIsFrozen) {
  const judge::Outcome outcome = follow("oval", robot::Profile::ideal, 1);
  EXPECT_EQ(outcome.verdict, judge::Verdict::reached) << outcome.why;
  EXPECT_EQ(outcome.trace_hash, "1:945f5f47cca2c19e");
  EXPECT_EQ(outcome.trace_hash, follow("oval", robot::Profile::ideal, 2).trace_hash)
      << "without noise, the seed has no effect";
}

TEST(Golden, AnotherSeedIsAnotherRunAndTheSameSeedTheSame) {
  const std::string once = follow("oval", robot::Profile::typical, 7).trace_hash;
  EXPECT_EQ(once, follow("oval", robot::Profile::typical, 7).trace_hash);
  EXPECT_NE(once, follow("oval", robot::Profile::typical, 8).trace_hash);
}

TEST(Golden, RecordingChangesNothing) {
  EXPECT_EQ(follow("oval", robot::Profile::typical, 3).trace_hash,
            follow("oval", robot::Profile::typical, 3, kTick).trace_hash);
}

}  // namespace robosim::run::golden_test
