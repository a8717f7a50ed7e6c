#include "sim/view/terminal/pacer.h"

#include <gtest/gtest.h>

namespace robosim::terminal {
namespace pacer_test {

TEST(Pacer, WaitsUntilSimulatedTimeIsDue) {
  Pacer pacer(2.0);
  EXPECT_EQ(pacer.wait_us(0, 500), 0);
  EXPECT_EQ(pacer.wait_us(10'000, 500), 5'000);
  EXPECT_EQ(pacer.wait_us(10'000, 4'500), 1'000);
  EXPECT_EQ(pacer.wait_us(10'000, 5'500), 0);
}

TEST(Pacer, SpeedZeroNeverWaits) {
  Pacer pacer(0.0);
  EXPECT_EQ(pacer.wait_us(0, 0), 0);
  EXPECT_EQ(pacer.wait_us(1'000'000'000, 0), 0);
}

TEST(Pacer, AfterAPauseTimeGoesOnWhereItStopped) {
  Pacer pacer(1.0);
  pacer.wait_us(0, 0);
  pacer.set_paused(true);
  pacer.set_paused(false);
  EXPECT_EQ(pacer.wait_us(10'000, 9'000'000), 0);
  EXPECT_EQ(pacer.wait_us(20'000, 9'000'000), 10'000);
}

TEST(Pacer, AViewerThatFellBehindDoesNotHurryToCatchUp) {
  Pacer pacer(1.0);
  pacer.wait_us(0, 0);
  EXPECT_EQ(pacer.wait_us(10'000, 5'000'000), 0);
  EXPECT_EQ(pacer.wait_us(20'000, 5'000'000), 10'000);
}

TEST(Pacer, SpeedsDoubleUpToAsFastAsPossibleAndBack) {
  Pacer pacer(32.0);
  pacer.faster();
  EXPECT_EQ(pacer.speed(), 64.0);
  pacer.faster();
  EXPECT_EQ(pacer.speed(), 0.0);
  pacer.faster();
  EXPECT_EQ(pacer.speed(), 0.0);
  pacer.slower();
  EXPECT_EQ(pacer.speed(), 64.0);
  for (int i = 0; i < 20; ++i) pacer.slower();
  EXPECT_EQ(pacer.speed(), 1.0 / 16.0);
}

}  // namespace pacer_test
}  // namespace robosim::terminal
