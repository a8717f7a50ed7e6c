#include "sim/base/noise.h"

#include <gtest/gtest.h>

#include <cmath>

namespace robosim {

TEST(Noise, DependsOnEveryPartOfItsNameAndOnNothingElse) {
  const NoiseStream a(1, 0, "S1", "noise");
  EXPECT_EQ(a.bits(7), NoiseStream(1, 0, "S1", "noise").bits(7));
  EXPECT_NE(a.bits(7), NoiseStream(2, 0, "S1", "noise").bits(7));
  EXPECT_NE(a.bits(7), NoiseStream(1, 1, "S1", "noise").bits(7));
  EXPECT_NE(a.bits(7), NoiseStream(1, 0, "S2", "noise").bits(7));
  EXPECT_NE(a.bits(7), NoiseStream(1, 0, "S1", "gain").bits(7));
  EXPECT_NE(NoiseStream(1, 0, "ab", "c").bits(0), NoiseStream(1, 0, "a", "bc").bits(0));
}

TEST(Noise, IsFrozen) {  // the recorded hashes of all runs with noise depend on these bits
  EXPECT_EQ(NoiseStream(42, 0, "S1", "noise").bits(0), 12954214989329750460u);
}

TEST(Noise, HasMeanZeroAndDeviationOne) {
  const NoiseStream stream(5, 0, "part", "test");
  double sum = 0.0, squares = 0.0;
  constexpr int n = 100000;
  for (int i = 0; i < n; ++i) {
    const double g = stream.gauss(static_cast<std::uint64_t>(i));
    ASSERT_LE(std::abs(g), 3.4642);
    sum += g;
    squares += g * g;
  }
  EXPECT_NEAR(sum / n, 0.0, 0.01);
  EXPECT_NEAR(squares / n, 1.0, 0.01);
}

}  // namespace robosim
