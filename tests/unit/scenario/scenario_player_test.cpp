// Tests the observable effects of a script on a run in which the built-in driver follows the oval.
#include "sim/run/scenario/scenario_player.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "tests/support/built_in_driver.h"
#include "tests/support/effort.h"
#include "tests/support/event_values.h"
#include "tests/support/one_robot.h"
#include "tests/support/refusal.h"

namespace robosim::scenario::scenario_player_test {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Records a run's events.
struct Witness final : run::Listener {
  void began(const run::Beginning& beginning) override { readings = beginning.readings; }
  void sampled(const run::Sample& sample) override { samples.push_back(sample); }
  void happened(const result::RunEvent& event) override { happenings.push_back(test::values_of(event)); }
  const run::Sample& at(double seconds) const {
    return samples[static_cast<std::size_t>(seconds * 1000.0 + 0.5)];
  }

  std::vector<std::string> readings;
  std::vector<run::Sample> samples;  // one per millisecond
  std::vector<std::string> happenings;
};

class Scripts : public testing::Test {
 protected:
  judge::Outcome play(const std::string& script, double seconds) {
    test::BuiltInDriver driver;
    test::OneRobot one(driver, "none", script);
    one.setup.agents[0].listener = &seen;
    one.setup.samples_every = kTick;
    return one.run(static_cast<SimTime>(seconds * 1e9));
  }
  std::string error_of(const std::string& script) {
    return test::refusal([&] { play(script, 0.01); }, "no error");
  }
  /// Returns the reading of sensor S1 at this time. S1 is next to the line.
  double s1(double seconds) { return seen.at(seconds).readings[0]; }

