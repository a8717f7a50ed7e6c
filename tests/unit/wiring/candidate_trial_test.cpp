#include "sim/campaign/wiring/candidate_trial.h"

#include <gtest/gtest.h>

namespace robosim::wiring {
namespace candidate_trial_test {

TEST(Combinations, BeginWithTheFewestDifferences) {
  const std::vector<Ways> all = combinations({.black_low = true, .other_sides = true, .low_battery = true});
  ASSERT_EQ(all.size(), 7u);
  EXPECT_EQ(all[0], Ways{.black_low = true});
  EXPECT_EQ(all[1], Ways{.other_sides = true});
  EXPECT_EQ(all[2], Ways{.low_battery = true});
  EXPECT_EQ(all[6], (Ways{.black_low = true, .other_sides = true, .low_battery = true}));
  EXPECT_TRUE(combinations({}).empty());
}

TEST(FollowedLine, CountsEachPartOfTheLineOnceAndNothingBesideIt) {
  FollowedLine line;
  wire::Sample sample;
  for (int round = 0; round < 3; ++round)
    for (int i = 0; i < 100; ++i) {
      sample.x_mm = 10.0 * i + 5.0;
      line.add(sample);
    }
  EXPECT_NEAR(line.length(), 1.0, 1e-9) << "a robot that turns on the spot follows nothing new";
  sample.cross_track_mm = 50.0;
  sample.y_mm = 500.0;
  line.add(sample);
  EXPECT_NEAR(line.length(), 1.0, 1e-9);
}

TEST(FollowsALap, TakesALapAlongTheLineAlone) {
  result::RunResult result;
  result.verdict = "reached";
  result.metrics.cross_track_rms_mm = 12.0;
  result.time_s = 24.0;
  EXPECT_TRUE(follows_a_lap(result, false));
  result.metrics.off_line_s = 19.0;
  EXPECT_FALSE(follows_a_lap(result, false)) << "the robot saw the line by chance";
  EXPECT_TRUE(follows_a_lap(result, true)) << "two sensors next to the line do not see the line";
  result.metrics.cross_track_rms_mm = 60.0;
  EXPECT_FALSE(follows_a_lap(result, true)) << "the lap was next to the line";
  result.metrics.cross_track_rms_mm = 12.0;
  result.verdict = "timeout";
  EXPECT_FALSE(follows_a_lap(result, true));
}

}  // namespace candidate_trial_test
}  // namespace robosim::wiring
