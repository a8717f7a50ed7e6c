// Tests the hint `next` of a run's result after a second run with --sanitize
// (sim/campaign/rerun/sanitizer_rerun.h).
#include "sim/campaign/rerun/sanitizer_rerun.h"

#include <gmock/gmock.h>

#include "sim/result/advice.h"

namespace robosim::campaign {
namespace sanitizer_rerun_test {

using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

result::RunResult run_that_ended(const char* verdict, const std::string& next, const char* next_by = "") {
  result::RunResult run;
  run.verdict = verdict;
  run.next = next;
  run.next_by = next_by;
  return run;
}

TEST(NextStepAfterARun, HasTheOptionsThatItNeeds) {
  EXPECT_EQ(next_of(run_that_ended("lost", "watch it", "watching")),
            "watch it (--view --speed 0.2, or --record run.csv)");
  EXPECT_EQ(next_of(run_that_ended("lost", "run it on the host", "host")),
            "run it on the host (--target host)");
  EXPECT_EQ(next_of(run_that_ended("timeout", "press it", "script")), "press it (--script FILE)");
  EXPECT_EQ(next_of(run_that_ended("timeout", "it has no motors")), "it has no motors");
}

TEST(NextStepAfterARun, IsTheFindingOfTheRunWithChecks) {
  result::Finding finding;
  finding.fault.reason = "index 5 is outside of the array";
  finding.fault.where = {"loop", "My.ino", 9};
  finding.time_s = 1.5;
  finding.advice = "On the chip int has 16 bits.";
  EXPECT_EQ(next_after(run_that_ended("lost", result::kWatch), {.finding = finding}),
            "index 5 is outside of the array in loop, My.ino:9, 1.50 s after the start: this is the first "
            "failed check of a second run with checks (--sanitize). On the chip int has 16 bits.");
  EXPECT_EQ(next_after(run_that_ended("lost", result::kWatch), {}), result::kWatch)
      << "the sketch does not compile with checks, or the user interrupted";
}

TEST(NextStepAfterARun, BeginsWithVariablesThatMayBeUnset) {
  const std::string unset = "My.ino:9:3: 'sum' may be used before it has a value: give it one";
  EXPECT_EQ(next_after(run_that_ended("lost", "look at the line"), {.unset = {unset}}),
            unset + "; look at the line");
  EXPECT_EQ(after_unset({unset, "b", "c", "d"}, ""), unset + "; b; c") << "at most three";
  EXPECT_EQ(after_unset({}, "look at the line"), "look at the line");
}

TEST(NextStepAfterARun, SaysIfARunWithChecksWasClean) {
  constexpr const char* kClean = "A second run, with checks (--sanitize), has met no signed number";
  const Checked clean{.is_clean = true};
  EXPECT_THAT(next_after(run_that_ended("stuck", ""), clean), StartsWith(kClean));
  EXPECT_THAT(next_after(run_that_ended("lost", "turn it"), clean), StartsWith("turn it. A second run, "));
  EXPECT_THAT(next_after(run_that_ended("lost", ""), {}), Not(HasSubstr(kClean)));
  EXPECT_EQ(next_after(run_that_ended("timeout", "turn it"), clean), "turn it");
}

TEST(NextStepAfterARun, LooksForNoOverflowAfterACleanRunWithChecks) {
  const result::RunResult lost = run_that_ended("lost", result::kTryHost, "host");
  EXPECT_THAT(next_after(lost, {}), EndsWith(" (--target host)"));
  EXPECT_THAT(next_after(lost, {.is_clean = true}), StartsWith(std::string(result::kWatch) + ". A second"));
}

}  // namespace sanitizer_rerun_test
}  // namespace robosim::campaign
