#include "sim/campaign/sweep/sweep_table.h"

#include <gmock/gmock.h>

#include <fstream>

#include "sim/base/error.h"
#include "sim/base/file.h"
#include "sim/cli/sweep/sweep_report.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_folder.h"

namespace robosim::cli::sweep_table_test {

using namespace campaign;

using ::testing::HasSubstr;
using ::testing::Not;

Combination combination(const std::string& map) {
  Combination c;
  c.inputs.sketch = c.title = "My, Sketch";
  c.inputs.map = map;
  c.inputs.robot = "uno5";
  c.inputs.target = "host";
  c.fingerprint.parts = {"00000001", "00000002", "00000003", "00000004"};
  c.replay = "robosim run 'My, Sketch' --map " + map;
  return c;
}

/// Returns a plan of eight runs, 0 to 7: seeds 1 to 4 on each of two maps.
SweepPlan plan() {
  SweepPlan plan;
  plan.combinations = {combination("oval"), combination("tight")};
  plan.seeds = 4;
  return plan;
}

result::RunResult result(std::uint64_t seed, const std::string& verdict) {
  result::RunResult r;
  r.verdict = verdict;
  r.why = "It said \"no\",\nand stopped.";
  r.time_s = 2.5;
  r.seed = seed;
  r.metrics.laps_s = {2.0, 4.0};
  r.metrics.stations = {"1", "dock"};
  r.trace_hash = "1:ab";
  return r;
}

std::string row(const SweepPlan& p, std::size_t run, const std::string& verdict = "reached") {
  return sweep_row(p.combination_of(run), result(p.seed_of(run), verdict));
}

TEST(SweepTable, ARowHasTheColumnsOfTheHeaderInOneLine) {
  EXPECT_EQ(
      sweep_header(),
      "sketch,map,robot,target,seed,verdict,time_s,distance_m,cross_track_rms_mm,cross_track_max_mm,"
      "off_line_s,"
      "collisions,energy_j,laps,lap_best_s,lap_mean_s,stations,score,stack_bytes_max,loop_us_max,command,"
      "trace_hash,inputs,why"
      "\n");
  EXPECT_EQ(row(plan(), 5, "lost"),
            "\"My, Sketch\",tight,uno5,host,2,lost,2.5,0,0,0,0,0,0,2,2,3,2,,,,"
            "\"robosim run 'My, Sketch' --map tight --seed 2\",1:ab,"
            "00000001-00000002-00000003-00000004-30390502,\"It said \"\"no\"\", and stopped.\"\n");
}

TEST(SweepTable, ARowHasTheScoreOfACompetition) {
  result::RunResult r = result(1, "reached");
  r.metrics.score = 18.75;
  EXPECT_THAT(sweep_row(combination("oval"), r), HasSubstr(",2,18.75,,,"));
  const std::string table = sweep_header() + sweep_row(combination("oval"), r);
  EXPECT_EQ(read_sweep_rows(table, "a.csv", plan()).at(0).outcome.score, 18.75);
}

TEST(SweepTable, AnOlderOneIsContinuedWithItsOwnColumns) {
  const SweepPlan p = plan();
  for (const Columns columns : {Columns::without_command, Columns::without_score}) {
    const test::TemporaryFolder folder;
    const std::filesystem::path file = folder.path() / "a.csv";
    const auto old_row = [&](std::size_t run) {
      return sweep_row(p.combination_of(run), result(p.seed_of(run), "reached"), columns);
    };
    const std::string begun = sweep_header(columns) + old_row(0);
    EXPECT_THAT(begun, Not(HasSubstr("command")));
    EXPECT_THAT(begun, Not(HasSubstr("robosim run")));
    EXPECT_EQ(begun.find("score") == begun.npos, columns == Columns::without_score);
    std::ofstream(file) << begun;
    std::vector<SweepOutcome> outcomes(p.runs());
    SweepTable table(file, true, p, outcomes);
    EXPECT_TRUE(outcomes[0].reached());
    ASSERT_EQ(table.columns(), columns);
    table.add(1, old_row(1));
    table.finish();
    EXPECT_EQ(read_file(file), begun + old_row(1));
  }
}

TEST(SweepTable, OnAChipARowHasItsResources) {
  result::RunResult r = result(1, "reached");
  r.resources = result::Resources{};
  r.resources->stack_bytes_max = 99;
  r.resources->loops = 3;
  r.resources->loop_us_max = 12.5;
  EXPECT_THAT(sweep_row(combination("oval"), r), HasSubstr(",99,12.5,"));
}

TEST(SweepTable, ReadsWhatItWrites) {
  const SweepPlan p = plan();
  const auto rows = read_sweep_rows(sweep_header() + row(p, 6, "lost") + row(p, 1), "a.csv", p);
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].run, 6u);
  EXPECT_EQ(rows[0].outcome.verdict, "lost");
  EXPECT_EQ(rows[0].outcome.time_s, 2.5);
  EXPECT_EQ(rows[0].outcome.why, "It said \"no\", and stopped.");
  EXPECT_EQ(rows[1].run, 1u);
  EXPECT_EQ(rows[1].line, row(p, 1));
}