  Witness seen;
};

TEST_F(Scripts, BreakAPartForATimeAndSaySo) {
  play("at 100ms fault S1 stuck 1023 for 200ms\n", 0.5);
  EXPECT_LT(s1(0.100), 0.5);
  EXPECT_EQ(s1(0.101), 1.0);
  EXPECT_EQ(s1(0.300), 1.0);
  EXPECT_LT(s1(0.301), 0.5);
  EXPECT_THAT(seen.happenings, ElementsAre("100 fault_began part=S1 arguments=stuck,1023",
                                           "300 fault_ended part=S1 arguments=stuck,1023"));
}

TEST_F(Scripts, HoldAButtonUntilTheLastFingerLeavesIt) {
  const auto held = [&](const std::string& script) {
    seen = {};
    play(script, 0.1);
    const auto start = std::find(seen.readings.begin(), seen.readings.end(), "start") - seen.readings.begin();
    return std::count_if(seen.samples.begin(), seen.samples.end(), [start](const run::Sample& s) {
      return s.readings[static_cast<std::size_t>(start)] == 1.0;
    });
  };
  EXPECT_EQ(held("at 10ms press start 20ms\n"), 20);
  EXPECT_EQ(held("at 10ms press start 20ms\nat 20ms press start 40ms\n"), 50) << "the later end counts";
  EXPECT_EQ(held("at 10ms press start 50ms\nat 20ms press start 10ms\n"), 50)
      << "the shorter press does not end the longer one";
  EXPECT_EQ(held("at 10ms press start 20ms\nat 10ms press start 20ms\n"), 20);
  EXPECT_EQ(held("at 10ms press start\nat 20ms press start 10ms\nat 50ms release start\n"), 40);
  EXPECT_EQ(held("at 10ms press start 30ms\nat 20ms release start\nat 30ms press start 30ms\n"), 40)
      << "a released press does not end a later one";
}

TEST_F(Scripts, SayOnceThatTheyLetGo) {
  play("at 10ms press start 20ms\nat 20ms press start 40ms\nat 15ms cover S1 30ms\nat 20ms cover S1 10ms\n",
       0.1);
  EXPECT_THAT(seen.happenings,
              ElementsAre("10 script_acted verb=press part=start", "15 script_acted verb=cover part=S1",
                          "20 script_acted verb=press part=start", "20 script_acted verb=cover part=S1",
                          "45 script_acted verb=uncover part=S1", "60 script_acted verb=release part=start"));
}

TEST_F(Scripts, SayWhenTheyLetGoOfAButtonAndOfASensor) {
  play("at 10ms press start 20ms\nat 15ms cover S1 for 30ms\nat 50ms cover S2\nat 60ms press start\n", 0.1);
  EXPECT_THAT(seen.happenings,
              ElementsAre("10 script_acted verb=press part=start", "15 script_acted verb=cover part=S1",
                          "30 script_acted verb=release part=start", "45 script_acted verb=uncover part=S1",
                          "50 script_acted verb=cover part=S2", "60 script_acted verb=press part=start"));
}

TEST_F(Scripts, EndAFaultThatAnotherOneHasReplacedNoMore) {
  play("at 100ms fault S1 stuck 1023 for 200ms\nat 200ms fault S1 stuck 1000\n", 0.5);
  EXPECT_GT(s1(0.45), 0.9);
  EXPECT_THAT(seen.happenings, ElementsAre("100 fault_began part=S1 arguments=stuck,1023",
                                           "200 fault_began part=S1 arguments=stuck,1000"));
}

TEST_F(Scripts, LiftTheRobotSoThatItsWheelsTurnFreelyAndItsSensorsSeeNothing) {
  play("at 300ms lift for 1s\n", 2.0);
  const run::Sample &before = seen.at(0.300), &lifted = seen.at(1.299), &after = seen.at(1.9);
  EXPECT_EQ(lifted.pose.position.x, before.pose.position.x);
  EXPECT_EQ(lifted.speed, 0.0);
  EXPECT_THAT(std::vector<double>(lifted.readings.begin(), lifted.readings.begin() + 5), testing::Each(1.0));
  EXPECT_GT(after.speed, 0.1);
  EXPECT_THAT(seen.happenings, ElementsAre("300 script_acted verb=lift", "1300 script_acted verb=lower"));
}

TEST_F(Scripts, HoldTheRobotInTheHandForLongWithoutAVerdict) {
  const judge::Outcome outcome = play("at 300ms lift\n", 10.0);
  EXPECT_EQ(outcome.verdict, judge::Verdict::reached) << outcome.why;
  EXPECT_EQ(outcome.metrics.off_line_s, 0.0);
}

TEST_F(Scripts, PutALiftedRobotDownWhereTheySay) {
  play("at 100ms lift for 1s\nat 200ms place 13,2,E\n", 1.5);
  EXPECT_GT(seen.at(1.0).speed, 0.1) << "the placed robot drives, and the lift has ended";
  EXPECT_THAT(seen.happenings,
              ElementsAre("100 script_acted verb=lift", "200 script_acted verb=place argument=13,2,E"));
}

TEST_F(Scripts, MoveTheRobotToAndFroByHandOverTheLineAndPutItDownWhereItWas) {
  const auto outcome = play("at 1s sweep 40mm every 400ms for 800ms", 3);
  const run::Sample& before = seen.at(1.0);
  const run::Sample& left = seen.at(1.101);
  const run::Sample& right = seen.at(1.301);
  const double to_left = dot(left.pose.position - before.pose.position, left_of(before.pose.heading));
  EXPECT_NEAR(to_left, 0.04, 0.001);
  EXPECT_NEAR(dot(right.pose.position - before.pose.position, left_of(before.pose.heading)), -0.04, 0.001);
  EXPECT_EQ(left.pose.heading.x, before.pose.heading.x);
  double least = 1.0, most = 0.0;
  for (double t = 1.0; t < 1.8; t += 0.001) {
    least = std::min(least, s1(t));
    most = std::max(most, s1(t));
  }
  EXPECT_LT(least, 0.1);
  EXPECT_GT(most, 0.9) << "the outermost sensor comes over the line";
  EXPECT_NEAR(length(seen.at(1.801).pose.position - before.pose.position), 0.0, 0.002);
  EXPECT_THAT(seen.happenings, ElementsAre(HasSubstr("sweep"), HasSubstr("lower")));
  EXPECT_EQ(outcome.verdict, judge::Verdict::reached);
}

TEST_F(Scripts, HoldTheRobotUpAndTiltItForATime) {
  play("at 1s tilt 30deg back in 200ms for 1s", 3);
  EXPECT_NEAR(length(seen.at(1.9).pose.position - seen.at(1.0).pose.position), 0.0, 0.001);
  EXPECT_EQ(s1(1.5), 1.0) << "the robot's sensors see no floor";
  EXPECT_GT(length(seen.at(2.9).pose.position - seen.at(2.0).pose.position), 0.01) << "the robot drives on";
  EXPECT_THAT(seen.happenings, ElementsAre(HasSubstr("tilt"), HasSubstr("lower")));
}

TEST_F(Scripts, SayWhatATiltIs) {
  EXPECT_THAT(error_of("at 1s tilt 200deg back"), HasSubstr("from 1deg to 180deg"));
  EXPECT_THAT(error_of("at 1s tilt 20deg up"),
              HasSubstr("the side of a tilt: expected ahead, back, left or right, got “up”"));
  EXPECT_THAT(error_of("at 1s tilt 20deg back in 1s for 1s"), HasSubstr("goes there and back"));
}

TEST_F(Scripts, OfASweepAreEndedByPuttingTheRobotElsewhere) {
  play("at 1s sweep 40mm for 9s\nat 1.35s place 700mm,400mm,NE", 2);
  EXPECT_NEAR(seen.at(1.351).pose.position.x, 0.7, 0.002);
  EXPECT_NEAR(seen.at(1.351).pose.position.y, 0.4, 0.002);
  EXPECT_NEAR(seen.at(1.351).pose.heading.x, 0.7071, 0.001);
  EXPECT_GT(length(seen.at(1.9).pose.position - seen.at(1.351).pose.position), 0.01) << "the robot drives on";
}

TEST_F(Scripts, PutAnObstacleOnTheLineAndTakeItAway) {
  const map::Map map = map::read_map(map::find_map("oval"));
  const map::CellAt start = map::default_start(map).cell;
  const std::string cell = fmt::format("{},{}", start.x + 3, start.y);
  const judge::Outcome outcome = play("at 0s obstacle " + cell + " for 2s\n", 4.0);
  EXPECT_EQ(outcome.metrics.collisions, 1);
  EXPECT_LT(seen.at(1.9).speed, 0.02);
  EXPECT_GT(seen.at(2.5).speed, 0.1);
  EXPECT_THAT(seen.happenings,
              Contains("0 script_acted verb=obstacle argument=" + cell + " disc=1350,250,33"));
  EXPECT_THAT(seen.happenings, Contains("2000 script_acted verb=clear argument=" + cell));
  seen = {};
  play("at 0s obstacle " + cell + "\nat 1s clear " + cell + "\n", 2.0);
  EXPECT_GT(seen.at(1.5).speed, 0.1);
}

TEST_F(Scripts, BlockAWheel) {
  play("at 500ms fault left stuck for 100ms\n", 1.0);
  const double turned = cross(seen.at(0.5).pose.heading, seen.at(0.6).pose.heading);
  EXPECT_GT(turned, 0.1) << "the right wheel drives round the left one";
}

TEST_F(Scripts, SayWhatResetsTheChipAndWhenItStartedAgain) {
  play("at 100ms fault power brown-out for 50ms\nafter boot 2 wait 20ms fault S1 dead\n", 0.3);
  EXPECT_THAT(seen.happenings, ElementsAre("100 fault_began part=power arguments=brown-out resets_chip=1",
                                           "150 fault_ended part=power arguments=brown-out",
                                           "170 fault_began part=S1 arguments=dead"));
}

TEST_F(Scripts, CutThePowerAndSayWhenItIsBack) {
  play("at 100ms power off for 50ms\n", 0.3);
  EXPECT_THAT(seen.happenings, ElementsAre("100 power_lost", "150 power_back"));
}

TEST_F(Scripts, WaitAfterAStation) {
  // The oval has no stations, so the script's station is unknown.
  EXPECT_THAT(error_of("after station 1 wait 1s lift"),
              HasSubstr("s.txt:1: unknown station “1”: the map has no stations"));
}

TEST_F(Scripts, RefuseNamesAndCellsThatAreNotThere) {
  for (const char* place : {"9m,1mm,N", "10mm,1mm,NNE", "10mm,1mm", "10mm,-1mm,N", "10mm,x,N"})
    EXPECT_THAT(error_of(std::string("at 1s place ") + place), HasSubstr("s.txt:1")) << place;
  EXPECT_THAT(error_of("at 1s place 9m,1mm,N"), HasSubstr("invalid place: expected a line cell as "
                                                          "X,Y,DIR, or a point as 352mm,118mm,NE"));
  EXPECT_THAT(error_of("at 1s sweep 2m"), HasSubstr("from 1mm to 500mm"));
  EXPECT_THAT(error_of("at 1s fault S9 dead"),
              HasSubstr("s.txt:1: unknown part for a fault: expected left, right, S1"));
  EXPECT_THAT(error_of("after eeprom 1 lift"), HasSubstr("s.txt:1: eeprom: scripts can"));
  EXPECT_THAT(error_of("at 1s obstacle 4"), HasSubstr("s.txt:1: invalid cell: expected COLUMN,ROW"));
  EXPECT_THAT(error_of("at 1s clear 400,1"), HasSubstr("invalid cell: expected COLUMN,ROW"));
  EXPECT_THAT(error_of("at 1s clear -1,1"), HasSubstr("invalid cell"));
  EXPECT_THAT(seen.happenings, IsEmpty());
}

TEST_F(Scripts, DoWhatIsDueAtOneTimeInTheirOwnOrderWhateverItWaitedFor) {
  play("after boot 1 cover S1\nat 5ms cover S2\nafter boot 1 wait 5ms cover S3\nat 4500us cover S4\n", 0.02);
  EXPECT_THAT(seen.happenings,
              ElementsAre("0 script_acted verb=cover part=S1", "5 script_acted verb=cover part=S2",
                          "5 script_acted verb=cover part=S3", "5 script_acted verb=cover part=S4"));
}

TEST_F(Scripts, EndWhatIsOverAtOneTimeInTheOrderInWhichItBegan) {
  play("at 1ms obstacle 1,0 for 8900us\nat 2ms obstacle 0,0 for 7500us\n", 0.02);
  EXPECT_THAT(seen.happenings, ElementsAre("1 script_acted verb=obstacle argument=1,0 disc=150,1650,33",
                                           "2 script_acted verb=obstacle argument=0,0 disc=50,1650,33",
                                           "10 script_acted verb=clear argument=1,0",
                                           "10 script_acted verb=clear argument=0,0"));
}

std::string repeated(const std::string& line, std::size_t times) {
  std::string text;
  for (std::size_t i = 0; i < times; ++i) text += line;
  return text;
}

TEST_F(Scripts, OfAHundredThousandEqualLinesTakeNoLongerForEachThanOfAFew) {
  const std::size_t lines = test::rounds(kMostSteps);
  play(repeated("at 1ms cover S1 for 1ms\n", lines), 0.01);
  EXPECT_EQ(seen.happenings.size(), lines + 1);
  seen.happenings.clear();
  play(repeated("at 1ms fault S1 stuck 3 for 1ms\n", lines), 0.01);
  EXPECT_EQ(seen.happenings.size(), lines + 1);
}

TEST_F(Scripts, BeyondTheirLimitsAreRefusedAtTheLineThatIsTooMuch) {
  EXPECT_EQ(error_of(repeated("at 1s lift\n", kMostSteps + 1)),
            "s.txt:100001: the script is too long: expected at most 100000 lines");
  EXPECT_EQ(error_of(repeated("after boot 2 lift\n", kMostAwaited + 1)),
            "s.txt:1001: the script is too long: expected at most 1000 lines that begin with after");
}

TEST_F(Scripts, ThatDoNothingChangeNothing) {
  const std::string plain = play("", 1.0).trace_hash;
  EXPECT_EQ(play("at 100ms fault S1 ok\nat 200ms lower\nat 300ms clear 0,0\n", 1.0).trace_hash, plain);
  EXPECT_NE(play("at 100ms fault S1 noisy 0.2\n", 1.0).trace_hash, plain);
}

}  // namespace robosim::scenario::scenario_player_test
