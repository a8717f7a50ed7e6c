#include "sim/campaign/check/check_result.h"

#include <gmock/gmock.h>

#include "sim/cli/check/test_report.h"

namespace robosim::cli::check_result_test {

using namespace campaign;

using ::testing::HasSubstr;
using ::testing::Optional;

result::RunResult run(const std::string& verdict) {
  result::RunResult result;
  result.verdict = verdict;
  result.why = "That is why.";
  return result;
}

Check check() {
  Check check;
  check.expect = {"reached"};
  return check;
}

const Figure* figure(const std::string& name) {
  for (const Figure& figure : figures()) {
    if (figure.name == name) return &figure;
  }
  return nullptr;
}

TEST(WhyFailed, AsksForTheVerdictFirst) {
  EXPECT_EQ(why_failed(check(), run("reached")), std::nullopt);
  EXPECT_THAT(why_failed(check(), run("lost")), Optional(std::string("lost: That is why.")));
  Check either = check();
  either.expect = {"stuck", "lost"};
  EXPECT_EQ(why_failed(either, run("lost")), std::nullopt);
  EXPECT_THAT(why_failed(either, run("reached")),
              Optional(HasSubstr("reached (expected: stuck or lost): That")));
}

TEST(WhyFailed, ALimitBelongsToWhatIsAllowed) {
  Check limited = check();
  limited.limits = {{figure("cross_track_rms_mm"), 1.0, 2.5}};
  result::RunResult result = run("reached");
  for (const double inside : {1.0, 2.5}) {
    result.metrics.cross_track_rms_mm = inside;
    EXPECT_EQ(why_failed(limited, result), std::nullopt);
  }
  result.metrics.cross_track_rms_mm = 2.5000001;
  EXPECT_THAT(why_failed(limited, result),
              Optional(std::string("cross_track_rms_mm: expected at most 2.5, got 2.5000001")));
  result.metrics.cross_track_rms_mm = 0.123456;
  EXPECT_THAT(why_failed(limited, result),
              Optional(std::string("cross_track_rms_mm: expected at least 1, got 0.1235")));
}

TEST(WhyFailed, AllLimitsThatAreBrokenAreNamed) {
  Check limited = check();
  limited.limits = {{figure("cross_track_rms_mm"), std::nullopt, 2.5},
                    {figure("cross_track_max_mm"), std::nullopt, 50.0},
                    {figure("off_line_s"), std::nullopt, 1.0}};
  result::RunResult result = run("reached");
  result.metrics.cross_track_rms_mm = 3.0;
  result.metrics.cross_track_max_mm = 20.0;
  result.metrics.off_line_s = 2.0;
  EXPECT_THAT(why_failed(limited, result),
              Optional(std::string("cross_track_rms_mm: expected at most 2.5, got 3; "
                                   "off_line_s: expected at most 1, got 2")));
}

TEST(WhyFailed, EveryLapMustBeWithinItsLimitAndThereMustBeOne) {
  Check limited = check();
  limited.limits = {{figure("laps_s"), std::nullopt, 9.0}};
  result::RunResult result = run("reached");
  EXPECT_THAT(why_failed(limited, result), Optional(HasSubstr("laps_s was not measured")));
  result.metrics.laps_s = {8.0, 8.5};
  EXPECT_EQ(why_failed(limited, result), std::nullopt);
  result.metrics.laps_s = {8.0, 9.5};
  EXPECT_THAT(why_failed(limited, result), Optional(HasSubstr("laps_s: expected at most 9, got 9.5")));
}

TEST(WhyFailed, WhatADetectorHasSeenIsAFailure) {
  result::RunResult result = run("reached");
  result.detected.push_back({"blind", "it drove on", "Look", {"loop", "Sketch.ino", 3}, 1.5, 2});
  const auto why = why_failed(check(), result);
  ASSERT_TRUE(why);
  EXPECT_EQ(*why,
            "detected: it drove on in loop, Sketch.ino:3 (2 times, first at 1.50 s). Look (detect = false "
            "turns the "
            "detectors off)");
  EXPECT_TRUE(is_of_detectors(*why));
}

TEST(WhyFailed, SerialTextsFollowEachOther) {
  Check talks = check();
  talks.serial = {"ready", "go"};
  result::RunResult result = run("reached");
  result.serial = "ready\nset\ngo\n";
  EXPECT_EQ(why_failed(talks, result), std::nullopt);
  result.serial = "go\nready\n";
  EXPECT_THAT(why_failed(talks, result),
              Optional(HasSubstr("did not send “go” over its serial port after “ready”")));
}

TEST(WhyFailed, WhatPartsShowFollowsEachOther) {
  Check display = check();
  display.shows = {"lcd: \"Lap 1", "Lap 2"};
  result::RunResult result = run("reached");
  result.shown = "lcd: \"Lap 1|9.4 s\"\nlcd: \"Lap 2|9.3 s\"\n";
  EXPECT_EQ(why_failed(display, result), std::nullopt);
  result.shown = "lcd: \"Lap 1|9.4 s\"\n";
  EXPECT_THAT(why_failed(display, result),
              Optional(HasSubstr("no part showed “Lap 2” after “lcd: \"Lap 1”")));
}

TEST(WhyFailed, StationsMayBeVisitedInAnyOrder) {
  Check visits = check();
  visits.stations = {"2", "dock"};
  result::RunResult result = run("reached");
  result.metrics.stations = {"dock", "1", "2"};
  EXPECT_EQ(why_failed(visits, result), std::nullopt);
  result.metrics.stations = {"1", "2"};
  EXPECT_THAT(why_failed(visits, result), Optional(HasSubstr("did not visit station dock")));
}

TEST(Figures, OfAChipAreKnownOnAChipOnly) {
  result::RunResult result = run("reached");
  for (const Figure& each : figures()) {
    if (each.chip_only) {
      EXPECT_THAT(each.values(result), ::testing::IsEmpty()) << each.name;
    }
  }
  result.resources.emplace();
  result.resources->ram_bytes = 165;
  EXPECT_THAT(figure("ram_bytes")->values(result), ::testing::ElementsAre(165.0));
  EXPECT_THAT(figure("loop_us_max")->values(result), ::testing::IsEmpty()) << "loop() was not found";
  result.resources->loops = 2;
  result.resources->loop_us_max = 17.0;
  EXPECT_THAT(figure("loop_us_max")->values(result), ::testing::ElementsAre(17.0));
}

SketchResult sketch_with(const std::vector<ExitStatus>& statuses) {
  SketchResult sketch;
  for (const ExitStatus status : statuses) {
    CheckResult& result = sketch.results.emplace_back();
    result.name = "check";
    result.status = status;
    if (status != ExitStatus::ok) result.why = "Because.";
  }
  return sketch;
}

TEST(StatusOfChecks, IsTheWorst) {
  using enum ExitStatus;
  EXPECT_EQ(sketch_with({ok, ok}).status(), ok);
  EXPECT_EQ(sketch_with({timeout, ok}).status(), timeout);
  EXPECT_EQ(sketch_with({timeout, failed}).status(), failed);
  EXPECT_EQ(sketch_with({bad_input, failed}).status(), bad_input);
  EXPECT_EQ(sketch_with({bad_input, tool_missing}).status(), tool_missing);
  EXPECT_EQ(sketch_with({internal, tool_missing}).status(), internal);
  SketchResult broken = sketch_with({ok});
  broken.problem = SketchResult::Problem();
  EXPECT_EQ(broken.status(), bad_input);
}

TEST(ReportOfManySketches, HasALineForEach) {
  std::vector<SketchResult> sketches{
      sketch_with({ExitStatus::ok, ExitStatus::ok}), sketch_with({ExitStatus::ok, ExitStatus::failed}), {}};
  sketches[0].name = "anna";
  sketches[1].name = "ben";
  sketches[2].name = "cleo";
  sketches[2].problem = SketchResult::Problem();
  sketches[2].problem->line = "cleo.ino:3: error: expected ‘;’";
  EXPECT_EQ(class_report(sketches),
            "anna  passed  2 of 2\n"
            "ben   FAILED  1 of 2  check: Because.\n"
            "cleo  ERROR   cleo.ino:3: error: expected ‘;’\n"
            "1 of 3 sketches passed all checks\n");
}

TEST(ReportOfManySketches, KeepsWhatASketchIsCalledInItsLine) {
  SketchResult sketch = sketch_with({ExitStatus::failed});
  sketch.name = "anna\nben   passed  1 of 1";
  sketch.results[0].name = "a\n::stop-commands::x";
  sketch.results[0].where = "oval\x1B[2J";
  sketch.results[0].why = "in f\nBecause.";
  sketch.results[0].replay = "robosim run 'a\nb'";
  EXPECT_EQ(class_report({sketch}),
            "anna\\x0aben   passed  1 of 1  FAILED  0 of 1  a\\x0a::stop-commands::x: in f\\x0aBecause.\n"
            "0 of 1 sketches passed all checks\n");
  EXPECT_EQ(sketch_report(sketch),
            "FAILED  a\\x0a::stop-commands::x  oval\\x1b[2J\n"
            "        why: in f\\x0aBecause.\n"
            "        see: robosim run 'a\\x0ab' --view\n"
            "0 of 1 check passed\n");
  sketch.problem = SketchResult::Problem();
  sketch.problem->line = "a\nb";
  EXPECT_EQ(class_report({sketch}),
            "anna\\x0aben   passed  1 of 1  ERROR   a\\x0ab\n0 of 1 sketches passed all checks\n");
}

}  // namespace robosim::cli::check_result_test