TEST(SweepTable, RefusesRowsThatItCannotGoOnWith) {
  const SweepPlan p = plan();
  const auto refusal = [&](const std::string& text) {
    return test::refusal([&] { read_sweep_rows(text, "a.csv", p); }, "not refused");
  };
  EXPECT_THAT(refusal("t_us,x_mm\n"), HasSubstr("a.csv:1: expected the header"));
  EXPECT_THAT(refusal(sweep_header() + "a,b\n"), HasSubstr("a.csv:2: expected a row"));
  EXPECT_THAT(refusal(sweep_header() + "\n"), HasSubstr("a.csv:2: expected a row"));
  EXPECT_THAT(refusal(sweep_header() + row(p, 0) + row(p, 0)),
              HasSubstr("a.csv:3: duplicate row: this run already has one"));
  SweepPlan other = p;
  other.combinations[0].fingerprint.parts[1] = "ffffffff";
  EXPECT_THAT(refusal(sweep_header() + row(other, 0)), HasSubstr("a.csv:2: the map has changed"));
  other = p;
  other.first_seed = 2;
  EXPECT_THAT(refusal(sweep_header() + row(other, 3)), HasSubstr("seed 5) is not part of this sweep"));
}

TEST(SweepTable, AFlippedBitIsCalledDamageWhereverItIs) {
  const SweepPlan p = plan();
  const std::string before = sweep_header() + row(p, 0);
  const std::string whole = row(p, 1);
  for (std::size_t i = 0; i + 1 < whole.size(); ++i) {
    std::string flipped = whole;
    flipped[i] = static_cast<char>(flipped[i] ^ 1);
    EXPECT_THAT(test::refusal([&] { read_sweep_rows(before + flipped, "a.csv", p); }),
                testing::AnyOf(HasSubstr("a.csv:3: expected a row of a sweep"),
                               HasSubstr("a.csv:3: this row is damaged: its checksum")))
        << flipped;
  }
}

TEST(SweepTable, RowsWithoutAChecksumAreOfAFormerVersionAndAreGoneOnWith) {
  const SweepPlan p = plan();
  std::string old = row(p, 3);
  const std::size_t inputs = old.find("00000004-") + 8;
  old.erase(inputs, 9);
  EXPECT_EQ(read_sweep_rows(sweep_header() + old, "a.csv", p).size(), 1u);
}

TEST(SweepTable, ASecondSweepDoesNotWriteIntoTheFileOfTheFirst) {
  const test::TemporaryFolder folder;
  const SweepPlan p = plan();
  std::vector<SweepOutcome> outcomes(p.runs());
  const auto file = folder.path() / "a.csv";
  {
    const SweepTable first(file, false, p, outcomes);
    for (const bool resume : {false, true}) {
      EXPECT_THAT(test::refusal([&] { SweepTable(folder.path() / "." / "a.csv", resume, p, outcomes); }),
                  HasSubstr("a.csv: this file is already being written by another robosim"));
    }
  }
  EXPECT_NO_THROW(SweepTable(file, true, p, outcomes));
}

TEST(SweepTable, ARunThatFailedByOurFaultIsMadeAgainAndRowsEndInTheirOrder) {
  const test::TemporaryFolder folder;
  const SweepPlan p = plan();
  const auto file = folder.path() / "a.csv";
  std::ofstream(file) << sweep_header() << row(p, 5) << row(p, 2, kErrorVerdict) << row(p, 4).substr(0, 40);
  std::vector<SweepOutcome> outcomes(p.runs());
  {
    SweepTable table(file, true, p, outcomes);
    EXPECT_EQ(read_file(file), sweep_header() + row(p, 5));
    for (const std::size_t run : {0u, 1u, 2u, 3u, 4u, 6u, 7u}) {
      EXPECT_FALSE(outcomes[run].made());
      table.add(run, row(p, run));
      EXPECT_THAT(read_file(file), HasSubstr(row(p, run))) << "nothing may be lost if the sweep is killed";
    }
    table.finish();
  }
  EXPECT_TRUE(outcomes[5].made());
  std::string whole = sweep_header();
  for (std::size_t run = 0; run < p.runs(); ++run) whole += row(p, run);
  EXPECT_EQ(read_file(file), whole);
}

