// Tests the matchers of the GoogleTest harness, and the messages of failed requirements.
#include <gtest/gtest-spi.h>
#include <robosim/testing.h>
#include <stdlib.h>

#include <cmath>
#include <stdexcept>

#include "tests/support/caught_failures.h"

namespace matchers_test {

using namespace robosim::testing;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

std::string explanation(const Requirement& requirement, const Drive& drive) {
  testing::StringMatchResultListener said;
  testing::ExplainMatchResult(requirement, drive, &said);
  return said.str();
}

constexpr const char* kSketches = FAILING_SKETCHES;

Trial pid_on_oval() { return {.sketch = "PidFollower", .map = "oval"}; }
Trial with(const char* failing_sketch) { return {.sketch = std::string(kSketches) + "/" + failing_sketch}; }
Trial forgetful() {
  Trial trial = with("Forgetful");
  trial.map = "d";
  trial.robot = "uno3";
  return trial;
}

TEST(Follows, NeedsADriveAndEveryMillisecondOfIt) {
  Simulation robot(pid_on_oval());
  EXPECT_THAT(explanation(Follows(line(), within(15_mm)), robot.so_far()),
              HasSubstr("it drove 0 mm in total"));
  const Drive drive = robot.run_for(3_s);
  const Length worst = drive.worst().cross_track;
  EXPECT_GT(worst.mm, 1.0);
  EXPECT_THAT(drive, Follows(line(), within(worst)));
  EXPECT_THAT(drive, Not(Follows(line(), within(mm(worst.mm - 0.01)))));
  EXPECT_THAT(robot, Follows(line(), within(worst))) << "a Simulation stands for the run so far";
}

TEST(NeverDrives, KnowsTheLineByItsColour) {
  for (const char* paint : {"black on white", "white on black"}) {
    const std::string map = "+++\npaint = \"" + std::string(paint) +
                            "\"\ngoal = \"none\"\n+++\n"
                            "____________\n____________\n__S11111111_\n____________\n____________\n"
                            "____________\n____________\n____________\n____________\n";
    for (const char* profile : {"ideal", "typical"}) {
      Simulation robot({.sketch = "PidFollower", .map = map, .profile = profile});
      EXPECT_FALSE(robot.moment().off_line) << paint << ", " << profile;
      robot.place(6, 2, 'S');  // its sensors are ahead of it, over the floor
      EXPECT_THAT(robot.run_for(100_ms), Not(NeverDrives(off_the_line()))) << paint << ", " << profile;
    }
  }
}

TEST(NeverDrives, LooksAtTheDriveAlone) {
  Simulation robot(pid_on_oval());
  const Drive start = robot.run_for(2_s);
  EXPECT_THAT(start, NeverDrives(backwards()));
  EXPECT_THAT(start, Not(NeverDrives(faster_than(50_mm_per_s))));
  EXPECT_THAT(start, NeverDrives(faster_than(5.0_m_per_s)));
  EXPECT_THAT(start, Not(NeverDrives(at_all())));
  EXPECT_THAT(start,
              Not(NeverDrives(onto(start.moments().back().pose.column, start.moments().back().pose.row))));
  EXPECT_THAT(start, Not(StopsWithin(500_ms)));
  robot.power_off(2_s);
  EXPECT_THAT(robot.run_for(1500_ms), StopsWithin(1_s));
  EXPECT_THAT(robot.run_for(300_ms), NeverDrives(at_all()));
}

TEST(StopsWithin, DoesNotHoldOfARobotThatGoesOn) {
  Simulation robot(pid_on_oval());
  const Drive drive = robot.run_for(1_s);
  EXPECT_THAT(drive, Not(StopsWithin(mm(1e6))));
}

TEST(NeverCollides, TellsWhenAndWhereItDid) {
  Trial trial = pid_on_oval();
  trial.script = "at 0s obstacle 14,14";
  Simulation robot(trial);
  const Drive drive = robot.run_for(3_s);
  EXPECT_GT(drive.collisions(), 0);
  EXPECT_THAT(drive, Not(NeverCollides()));
  EXPECT_THAT(explanation(NeverCollides(), drive),
              HasSubstr("it hit a wall, an obstacle, a robot or the map's edge, at column 1"));
}

TEST(Collides, IsNotWhatTheRobotIsToldInWords) {
  Simulation robot(pid_on_oval());
  robot.send("collision");
  EXPECT_FALSE(robot.run_until(collides(), within(500_ms)));
}

TEST(EndsAs, DoesNotHoldWhileTheRunGoesOn) {
  Simulation robot(pid_on_oval());
  EXPECT_THAT(robot.run_for(100_ms), Not(EndsAs("lost")));
}

/// Returns a graph of two junctions, which three lines join. If `twisted` is true, two of the lines cross.
Graph three_lines(bool twisted) {
  const auto arms_to = [&](int node) {
    return std::vector<Graph::End>{{node, 0}, {node, twisted ? 1 : 2}, {node, twisted ? 2 : 1}};
  };
  return {{{arms_to(1)}, {arms_to(0)}}};
}

TEST(Graphs, DifferIfTheirLinesComeInByOtherArms) {
  EXPECT_THAT(difference(three_lines(false), three_lines(true)),
              HasSubstr("but its lines connect them differently"));
  EXPECT_THAT(three_lines(false), IsTheSameGraphAs(three_lines(false)));
}

TEST(Stations, AreThoseItCameToInTheirOrder) {
  Simulation robot({.sketch = "RightPath", .map = "a", .robot = "uno3", .goal = "tour"});
  EXPECT_EQ(robot.station(), "1");
  const Drive tour = robot.run_to_the_end();
  EXPECT_THAT(tour.stations(), ElementsAre("2", "1"));
  EXPECT_THAT(tour, VisitsInOrder({2, 1}));
  EXPECT_THAT(tour, Not(VisitsInOrder({1, 2})));
  EXPECT_THAT(tour, Visits({1, 2}));
  EXPECT_THAT(explanation(Visits({2, 7}), tour), HasSubstr("it did not come to 7 before"));
  EXPECT_THAT(tour, Reaches("tour"));
  EXPECT_THAT(explanation(Reaches("laps:1"), tour), HasSubstr("the goal of this run is tour"));
}

TEST(Score, IsWhatTheRulesOfACompetitionGive) {
  const std::string map =
      "+++\nsize = [\"1.5 m\", \"600 mm\"]\ngoal = \"rescue-line\"\n[[path]]\nfrom = [\"150 mm\", \"450 "
      "mm\"]\nsegments = [{ length = \"1.2 m\" }]\n[rescue]\ncheckpoints = [\"600 mm\"]\n+++\n";
  Simulation robot({.sketch = "PidFollower", .map = map, .goal = "rescue-line", .limit = 3_s});
  const Drive start = robot.run_for(100_ms);
  EXPECT_FALSE(start.score()) << "the run goes on";
  EXPECT_THAT(explanation(ScoresAtLeast(0), start), HasSubstr("the run goes on"));
  const Drive drive = robot.run_to_the_end();
  ASSERT_TRUE(drive.score());
  EXPECT_EQ(drive.score()->unit, "points");
  EXPECT_EQ(drive.score()->parts.at(0).what, "start tile");
  EXPECT_THAT(drive, ScoresAtLeast(drive.score()->value));
  EXPECT_THAT(drive, AllOf(Not(ScoresAtLeast(drive.score()->value + 1)), ScoresAtMost(drive.score()->value)));
  EXPECT_THAT(explanation(ScoresAtMost(4), drive), HasSubstr("points, start tile of 1"));

  Simulation lap(pid_on_oval());
  EXPECT_THAT(lap.run_for(1_s), Not(ScoresAtLeast(0)));
}

TEST(SerialEvents, ReadOnAndLookBehindTheLastDeed) {
  Simulation robot({.sketch = "AiNavigator", .map = "b"});
  const Drive boot = robot.run_for(500_ms);
  EXPECT_THAT(boot, SerialSays("ready"));
  EXPECT_THAT(boot, SerialMatches("^Put me .* scan\\.$"));
  ASSERT_TRUE(robot.run_until(serial_says("ready"), within(10_ms))) << "the text was sent, but not yet read";
  EXPECT_FALSE(robot.run_until(serial_says("ready"), within(10_ms))) << "the text was read";
  robot.send("1\n");
  EXPECT_FALSE(robot.run_until(serial_says("I will scan"), within(1_ms))) << "printed before the request";
  const Drive answer = robot.run_until(serial_says("I will scan"), within(100_ms));
  EXPECT_TRUE(answer);
  EXPECT_THAT(answer, Not(SerialSays("ready")));
  robot.send("1\n");
  ASSERT_TRUE(robot.run_until(serial_matches("I will scan"), within(100_ms)));
  EXPECT_FALSE(robot.run_until(serial_matches("I will scan"), within(10_ms))) << "that line was read";
}

TEST(Events, AreWhicheverComesFirst) {
  Simulation robot(pid_on_oval());
  ASSERT_TRUE(robot.run_until(stands_still(1_s) || motors_start(), within(1_s)));
  EXPECT_LT(robot.now(), 100_ms);
}

TEST(Parts, AreTouchedAndReadByTheirNames) {
  Simulation robot(with("WrongButton"));
  robot.run_for(100_ms);
  EXPECT_FALSE(robot.is_on("start"));
  robot.hold("start");
  robot.run_for(10_ms);
  EXPECT_TRUE(robot.is_on("start"));
  robot.release("start");
  robot.run_for(10_ms);
  EXPECT_FALSE(robot.is_on("start"));
  const int line = __LINE__ + 2;
  try {
    robot.press("strat");
    FAIL() << "there is no such button";
  } catch (const std::exception& error) {
    EXPECT_THAT(error.what(), testing::StartsWith(std::string(__FILE__) + ":" + std::to_string(line) +
                                                  ": unknown button of robot"));
    EXPECT_THAT(error.what(), testing::HasSubstr("got “strat”; did you mean start?"));
  }
  EXPECT_THROW(robot.reading("lamp"), std::exception);
  const double yaw = robot.pose().yaw_rad;
  robot.turn_round();
  robot.run_for(10_ms);
  EXPECT_NEAR(std::abs(robot.pose().yaw_rad - yaw), 3.14159, 0.001);
}

TEST(ARunThatFailsByItself, FailsTheTestUnlessItAsksHowTheRunEnded) {
  EXPECT_NONFATAL_FAILURE(
      {
        Simulation robot(forgetful());
        robot.run_for(20_s);
      },
      "the run failed, and no expectation checked its verdict");
  Simulation robot(forgetful());
  EXPECT_TRUE(robot.run_until(ends("crashed"), within(20_s)));
  EXPECT_THAT(robot, EndsAs("crashed"));
  EXPECT_THROW(robot.press("start"), std::exception) << "the run is over";
}

TEST(ARunInWhichADetectorSeesSomething, FailsTheTestUnlessItAsksNone) {
  Trial dim = with("Dim");
  const auto run = [&] {
    Simulation robot(dim);
    robot.run_for(200_ms);
  };
  const std::vector<std::string> failures = robosim::test::caught_failures(run);
  ASSERT_EQ(failures.size(), 1u);
  EXPECT_THAT(failures[0], AllOf(HasSubstr("detected: pin 13 (LED) was never set to OUTPUT"),
                                 HasSubstr("in setup, Dim.ino:6"), HasSubstr("[forgotten_output]"),
                                 HasSubstr("replay: robosim run "), HasSubstr(" --for 200ms --sanitize")));
  EXPECT_THAT(robosim::test::caught_failures([&] {
                Fleet both({.robots = {{.name = "A", .sketch = "PidFollower"},
                                       {.name = "B", .sketch = dim.sketch, .start = "20,2,W"}},
                            .map = "oval"});
                both.run_for(200_ms);
              }),
              ElementsAre(HasSubstr("detected: pin 13 (LED)")));
  dim.detect = false;
  run();
}

TEST(Trial, TakesAMapAndARobotAsText) {
  Simulation robot({.sketch = "PidFollower",
                    .map = "__________\n__________\n__________\n"
                           "___S......\n__________\n__________\n__________\n",
                    .robot = "base = \"uno5\"\n[chassis]\nmass = \"500 g\"\n"});
  robot.run_for(500_ms);
  EXPECT_GT(robot.so_far().distance().mm, 50.0);
  EXPECT_THAT(robot.replay_command(), HasSubstr("map.map"));
}

TEST(Trial, TakesARobotWithABoardOfTheTarget) {
  ROBOSIM_SKIP_WITHOUT("stm32");
  Simulation robot({.sketch = "PidFollower",
                    .map = "oval",
                    .robot = "base = \"uno5\"\n[chassis]\nmass = \"500 g\"\n",
                    .target = "stm32"});
  robot.run_for(500_ms);
  EXPECT_GT(robot.so_far().distance().mm, 50.0);
}

TEST(Resources, AreNotKnownOnTheHost) {
  Simulation robot(pid_on_oval());
  robot.run_for(100_ms);
  EXPECT_THAT(explanation(UsesAtMost(ram(1000)), robot.so_far()), HasSubstr("run this test on avr"));
}

TEST(Resources, AreMeasuredOnTheChip) {
  ROBOSIM_SKIP_WITHOUT("avr");
  Trial trial = pid_on_oval();
  trial.target = "avr";
  Simulation robot(trial);
  robot.run_for(300_ms);
  EXPECT_THAT(robot, UsesAtMost(ram(2000), stack(1000), flash(30000), loop_time(20_ms)));
  const Usage used = *robot.so_far().usage();
  EXPECT_NE(used.stack_bytes, used.ram_bytes);
  EXPECT_THAT(robot, UsesAtMost(ram(used.ram_bytes), stack(used.stack_bytes), flash(used.flash_bytes)));
  EXPECT_THAT(robot, Not(UsesAtMost(stack(used.stack_bytes - 1))));
  EXPECT_THAT(robot, Not(UsesAtMost(ram(used.ram_bytes - 1))));
  EXPECT_THAT(robot, Not(UsesAtMost(flash(used.flash_bytes - 1))));
  EXPECT_THAT(explanation(UsesAtMost(stack(1), loop_time(20_ms)), robot.so_far()),
              HasSubstr("bytes of stack"));
}

const std::vector<std::uint64_t> kTenSeeds{1, 2, 3, 4, 5, 6, 7, 8, 9, 10};

TEST(SuccessRate, CountsRunsThatReachTheirGoal) {
  Trial laps = pid_on_oval();
  laps.goal = "laps:1";
  EXPECT_SUCCESS_RATE(laps, 0.9, kTenSeeds);
  EXPECT_THAT(success_rate(laps, 0.5, kTenSeeds).message(), HasSubstr("5 of 5 runs")) << "five runs suffice";
}

TEST(SuccessRate, MayBeAskedForSurely) {
  Trial moment = pid_on_oval();
  moment.limit = 50_ms;
  EXPECT_SUCCESS_RATE(moment, at_least(1.0), kTenSeeds);
  EXPECT_SUCCESS_RATE(moment, surely_at_least(0.7), kTenSeeds);
  EXPECT_THROW(success_rate(moment, surely_at_least(0.8), kTenSeeds), std::exception);
  EXPECT_THROW(success_rate(moment, at_least(1.5), kTenSeeds), std::exception);
}

TEST(SuccessRate, NamesTheFirstSeedThatFailedWhateverTheNumberOfWorkers) {
  Trial stays = with("WrongButton");
  stays.limit = 1_s;
  stays.goal = "laps:1";
  const auto said = [&](const char* jobs) {
    ::setenv("ROBOSIM_JOBS", jobs, 1);
    ::setenv("ROBOSIM_ARTIFACTS", "none", 1);
    const testing::AssertionResult result = success_rate(stays, 0.9, kTenSeeds);
    ::unsetenv("ROBOSIM_JOBS");
    ::unsetenv("ROBOSIM_ARTIFACTS");
    EXPECT_FALSE(result);
    return std::string(result.message());
  };
  const std::string alone = said("1");
  EXPECT_THAT(alone, AllOf(HasSubstr("0 of 2 runs"), HasSubstr("seed 1: timeout"), HasSubstr("--seed 1 ")));
  EXPECT_EQ(alone, said("3"));
}

TEST(Targets, ThatDoNotExistAreNamed) {
  EXPECT_EQ(what_lacks("host"), "");
  EXPECT_THAT(what_lacks("pdp11"), HasSubstr("pdp11"));
}

TEST(ASimulation, IsTheSameEveryTime) {
  const auto hash = [] {
    Simulation robot(pid_on_oval());
    robot.run_for(1_s);
    robot.cover("S2", 30_ms);
    robot.run_for(1_s);
    return robot.trace_hash();
  };
  EXPECT_EQ(hash(), hash());
}

}  // namespace matchers_test
