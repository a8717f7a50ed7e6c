#include "sim/cli/sweep/sweep_arguments.h"

#include <gmock/gmock.h>

#include "sim/base/error.h"
#include "tests/support/readable.h"
#include "tests/support/refusal.h"

namespace robosim::cli::sweep_arguments_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

SweepArguments parsed(const std::vector<std::string>& words) {
  return std::get<SweepArguments>(parse_sweep(words));
}

TEST(SweepArguments, SketchesComeFirstAndListsAreWordsOrRepetitions) {
  const SweepArguments sweep =
      parsed({"A", "b/B", "--map", "x", "y", "--seeds", "3..5", "--map", "z", "--robot", "r", "--target",
              "host,avr", "--for", "5s", "--goal", "none", "--min-rate", "99%"});
  EXPECT_THAT(sweep.sketches, ElementsAre("A", "b/B"));
  EXPECT_THAT(sweep.maps, ElementsAre("x", "y", "z"));
  EXPECT_THAT(sweep.robots, ElementsAre("r"));
  EXPECT_THAT(sweep.targets, ElementsAre("host", "avr"));
  EXPECT_EQ(sweep.first_seed, 3u);
  EXPECT_EQ(sweep.last_seed, 5u);
  EXPECT_EQ(sweep.each.request.for_ns, 5'000'000'000);
  EXPECT_EQ(sweep.each.request.goal, "none");
  EXPECT_EQ(sweep.min_rate, 0.99);
}

TEST(SweepArguments, WithoutOptionsItIsAHundredSeedsOnAllCores) {
  const SweepArguments sweep = parsed({});
  EXPECT_EQ(sweep.first_seed, 1u);
  EXPECT_EQ(sweep.last_seed, 100u);
  EXPECT_GE(sweep.jobs, 1u);
  EXPECT_FALSE(sweep.min_rate);
}

TEST(SweepArguments, OneSeedIsARangeToo) {
  const SweepArguments sweep = parsed({"--seeds", "17"});
  EXPECT_EQ(sweep.first_seed, 17u);
  EXPECT_EQ(sweep.last_seed, 17u);
}

struct RefusedSweep {
  std::vector<std::string> words;
  const char* says;
};

class RefusedSweepArguments : public ::testing::TestWithParam<RefusedSweep> {};

TEST_P(RefusedSweepArguments, AreToldInASentence) {
  EXPECT_THAT(test::refusal([&] { parse_sweep(GetParam().words); }), HasSubstr(GetParam().says));
}

INSTANTIATE_TEST_SUITE_P(
    All, RefusedSweepArguments,
    ::testing::Values(
        RefusedSweep{{"--seeds", "5..1"}, "got “5..1”; the first seed is greater than the last"},
        RefusedSweep{{"--seeds", "1.."},
                     "--seeds: expected one seed or a range FIRST..LAST, as in 1..100, got “1..”"},
        RefusedSweep{{"--seeds", "1-30"},
                     "--seeds: expected one seed or a range FIRST..LAST, as in 1..100, got “1-30”; did you "
                     "mean 1..30?"},
        RefusedSweep{{"--seeds", "1:5"}, "did you mean 1..5?"},
        RefusedSweep{{"--seeds", "1...5"}, "did you mean 1..5?"},
        RefusedSweep{{"--seeds", "18446744073709551616"}, "whole numbers up to 18446744073709551615"},
        RefusedSweep{{"--shard", "1-8"}, "--shard: expected PART/PARTS, as in 1/8 to 8/8"},
        RefusedSweep{{"--seeds", "0..18446744073709551615"}, "at most 1000000 seeds"},
        RefusedSweep{{"--jobs", "0"}, "--jobs: expected a whole number from 1 to 1024, got “0”"},
        RefusedSweep{{"--min-rate", "1.5"},
                     "--min-rate: expected a share from 0 to 1, as in 0.99 or 99%, got “1.5”"},
        RefusedSweep{{"--min-rate", "nan"}, "got “nan”"},
        RefusedSweep{{"--resume"}, "--resume requires --csv"},
        RefusedSweep{{"--resume", "--csv", "a", "--json"}, "--json would lack them"},
        RefusedSweep{{"--sure"}, "--sure requires --min-rate"},
        RefusedSweep{{"--stop-early"}, "--stop-early requires --min-rate"},
        RefusedSweep{{"--min-rate", "0.99", "--sure"},
                     "100 seeds cannot prove a rate of 0.99, even if all runs succeed; 381 could"},
        RefusedSweep{{"--min-rate", "1", "--sure"}, "no number of runs can prove a rate of 1"},
        RefusedSweep{{"A", "A"}, "the sketch A is given twice"},
        RefusedSweep{{"--map", "x", "y", "x"}, "--map x is given twice"},
        RefusedSweep{{"--map", "oval", "PidFollower"},
                     "--map: “PidFollower” is a sketch; put sketches before the options"},
        RefusedSweep{{"--robot", "uno5", "."}, "--robot: “.” is a sketch"},
        RefusedSweep{{"--profile", "real"}, "expected ideal, typical, typical@1 or typical@2, got “real”"},
        RefusedSweep{{"--seed", "3"}, "did you mean --seeds?"}),
    test::numbered(&RefusedSweep::words));

}  // namespace robosim::cli::sweep_arguments_test
