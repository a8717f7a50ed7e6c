#include "sim/campaign/wiring/candidate_trial.h"

#include <gtest/gtest.h>

namespace robosim::wiring {
namespace candidate_trial_test {

TEST(FollowsALap, TakesALapAlongTheLineAlone) {
  result::RunResult result;
  result.verdict = "reached";
  result.metrics.cross_track_rms_mm = 12.0;
  result.time_s = 24.0;
  EXPECT_TRUE(follows_a_lap(result, false));
  result.metrics.off_line_s = 19.0;
  EXPECT_FALSE(follows_a_lap(result, false)) << "it saw the line by chance";
  EXPECT_TRUE(follows_a_lap(result, true)) << "two sensors beside the line do not see it";
  result.metrics.cross_track_rms_mm = 60.0;
  EXPECT_FALSE(follows_a_lap(result, true)) << "the lap was next to the line";
  result.metrics.cross_track_rms_mm = 12.0;
  result.verdict = "timeout";
  EXPECT_FALSE(follows_a_lap(result, true));
}

}  // namespace candidate_trial_test
}  // namespace robosim::wiring
