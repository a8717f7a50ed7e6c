#include "PidController.h"

#include <gtest/gtest.h>

namespace pid_controller_test {

TEST(PidController, WithOnlyAProportionalPartMultipliesTheError) {
  PidController pid(60, 0, 0);
  EXPECT_FLOAT_EQ(pid.update(0.5f, 0.005f), 30.0f);
  EXPECT_FLOAT_EQ(pid.update(-2.0f, 0.005f), -120.0f);
}

TEST(PidController, TakesOtherGainsWhileItRuns) {
  PidController pid(0, 0, 0);
  pid.setGains(60, 2, 1);
  EXPECT_FLOAT_EQ(pid.update(1.0f, 0.01f), 60.0f + 2 * 0.01f);
  EXPECT_NEAR(pid.update(2.0f, 0.01f), 2 * 60.0f + 2 * 0.03f + 100.0f, 1e-3f);
}

TEST(PidController, HasNoLimitsUntilTheyAreSet) {
  PidController pid(1, 0, 0);
  EXPECT_FLOAT_EQ(pid.update(1e30f, 0.01f), 1e30f);
  EXPECT_FLOAT_EQ(pid.update(-1e30f, 0.01f), -1e30f);
}

TEST(PidController, HasNoDerivativeInItsFirstStep) {
  PidController pid(0, 0, 1);
  EXPECT_FLOAT_EQ(pid.update(5.0f, 0.01f), 0.0f);
  EXPECT_FLOAT_EQ(pid.update(6.0f, 0.01f), 100.0f);
}

TEST(PidController, AddsUpTheErrorOverTime) {
  PidController pid(0, 2, 0);
  for (int i = 0; i < 100; ++i) pid.update(3.0f, 0.01f);
  EXPECT_NEAR(pid.integral(), 3.0f, 1e-4f);
  EXPECT_NEAR(pid.update(0.0f, 0.01f), 6.0f, 1e-3f);
}

TEST(PidController, StaysWithinItsLimits) {
  PidController pid(100, 0, 0);
  pid.setLimits(-150, 120);
  EXPECT_FLOAT_EQ(pid.update(2.0f, 0.01f), 120.0f);
  EXPECT_FLOAT_EQ(pid.update(-2.0f, 0.01f), -150.0f);
}

TEST(PidController, TakesLimitsInEitherOrder) {
  PidController pid(100, 0, 0);
  pid.setLimits(50, -50);
  EXPECT_FLOAT_EQ(pid.update(2.0f, 0.01f), 50.0f);
  EXPECT_FLOAT_EQ(pid.update(-2.0f, 0.01f), -50.0f);
}

TEST(PidController, DoesNotWindUpWhileItsOutputIsAtTheLimit) {
  PidController pid(10, 10, 0);
  pid.setLimits(-100, 100);
  for (int i = 0; i < 10000; ++i) pid.update(20.0f, 0.01f);  // 100 s with the output at its limit
  EXPECT_LT(pid.integral(), 1.0f);
  // The error is now 0, so the output drops immediately.
  EXPECT_LT(pid.update(0.0f, 0.01f), 10.0f);
}

TEST(PidController, UnwindsWhileItsOutputIsAtTheLimit) {
  PidController pid(0, 10, 0);
  pid.setLimits(-5, 5);
  for (int i = 0; i < 100; ++i) pid.update(1.0f, 0.01f);
  const float wound = pid.integral();
  pid.update(-1.0f, 0.01f);
  EXPECT_LT(pid.integral(), wound);
}

TEST(PidController, DoesNotWindUpWithANegativeIntegralGainEither) {
  PidController pid(0, -10, 0);
  pid.setLimits(-5, 5);
  for (int i = 0; i < 1000; ++i) pid.update(1.0f, 0.01f);
  EXPECT_LT(pid.integral(), 0.6f);
}

TEST(PidController, SmoothsItsDerivative) {
  PidController pid(0, 0, 1);
  pid.setDerivativeSmoothing(0.03f);
  pid.update(0.0f, 0.01f);
  EXPECT_NEAR(pid.update(1.0f, 0.01f), 25.0f, 1e-3f);  // 100 * dt / (dt + smoothing), a quarter of 100
}

TEST(PidController, DoesNotSmoothAnyMoreWhenToldSo) {
  PidController pid(0, 0, 1);
  pid.setDerivativeSmoothing(0.03f);
  pid.setDerivativeSmoothing(0);
  pid.update(0.0f, 0.01f);
  EXPECT_NEAR(pid.update(1.0f, 0.01f), 100.0f, 1e-3f);
}

TEST(PidController, IgnoresIntegralAndDerivativeWhenNoTimeHasPassed) {
  PidController pid(1, 1, 1);
  pid.update(1.0f, 0.01f);
  EXPECT_NEAR(pid.update(2.0f, 0.0f), 2.01f, 1e-4f);
}

TEST(PidController, BeginsAnewAfterAReset) {
  PidController pid(0, 5, 5);
  pid.update(1.0f, 0.01f);
  pid.update(3.0f, 0.01f);
  pid.reset();
  EXPECT_EQ(pid.integral(), 0.0f);
  EXPECT_NEAR(pid.update(7.0f, 0.01f), 5 * 0.07f, 1e-5f);
}

}  // namespace pid_controller_test
