#include "sim/campaign/analysis/success_rate.h"

#include <gtest/gtest.h>

namespace robosim::analysis {
namespace success_rate_test {

TEST(Wilson, AgreesWithPublishedValues) {
  // R. G. Newcombe, "Two-sided confidence intervals for the single proportion", Statistics in Medicine 17
  // (1998) 857-872, table I, method 3: 81 of 263, 15 of 148, 0 of 20 and 1 of 29.
  const auto expect = [](std::int64_t successes, std::int64_t runs, double low, double high) {
    const Interval interval = wilson(successes, runs);
    EXPECT_NEAR(interval.low, low, 0.5e-4) << successes << " of " << runs;
    EXPECT_NEAR(interval.high, high, 0.5e-4) << successes << " of " << runs;
  };
  expect(81, 263, 0.2553, 0.3662);
  expect(15, 148, 0.0624, 0.1605);
  expect(0, 20, 0.0, 0.1611);
  expect(1, 29, 0.0061, 0.1718);
}

TEST(Wilson, StaysWithinZeroAndOneAndIsSymmetric) {
  EXPECT_EQ(wilson(0, 0).low, 0.0);
  EXPECT_EQ(wilson(0, 0).high, 1.0);
  for (std::int64_t n : {1, 7, 1000}) {
    for (std::int64_t k = 0; k <= n; ++k) {
      const Interval interval = wilson(k, n), mirrored = wilson(n - k, n);
      EXPECT_GE(interval.low, 0.0);
      EXPECT_LE(interval.high, 1.0);
      EXPECT_NEAR(interval.low, 1.0 - mirrored.high, 1e-12);
      if (k > 0) {
        EXPECT_GT(interval.low, wilson(k - 1, n).low);
      }
    }
  }
  EXPECT_EQ(wilson(0, 9).low, 0.0);
  EXPECT_EQ(wilson(9, 9).high, 1.0);
}

TEST(Demand, IsMetByTheShareItNamesToTheLastRun) {
  EXPECT_EQ(needed_successes({0.99}, 100), 99);
  EXPECT_EQ(needed_successes({0.07}, 100), 7);  // 0.07 * 100 is more than 7 in floating point
  EXPECT_EQ(needed_successes({0.5}, 3), 2);
  EXPECT_EQ(needed_successes({1.0}, 1000), 1000);
  EXPECT_EQ(needed_successes({0.0}, 10), 0);
}

TEST(Demand, ASureOneNeedsMoreRunsThanItsShare) {
  EXPECT_EQ(needed_successes({0.99, true}, 100), std::nullopt);
  EXPECT_EQ(needed_successes({0.99, true}, 1000), 997);
  EXPECT_EQ(needed_runs({0.99, true}), 381);
  EXPECT_EQ(needed_successes({0.99, true}, 381), 381);
  EXPECT_EQ(needed_successes({0.99, true}, 380), std::nullopt);
  EXPECT_EQ(needed_runs({1.0, true}), std::nullopt);
  EXPECT_EQ(needed_runs({1.0}), 1);
}

TEST(Tally, IsDecidedAsSoonAsTheRestCannotChangeTheAnswer) {
  Tally good(100, Demand{0.9});
  for (int i = 0; i < 89; ++i) good.add(true);
  EXPECT_FALSE(good.decided());
  good.add(true);
  EXPECT_TRUE(good.met());
  EXPECT_FALSE(good.missed());

  Tally bad(100, Demand{0.9});
  for (int i = 0; i < 10; ++i) bad.add(false);
  EXPECT_FALSE(bad.decided());
  bad.add(false);
  EXPECT_TRUE(bad.missed());
}

TEST(Tally, StoppingEarlyNeverChangesTheAnswer) {
  for (const bool sure : {false, true}) {
    for (std::int64_t failures = 0; failures <= 20; ++failures) {
      Tally whole(1000, Demand{0.99, sure}), stopped(1000, Demand{0.99, sure});
      for (std::int64_t i = 0; i < 1000; ++i) {
        const bool success = i * 7919 % 1000 >= failures;  // distributes the failures over the runs
        whole.add(success);
        if (!stopped.decided()) stopped.add(success);
      }
      EXPECT_TRUE(whole.decided());
      EXPECT_EQ(whole.met(), stopped.met()) << failures;
      EXPECT_EQ(whole.met(), failures <= (sure ? 3 : 10));
    }
  }
}

TEST(Tally, ADemandThatCannotBeMetIsMissedBeforeTheFirstRun) {
  EXPECT_TRUE(Tally(100, Demand{0.99, true}).missed());
}

TEST(Tally, WithoutADemandNothingIsDecided) {
  Tally tally(2, std::nullopt);
  tally.add(true);
  tally.add(false);
  EXPECT_FALSE(tally.decided());
  EXPECT_EQ(tally.rate(), 0.5);
}

}  // namespace success_rate_test
}  // namespace robosim::analysis
