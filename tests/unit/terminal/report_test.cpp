#include "sim/view/terminal/report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/unit/terminal/terminal_looks.h"

namespace robosim::terminal {
namespace report_test {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

wire::Sample at(double x_mm, double y_mm, double yaw_rad = 0.0) {
  wire::Sample sample;
  sample.x_mm = x_mm;
  sample.y_mm = y_mm;
  sample.yaw_rad = yaw_rad;
  return sample;
}

Report report() {
  Report r;
  r.sketch = "PidFollower";
  r.map = "oval";
  r.robot = "uno5";
  r.target = "host";
  r.started.stations = {{1, "1", 0, 0}, {2, "dock", 3, 0}};
  r.result.verdict = "reached";
  r.result.why = "2 laps are done";
  r.result.goal = "laps:2";
  r.result.profile = "typical";
  r.result.time_s = 20.0;
  r.result.metrics.distance_m = 10.0;
  r.result.metrics.laps_s = {10.5, 9.25};
  r.result.metrics.cross_track_rms_mm = 4.04;
  r.result.metrics.cross_track_max_mm = 17.0;
  r.result.metrics.collisions = 3;
  r.result.metrics.stations = {"dock"};
  r.result.events = {{1.2, "station dock visited"}};
  r.result.serial = "one\ntwo\nthree\nfour\nfive\nsix\n";
  return r;
}

TEST(EndScreen, SaysWhatHappenedAtFirstSight) {
  const std::string screen = end_screen(report(), nullptr, 78, kPlain);
  EXPECT_THAT(screen, StartsWith("PidFollower · uno5 on oval · goal laps:2 · seed 1 · typical · host\n"
                                 "reached: 2 laps are done\n"));
  EXPECT_THAT(screen, HasSubstr("time         20.00 s · distance 10.00 m · mean 0.50 m/s"));
  EXPECT_THAT(screen, HasSubstr("laps         2, each 10.50 9.25 s"));
  EXPECT_THAT(screen, HasSubstr("cross-track  4.0 mm RMS, 17.0 mm at most"));
  EXPECT_THAT(screen, HasSubstr("collisions   3\n"));
  EXPECT_THAT(screen, HasSubstr("stations     1 of 2 visited: dock"));
  EXPECT_THAT(screen, HasSubstr("1.20 s  station dock visited\n"));
  EXPECT_THAT(screen, HasSubstr("  two\n  three\n  four\n  five\n  six\n"));
  EXPECT_THAT(screen, Not(HasSubstr("  one\n")));
  EXPECT_THAT(screen, HasSubstr("--target avr"));
  EXPECT_THAT(screen, Not(HasSubstr("next:")));
  EXPECT_THAT(screen, Not(HasSubstr("wall time")));
}

TEST(EndScreen, TellsOfNoDistanceFromTheLineWhereNothingSeesIt) {
  Report r = report();
  r.sees_lines = false;
  EXPECT_THAT(end_screen(r, nullptr, 78, kPlain), Not(HasSubstr("cross-track")));
}

TEST(EndScreen, SaysHowOftenTheWatchdogResetTheChip) {
  Report r = report();
  EXPECT_THAT(end_screen(r, nullptr, 200, kPlain), Not(HasSubstr("watchdog")));
  r.result.watchdog_resets = 1;
  EXPECT_THAT(end_screen(r, nullptr, 200, kPlain), HasSubstr("watchdog     reset the chip once"));
  r.result.watchdog_resets = 2;
  EXPECT_THAT(end_screen(r, nullptr, 200, kPlain), HasSubstr("watchdog     reset the chip 2 times"));
}

TEST(EndScreen, NamesTheLinesThatDividedByZero) {
  Report r = report();
  EXPECT_THAT(end_screen(r, nullptr, 200, kPlain), Not(HasSubstr("division")));
  r.result.divisions_by_zero = {{{"mean", "My.ino", 3}, 0.394, 214}, {{"", "My.ino", 9}, 2.0, 1}};
  EXPECT_THAT(end_screen(r, nullptr, 200, kPlain),
              HasSubstr("division     by zero in mean, My.ino:3 (214 times, first at 0.39 s); at My.ino:9 "
                        "(at 2.00 s). A chip "
                        "continues there"));
}

TEST(EndScreen, NamesWhatTheHostLacks) {
  Report r = report();
  EXPECT_THAT(end_screen(r, nullptr, 200, kPlain), Not(HasSubstr("lacks")));
  r.result.lacks = {{"CLKPR", {"setup", "Slow.ino", 3}}};
  EXPECT_THAT(end_screen(r, nullptr, 200, kPlain),
              HasSubstr("lacks        CLKPR in Slow.ino:3. The host has no such feature; run with "
                        "--target avr to see the effect."));
}

TEST(EndScreen, NamesPinsWithoutPartsAndPartsWithoutUse) {
  Report r = report();
  EXPECT_THAT(end_screen(r, nullptr, 200, kPlain), Not(HasSubstr("wiring ")));
  r.result.usage.unwired = {{"D3", "driven"}};
  EXPECT_THAT(end_screen(r, nullptr, 200, kPlain),
              HasSubstr("wiring       nothing is wired to: D3 (driven)\n"));
  r.result.usage.unused = {"buzzer", "LED2"};
  r.result.usage.steady = {{"start", "HIGH"}};
  EXPECT_THAT(end_screen(r, nullptr, 200, kPlain),
              HasSubstr("D3 (driven) · never used: buzzer, LED2 · never changed: start (HIGH)\n"));
}

TEST(EndScreen, PointsToTheCausesOfAFailureOnAnAvr) {
  Report r = report();
  const auto screen = [&](const char* target, const char* verdict) {
    r.target = target;
    r.result.verdict = verdict;
    return end_screen(r, nullptr, 200, kPlain);
  };
  EXPECT_THAT(screen("avr", "lost"), HasSubstr("why: robosim why, with the same arguments, traces this "
                                               "verdict to the lines that caused it"));
  for (const char* verdict : {"reached", "interrupted", "over_budget"})
    EXPECT_THAT(screen("avr", verdict), Not(HasSubstr("robosim why"))) << verdict;
  for (const char* target : {"host", "stm32"})
    EXPECT_THAT(screen(target, "lost"), Not(HasSubstr("robosim why"))) << target;
}

TEST(EndScreen, NamesTheTargetOfTheRobotsChipWhereItRanOnTheHost) {
  Report r = report();
  r.chip_target = "avr";
  EXPECT_THAT(
      end_screen(r, nullptr, 200, Look{}),
      HasSubstr(
          "The board's chip has little memory and a 16-bit int: run the sketch there with --target avr."));
  r.chip_target = "stm32";
  EXPECT_THAT(end_screen(r, nullptr, 200, Look{}), HasSubstr("run the sketch there with --target stm32."));
  r.chip_target = "avr";
  r.board = "nano";
  r.chip_ram_bytes = 2048;
  EXPECT_THAT(end_screen(r, nullptr, 200, Look{}),
              HasSubstr("The chip of the board nano has 2 KB of memory and a 16-bit int:"));
  r.target = "stm32";
  EXPECT_THAT(end_screen(r, nullptr, 200, Look{}), Not(HasSubstr("run the sketch there")));
}

TEST(EndScreen, WrapsLongSentencesUnderTheirLabel) {
  Report r = report();
  r.result.next = "look at pin 5: it stayed low for the whole run, so the left motor never turned";
  EXPECT_THAT(end_screen(r, nullptr, 50, kPlain),
              HasSubstr("next: look at pin 5: it stayed low for the whole\n"
                        "      run, so the left motor never turned\n"));
}

TEST(EndScreen, ShowsWallTimeOnlyWhenItWasMeasured) {
  Report r = report();
  r.wall_s = 0.05;
  EXPECT_THAT(end_screen(r, nullptr, 78, kPlain), HasSubstr("wall time    0.050 s, 400 times real time\n"));
}

TEST(EndScreen, DrawsTrailStationsAndRobotOnTheMap) {
  const auto map = map::parse_map("1111\n", "t.map");
  Report r = report();
  r.trail.add(at(50, 50));
  r.trail.add(at(250, 50));
  const std::string screen = end_screen(r, &map, 78, kPlain);
  const std::string second = screen.substr(screen.find('\n', screen.find('\n') + 1) + 1);
  // One cell is 8 x 4 characters. The stations' centres are in the third row.
  EXPECT_THAT(second, StartsWith("    1⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉→·······d\n")) << screen;
}

// The robot starts on a path, at a point that is not the middle of a cell.
TEST(EndScreen, MarksTheStartWhereTheRobotBegins) {
  const auto map = map::parse_map(
      "+++\nsize = [\"400 mm\", \"300 mm\"]\n[[path]]\nfrom = [\"20 mm\", \"210 mm\"]\nsegments = [{ length "
      "= "
      "\"360 mm\" }]\n+++\n",
      "t.map");
  Report r = report();
  r.started.stations = {};
  r.trail.add(at(20, 210));
  r.trail.add(at(300, 210));
  EXPECT_THAT(end_screen(r, &map, 78, kPlain), HasSubstr("S⠤⠤⠤"));
}

TEST(EndScreen, DrawsNoTrailToWhereAScriptPutsTheRobot) {
  const auto map = map::parse_map("1111\n", "t.map");
  Report r = report();
  r.trail.add(at(50, 50));
  r.trail.add(wire::note_of({0, 0, result::ScriptActed{"place", "", "2,0 E"}}));
  r.trail.add(at(250, 50));
  EXPECT_THAT(end_screen(r, &map, 78, kPlain), Not(HasSubstr("⠉⠉")));
}

TEST(EndScreen, LeavesOutTheEmptyFloorAround) {
  const auto map = map::parse_map("____\n_11_\n____\n____\n", "t.map");
  Report r = report();
  r.started.stations = {};
  r.started.x = r.started.y = 1;
  // The picture shows two cells of 8 x 4 characters. The line is between the second and the third row.
  EXPECT_THAT(end_screen(r, &map, 78, kPlain), StartsWith("\n\n    S·······\n\n\nPidFollower"));
}

TEST(EndScreen, ColoursTheVerdictByItsStatus) {
  Report r = report();
  EXPECT_THAT(end_screen(r, nullptr, 78, {true, true}), HasSubstr("\033[0;1;32mreached:\033[0m 2 laps"));
  r.result.verdict = "lost";
  r.result.status = 1;
  EXPECT_THAT(end_screen(r, nullptr, 78, {true, true}), HasSubstr("\033[0;1;31mlost:\033[0m"));
}

TEST(EndScreen, APictureHasAtMostTwentyRowsWhateverTheMap) {
  for (const int side : {3, 30, 90, 300}) {
    std::string text;
    for (int y = 0; y < side; ++y) text += std::string(static_cast<std::size_t>(side), '1') + "\n";
    const auto map = map::parse_map("+++\nfloor = \"raster\"\n+++\n" + text, "t.map");
    Report r = report();
    r.started = {};
    const std::string without = end_screen(r, nullptr, 78, kPlain);
    r.trail.add(at(50, 50));
    const std::string with = end_screen(r, &map, 78, kPlain);
    const auto rows =
        std::count(with.begin(), with.end(), '\n') - std::count(without.begin(), without.end(), '\n');
    EXPECT_LE(rows, 20 + 2) << side;  // plus a sentence and a blank line
    EXPECT_GE(rows, 4) << side;
  }
}

TEST(Trail, StaysBoundedAndKeepsTheLastPoint) {
  Trail trail;
  for (int i = 0; i <= 100'000; ++i) trail.add(at(i, 0));
  EXPECT_LE(trail.points().size(), 8192u);
  EXPECT_GE(trail.points().size(), 4096u);
  EXPECT_EQ(trail.last().x, 100.0);
  EXPECT_EQ(trail.points()[0].x, 0.0);
}

TEST(Trail, PointsStayEvenlySpaced) {
  Trail trail;
  for (int i = 0; i < 50'000; ++i) trail.add(at(i, 0));
  const auto& points = trail.points();
  const double step = points[1].x - points[0].x;
  for (std::size_t i = 1; i < points.size(); ++i) ASSERT_NEAR(points[i].x - points[i - 1].x, step, 1e-9) << i;
}

}  // namespace report_test
}  // namespace robosim::terminal
