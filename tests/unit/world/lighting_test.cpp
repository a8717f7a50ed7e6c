#include "sim/world/lighting.h"

#include <gtest/gtest.h>

#include <cmath>

namespace robosim::world::lighting_test {

using map::Light;

Light lamp(double level, double height) {
  Light light;
  light.level = level;
  light.at = Vec2{1.0, 1.0};
  light.height = height;
  return light;
}

TEST(Lighting, OfNothingIsDark) {
  const Lighting lighting({});
  EXPECT_FALSE(lighting.is_lit());
  EXPECT_EQ(lighting.at({1.0, 1.0}, 0), 0.0);
}

// At 45 degrees, the cosine is 1 / sqrt(2), and its cube is 0.354.
TEST(Lighting, ALampFadesByTheCubeOfTheCosine) {
  const Lighting lighting({lamp(0.4, 0.5)});
  EXPECT_DOUBLE_EQ(lighting.at({1.0, 1.0}, 0), 0.4);
  EXPECT_NEAR(lighting.at({1.5, 1.0}, 0), 0.4 * std::pow(0.5, 1.5), 1e-12);
  EXPECT_NEAR(lighting.at({1.0, 2.0}, kSecond), 0.4 * std::pow(0.2, 1.5), 1e-12);
}

TEST(Lighting, APatchOfSunHasAnEdgeAndMoves) {
  Light sun = lamp(0.6, 0.0);
  sun.radius = 0.2;
  sun.moves = {0.01, 0.0};
  const Lighting lighting({sun});
  EXPECT_EQ(lighting.at({1.19, 1.0}, 0), 0.6);
  EXPECT_EQ(lighting.at({1.21, 1.0}, 0), 0.0);
  EXPECT_EQ(lighting.at({1.21, 1.0}, 2 * kSecond), 0.6);
  EXPECT_EQ(lighting.at({0.81, 1.0}, 2 * kSecond), 0.0);
}

TEST(Lighting, FlickersWithItsFrequencyAndTwoThirdsOfItIsLeft) {
  Light light;
  light.level = 0.3;
  light.flicker = 1.0;
  light.frequency = 100.0;
  const Lighting lighting({light});
  double sum = 0.0, least = 1.0, most = 0.0;
  for (int i = 0; i < 1000; ++i) {
    const double now = lighting.at({}, i * 10 * kMicrosecond);
    EXPECT_NEAR(now, lighting.at({}, i * 10 * kMicrosecond + 10 * kMillisecond), 1e-9);
    sum += now;
    least = std::min(least, now);
    most = std::max(most, now);
  }
  EXPECT_NEAR(sum / 1000, 0.2, 1e-3);
  EXPECT_NEAR(least, 0.0, 1e-9);
  EXPECT_NEAR(most, 0.3, 1e-9);
}

TEST(Lighting, EachLampBeginsElsewhereInItsFlicker) {
  Light light;
  light.level = 1.0;
  light.flicker = 1.0;
  light.frequency = 100.0;
  Lighting one({light}), other({light});
  one.draw_phases(NoiseStream(1, 0, "light", "phase"));
  other.draw_phases(NoiseStream(2, 0, "light", "phase"));
  EXPECT_NE(one.at({}, 0), other.at({}, 0));
}

TEST(Lighting, AHigherSensorIsLessInTheShade) {
  EXPECT_DOUBLE_EQ(exposure(0.003), 1.0);
  EXPECT_NEAR(exposure(0.008), (64.0 / 89.0) / (9.0 / 34.0), 1e-12);
}

}  // namespace robosim::world::lighting_test
