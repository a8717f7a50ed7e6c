// Tests the guarantees of Robosim's example sketches, with many seeds.

#include "sim/base/file.h"
#include "tests/support/effort.h"
#include "tests/support/temporary_folder.h"
#include "tests/system/system_test.h"

namespace robosim::test {
namespace sketches_test {

using testing::ElementsAre;
using testing::SizeIs;

constexpr std::uint64_t kFollowerSeeds = rounds(100);
constexpr std::uint64_t kTourSeeds = rounds(20);

result::RunResult follow(const std::string& map, std::uint64_t seed) {
  return run(
      {.sketch = "PidFollower", .map = map, .robot = "uno5", .goal = "laps:3", .seed = seed, .for_s = 120.0});
}

// Two crossings of four lines, two Ts, nine stations.
constexpr char kCrossings[] =
    "##########################\n"
    "#________________________#\n"
    "#________________________#\n"
    "#_____.__________________#\n"
    "#_____.___.......________#\n"
    "#_____.______.___________#\n"
    "#_____.______.___________#\n"
    "#_____.______.___________#\n"
    "#__S...................__#\n"
    "#_____.___________.______#\n"
    "#_____.___________.______#\n"
    "#_____.___________.______#\n"
    "#_____.________.......___#\n"
    "#_____.___________.______#\n"
    "#_____.___________.______#\n"
    "#________________________#\n"
    "#________________________#\n"
    "##########################\n";

TEST(PidFollowerSketch, FinishesThreeLapsOfTheOvalFastAndCloseToTheLineForEverySeed) {
  for (std::uint64_t seed = 1; seed <= kFollowerSeeds; ++seed) {
    const result::RunResult r = follow("oval", seed);
    ASSERT_EQ(r.verdict, "reached") << "seed " << seed << ": " << r.why;
    EXPECT_GE(r.metrics.distance_m / r.time_s, 0.4) << "seed " << seed;
    EXPECT_LE(r.metrics.cross_track_rms_mm, 8.0) << "seed " << seed;
    EXPECT_EQ(r.metrics.collisions, 0) << "seed " << seed;
  }
}

TEST(PidFollowerSketch, FollowsCrossingsTightBendsAndDashedLines) {
  for (const char* map : {"figure8", "tight", "dashed"}) {
    for (std::uint64_t seed = 1; seed <= kTourSeeds; ++seed) {
      const result::RunResult r = follow(map, seed);
      EXPECT_EQ(r.verdict, "reached") << map << ", seed " << seed << ": " << r.why;
      EXPECT_LE(r.metrics.cross_track_rms_mm, 8.0) << map << ", seed " << seed;
    }
  }
}

class TouringSketch : public testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Of, TouringSketch, testing::Values("LeftPath", "RightPath"),
                         [](const auto& sketch) { return std::string(sketch.param); });

TEST_P(TouringSketch, VisitsAllStationsOfMapDAndComesHomeForEverySeed) {
  for (std::uint64_t seed = 1; seed <= kTourSeeds; ++seed) {
    const result::RunResult r =
        run({.sketch = GetParam(), .map = "d", .robot = "uno3", .goal = "tour", .seed = seed});
    EXPECT_EQ(r.verdict, "reached") << "seed " << seed << ": " << r.why;
    // The right-hand walk numbers the stations, so a left-hand walk reaches them in reverse order.
    if (std::string(GetParam()) == "RightPath") {
      EXPECT_THAT(r.metrics.stations, ElementsAre("1", "2", "3", "4", "5", "6", "7")) << "seed " << seed;
    } else {
      EXPECT_THAT(r.metrics.stations, ElementsAre("1", "7", "6", "5", "4", "3", "2")) << "seed " << seed;
    }
    EXPECT_EQ(r.metrics.collisions, 0) << "seed " << seed;
  }
}

TEST_P(TouringSketch, TakesCrossingsOfFourLines) {
  const test::TemporaryFolder folder;
  const std::filesystem::path map = folder / "crossings.map";
  write_file(map, kCrossings);
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const result::RunResult r =
        run({.sketch = GetParam(), .map = map.string(), .robot = "uno3", .goal = "tour", .seed = seed});
    EXPECT_EQ(r.verdict, "reached") << "seed " << seed << ": " << r.why;
    EXPECT_THAT(r.metrics.stations, SizeIs(9)) << "seed " << seed;
  }
}

}  // namespace sketches_test
}  // namespace robosim::test
