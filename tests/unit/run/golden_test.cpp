// Runs of the built-in driver are the same, bit for bit, for Robosim built by gcc or clang, with or without
// optimisation, on x86-64 and arm64. CI runs these tests in all of those builds.

#include <gtest/gtest.h>

#include "sim/robot/description.h"
#include "sim/run/simulation.h"
#include "tests/support/built_in_driver.h"

namespace robosim::run {
namespace {

judge::Outcome follow(const char* map_name, robot::Profile profile, std::uint64_t seed,
                      SimTime samples_every = 0) {
  const grid::Map map = grid::read_map(grid::find_map(map_name));
  const robot::Description robot = robot::load_description("uno5");
  test::BuiltInDriver driver;
  Setup setup;
  setup.map = &map;
  setup.agents = {{.robot = &robot, .executor = &driver, .goal = judge::parse_goal("laps:2")}};
  setup.limit = 60 * kSecond;
  setup.profile = profile;
  setup.seed = seed;
  setup.samples_every = samples_every;
  return simulate(setup).front();
}

TEST(Golden, TheBuiltInDriverLapsTheOval) {
  const judge::Outcome outcome = follow("oval", robot::Profile::typical, 1);
  EXPECT_EQ(outcome.verdict, judge::Verdict::reached) << outcome.why;
  EXPECT_EQ(outcome.trace_hash, "1:44da347299e4cf48");
}

TEST(Golden, TheProfileIdealIsFrozen) {
  const judge::Outcome outcome = follow("oval", robot::Profile::ideal, 1);
  EXPECT_EQ(outcome.verdict, judge::Verdict::reached) << outcome.why;
  EXPECT_EQ(outcome.trace_hash, "1:945f5f47cca2c19e");
  EXPECT_EQ(outcome.trace_hash, follow("oval", robot::Profile::ideal, 2).trace_hash)
      << "no seed matters without noise";
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

}  // namespace
}  // namespace robosim::run
