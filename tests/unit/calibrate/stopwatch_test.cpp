// Tests motor parameters measured with a stopwatch and a tape measure.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "sim/campaign/calibrate/drive_fit.h"
#include "sim/campaign/calibrate/stopwatch.h"
#include "tests/unit/calibrate/bench_logs.h"

namespace robosim::calibrate {
namespace stopwatch_test {

constexpr double kRpm = 2.0 * std::numbers::pi / 60.0;

// Returns distances that a simulated uno3 travelled, with an uncertainty of 5 mm. At 7.11 V, its motors have
// these values: 156.1 rpm without load, a stall torque of 1.024 kg cm, and a no-load current of 192 mA.
std::vector<Timed> timed() {
  return {{"", 0, 255, 0.4, 0.221, 0.005},
          {"", 0, 255, 1.0, 0.509, 0.005},
          {"", 0, 255, 3.0, 1.440, 0.005},
          {"", 0, 170, 1.0, 0.417, 0.005},
          {"", 0, 130, 3.0, 1.078, 0.005}};
}

TEST(Stopwatch, TellsSpeedAndFrictionAndRoughlyTheTorque) {
  const std::vector<Log> none;
  const auto fit = fit_drives(none, timed(), robot::load_description("uno3"), {7.11, 0.07});
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->no_load[0].value / kRpm, 156.1, 5.0);
  EXPECT_LT(fit->no_load[0].sd / kRpm, 10.0);
  EXPECT_NEAR(fit->no_load_current.value, 0.192, 0.019);
  EXPECT_NEAR(fit->stall_torque.value, 0.1004, 2.0 * fit->stall_torque.sd);
  EXPECT_LT(fit->stall_torque.sd, 0.3 * fit->stall_torque.value);
}

TEST(Stopwatch, OfOneDriveTellsTheSpeedAlone) {
  const std::vector<Log> none;
  const auto fit = fit_drives(none, {timed()[2]}, robot::load_description("uno3"), {7.11, 0.07});
  ASSERT_TRUE(fit);
  EXPECT_FALSE(fit->torque_told);
  EXPECT_FALSE(fit->friction_told);
  EXPECT_NEAR(fit->no_load[0].value / kRpm, 156.1, 15.0);
}

}  // namespace stopwatch_test
}  // namespace robosim::calibrate