TEST(SweepTable, AFileWithoutAnyRunMayBeBegunAgain) {
  const test::TemporaryFolder folder;
  const SweepPlan p = plan();
  const auto file = folder.path() / "a.csv";
  std::vector<SweepOutcome> outcomes(p.runs());
  { SweepTable(file, false, p, outcomes); }
  SweepTable(file, false, p, outcomes).add(0, row(p, 0));
  EXPECT_EQ(read_file(file), sweep_header() + row(p, 0));
  EXPECT_THROW(SweepTable(file, false, p, outcomes), InputError);
}

SweepOutcome reached() { return {"reached", 10.0, ""}; }
SweepOutcome lost() { return {"lost", 1.0, "It left the line."}; }

TEST(SweepReport, CountsEachCombinationAndShowsHowToMakeFailuresAgain) {
  SweepOptions options;
  options.min_rate = 0.75;
  const std::string report = sweep_report(
      options, plan(), {reached(), reached(), reached(), lost(), lost(), reached(), lost(), reached()});
  EXPECT_EQ(report, R"(sketch      map    robot  target  runs  reached    rate     95 % interval  mean time
My, Sketch  oval   uno5   host       4        3  0.7500  0.3006 .. 0.9545    10.00 s
My, Sketch  tight  uno5   host       4        2  0.5000  0.1500 .. 0.8500    10.00 s
My, Sketch  all    uno5   host       8        5  0.6250  0.3057 .. 0.8632    10.00 s

My, Sketch on oval with uno5, target host: 1 of 4 did not reach the goal (1 lost)
  seed 4: lost. It left the line.
    robosim run 'My, Sketch' --map oval --seed 4

My, Sketch on tight with uno5, target host: 2 of 4 did not reach the goal (2 lost)
  seed 1: lost. It left the line.
    robosim run 'My, Sketch' --map tight --seed 1
  seed 3: lost. It left the line.
    robosim run 'My, Sketch' --map tight --seed 3

--min-rate 0.75: not met by My, Sketch on tight with uno5, target host: 2 of 4 reached the goal, and 3 of 4 are needed
)");
}

TEST(SweepReport, ShowsTheScoresOfACompetition) {
  std::vector<SweepOutcome> outcomes(8, reached());
  outcomes[0].score = 10.0;
  outcomes[1].score = 11.0;
  outcomes[2].score = 13.5;
  EXPECT_THAT(sweep_report({}, plan(), outcomes), HasSubstr("  score: least, mean, most\n"));
  EXPECT_THAT(sweep_report({}, plan(), outcomes), HasSubstr("    10.00 s   10.00 .. 11.50 .. 13.50\n"));
}

TEST(SweepReport, SaysWhereTheRunsHaveTheRateAndDoNotShowIt) {
  SweepOptions options;
  options.min_rate = 0.75;
  EXPECT_THAT(sweep_report(options, plan(), std::vector<SweepOutcome>(8, reached())),
              HasSubstr("\n\n--min-rate 0.75: met\nThese runs have that rate, but they do not "
                        "prove it in general, because the interval begins below it. 12 seeds without a "
                        "failure would prove it (--sure demands "
                        "this).\n"));
  options.min_rate = 0.5;
  EXPECT_THAT(sweep_report(options, plan(), std::vector<SweepOutcome>(8, reached())),
              Not(HasSubstr("These runs have that rate")));
}

TEST(SweepReport, ARateIsNeverRoundedUpToOne) {
  SweepPlan p = plan();
  p.combinations.pop_back();
  p.seeds = 100'000;
  std::vector<SweepOutcome> outcomes(p.seeds, reached());
  outcomes[7] = lost();
  EXPECT_THAT(sweep_report({}, p, outcomes), HasSubstr(" 0.9999  0.9999 .. 1.0000 "));
}

TEST(SweepReport, WithStopEarlyRunsBeyondTheDecisionDoNotCount) {
  SweepOptions options;
  options.min_rate = 1.0;
  options.stop_early = true;
  const std::vector<SweepOutcome> outcomes{reached(), lost(),    reached(), lost(),
                                           reached(), reached(), reached(), reached()};
  const auto tallies = count_runs(options, plan(), outcomes);
  EXPECT_EQ(tallies[0].runs(), 2);
  EXPECT_TRUE(tallies[0].missed());
  EXPECT_EQ(tallies[1].runs(), 4);
  EXPECT_TRUE(tallies[1].met());
  EXPECT_THAT(sweep_report(options, plan(), outcomes), HasSubstr("stopped after 2 of 4 runs"));
}

TEST(SweepReport, RunsThatWereNotMadeAreNotCounted) {
  SweepOptions options;
  options.min_rate = 0.5;
  std::vector<SweepOutcome> outcomes(8);
  outcomes[0] = reached();
  const std::string report = sweep_report(options, plan(), outcomes);
  EXPECT_THAT(report, HasSubstr("tight  uno5   host       0        0"));
  EXPECT_THAT(report, Not(HasSubstr("met")));
}

}  // namespace robosim::cli::sweep_table_test
