// Tests when a runner ends a run that hangs. The runner decides by processor time, wall time, and the
// simulated time that the run's process reports.
#include "sim/runner/run_watch.h"

#include <gtest/gtest.h>

#include "sim/base/child.h"

namespace robosim::runner::run_watch_test {

using Found = RunWatch::Found;
using Reading = RunWatch::Reading;

class Watching : public testing::Test {
 protected:
  Watching() { watch_.follow(-1, {.until = 100 * kSecond}); }

  /// Checks a process every 100 ms of wall time for `seconds`, as a runner does. The process uses `share` of
  /// a processor. `is_excused` means that a debugger has halted it, or that it awaits a processor.
  Found look_for(double seconds, double share, bool is_excused = false) {
    for (int i = 0; i < 10 * seconds; ++i) {
      wall_us_ += 100'000;
      processor_ns_ += static_cast<std::int64_t>(share * 100'000'000);
      if (const Found found = watch_.look({processor_ns_, wall_us_, is_excused}); found != Found::nothing)
        return found;
    }
    return Found::nothing;
  }
  void come_to(SimTime t) { watch_.reached() = t; }

  RunWatch watch_;
  std::int64_t processor_ns_ = 0, wall_us_ = 0;
};

TEST_F(Watching, LimitsTheLoadingOfFirmwareAndNotWhatIsReadBefore) {
  EXPECT_EQ(look_for(200, 1.0), Found::nothing) << "reading a large map may take long";
  come_to(-1);
  EXPECT_EQ(look_for(4.5, 1.0), Found::nothing);
  EXPECT_EQ(look_for(1, 1.0), Found::loops);
}

TEST_F(Watching, EndsARunThatSleepsOrIsStoppedUnlessADebuggerHasHaltedIt) {
  come_to(kSecond);
  EXPECT_EQ(look_for(29, 0.0), Found::nothing);
  EXPECT_EQ(look_for(100, 0.0, true), Found::nothing);
  EXPECT_EQ(look_for(29, 0.0), Found::nothing);
  EXPECT_EQ(look_for(2, 0.0), Found::sleeps);
}

TEST_F(Watching, BlamesARunOnABusyMachineForNoSleep) {
  come_to(kSecond);
  for (int turn = 0; turn < 16; ++turn) {
    EXPECT_EQ(look_for(5, 0.0), Found::nothing);
    EXPECT_EQ(look_for(0.3, 1.0), Found::nothing);
  }
  EXPECT_EQ(look_for(1, 1.0), Found::loops);
}

TEST_F(Watching, CountsNoTimeInWhichItsRunnerWasStoppedToo) {
  come_to(kSecond);
  look_for(1, 0.0);
  wall_us_ += std::int64_t{3600} * 1'000'000;
  EXPECT_EQ(look_for(25, 0.0), Found::nothing);
}

TEST_F(Watching, LetsARunWaitOnlyForAClientThatItHas) {
  come_to(kSecond);
  watch_.wait_for_client(true);
  EXPECT_EQ(look_for(40, 0.0), Found::sleeps);
  RunWatch driven;
  driven.follow(-1, {.until = kSecond, .may_wait = true});
  driven.reached() = 0;
  driven.wait_for_client(true);
  for (std::int64_t s = 0; s < 100; ++s) EXPECT_EQ(driven.look({0, s * 1'000'000, false}), Found::nothing);
}

TEST_F(Watching, LimitsTheProcessorTimeOfAWholeRunHoweverOftenItSaysThatItComesFurther) {
  const auto claim = [&](SimTime step, double share) {
    for (int i = 0; i < 200; ++i) {
      come_to(i * step);
      if (const Found found = look_for(1, share); found != Found::nothing) return std::pair(i, found);
    }
    return std::pair(200, Found::nothing);
  };
  EXPECT_EQ(claim(1, 1.0), std::pair(60, Found::exhausts));
  processor_ns_ = 0;
  EXPECT_EQ(claim(10 * kSecond, 1.0), std::pair(159, Found::exhausts)) << "the run's time limit also applies";
  processor_ns_ = 0;
  EXPECT_EQ(claim(kSecond, 0.1), std::pair(200, Found::nothing));
}

TEST_F(Watching, BelievesNoRunThatSaysAgainThatItHasNotBegun) {
  constexpr SimTime kNotBegun = -2;
  for (const double share : {1.0, 0.0}) {
    come_to(kSecond);
    look_for(0.1, share);
    come_to(kNotBegun);
    EXPECT_EQ(look_for(100, share), share > 0.0 ? Found::loops : Found::sleeps);
  }
}

TEST_F(Watching, LimitsARunWhoseFirmwareNeverLetsItSayThatItHasBegun) {
  EXPECT_EQ(look_for(200, 1.0), Found::nothing) << "reading a large map may take long";
  // The child acts as a run's process. It records that firmware runs next, and firmware cannot undo this
  // record.
  Child([&] {
    watch_.close();
    return 0;
  }).wait();
  EXPECT_EQ(look_for(59, 1.0), Found::nothing);
  EXPECT_EQ(look_for(2, 1.0), Found::exhausts);
  EXPECT_EQ(look_for(31, 0.0), Found::exhausts);
}

TEST_F(Watching, BelievesNoTimeThatTheRunMayNotReach) {
  for (const auto& [said, believed] :
       {std::pair<SimTime, SimTime>{-1, 0}, {INT64_MIN, 0}, {kSecond, kSecond}, {INT64_MAX, 100 * kSecond}}) {
    come_to(said);
    EXPECT_EQ(watch_.time(), believed);
  }
}

}  // namespace robosim::runner::run_watch_test
