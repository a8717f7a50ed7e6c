#include "sim/judge/explain.h"

#include <gmock/gmock.h>

#include "sim/result/advice.h"

namespace robosim::judge::explain_test {

using ::testing::AllOf;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

/// Provides the evidence of a run for explain(). The map is a fork with three stations. The robot has a
/// button on pin 4 and a motor on pins 5 and 7.
class Explain : public ::testing::Test {
 protected:
  Explain() {
    e.t = e.activity.last_call = 12 * kSecond;
    e.limit = 60 * kSecond;
    e.map = &map_;
    e.goal = &goal_;
    e.progress = &progress_;
    e.judge = &judge_;
    e.wiring = {{"start", "button", "", 4}, {"left", "motor", "in1", 5}, {"left", "motor", "in2", 7}};
    e.went_high.assign(20, false);
    e.was_output.assign(20, false);
  }
  std::string why(Verdict verdict) {
    e.verdict = verdict;
    return explain(e);
  }
  std::string next(Verdict verdict) {
    e.verdict = verdict;
    return next_step(e).text;
  }
  /// Reports to the judge that the robot is in the middle of a cell.
  void robot_is_at(SimTime t, map::CellAt cell, bool sees_line, bool driven) {
    Situation now;
    now.sees_line = sees_line;
    now.driven = driven;
    robot_is_at(t, {map_.centre(cell), {1.0, 0.0}}, now);
  }
  /// Reports that the robot sees the line for the last time, at 2 s in the middle of cell 3,1.
  void lose_the_line() { robot_is_at(2 * kSecond, {3, 1}, true, true); }
  /// Reports that the robot creeps forward at 1 cm/s for 5.5 s, with its motors driven.
  void creep(bool touches) {
    Pose pose{map_.centre({3, 1}), {1.0, 0.0}};
    Situation now;
    now.driven = true;
    now.in_contact = touches;
    for (SimTime t = 0; t <= 5500 * kMillisecond; t += kTick) {
      pose.position.x += 1e-5;
      robot_is_at(t, pose, now);
    }
  }
  /// Reports that the robot drives in circles around the middle of cell 5,2 for 10 s, one circle per second.
  /// `direction` is 1 for anticlockwise, and -1 for clockwise. If `crosses` is true, the robot sees the line
  /// once in each circle.
  void drive_circles(double radius_m, int direction, bool crosses) {
    const Vec2 around[] = {{1.0, 0.0},  {0.7, 0.7},   {0.0, 1.0},  {-0.7, 0.7},
                           {-1.0, 0.0}, {-0.7, -0.7}, {0.0, -1.0}, {0.7, -0.7}};
    Situation now;
    now.driven = true;
    for (int i = 0; i <= 80; ++i) {
      const Vec2 a = around[(80 + direction * i) % 8];
      now.sees_line = crosses && i % 8 == 0 && i < 80;
      robot_is_at(2 * kSecond + i * 125 * kMillisecond,
                  {map_.centre({5, 2}) + a * radius_m, left_of(a) * direction}, now);
    }
    e.activity.call = "delay(5)";
  }

  Evidence e;

 private:
  void robot_is_at(SimTime t, const Pose& pose, Situation now) {
    now.pose = &pose;
    now.t = now.last_call = t;
    judge_.look(now);
    e.moved = true;
    e.at = pose.position;
  }

  map::Map map_ = map::parse_map("_______\n_S1111_\n___1___\n___1___\n_______\n", "fork.map");
  map::Start start_ = map::default_start(map_);
  map::Network network_ = map::trace_network(map_, start_);
  map::Stripes stripes_{map_, map_.cell_m};
  Goal goal_ = parse_goal("tour");
  Progress progress_{goal_, map_, stripes_, network_, start_};
  Judge judge_{true};
};

TEST_F(Explain, EveryVerdictIsASentenceOfItsOwn) {
  std::vector<std::string> all;
  for (const Verdict verdict :
       {Verdict::reached, Verdict::lost, Verdict::stuck, Verdict::toppled, Verdict::hung, Verdict::ended,
        Verdict::crashed, Verdict::timeout, Verdict::over_budget, Verdict::interrupted}) {
    all.push_back(why(verdict));
    EXPECT_THAT(all.back(), EndsWith(".")) << to_string(verdict);
    EXPECT_EQ(std::count(all.begin(), all.end(), all.back()), 1) << all.back();
  }
}

TEST_F(Explain, ARunWithoutAGoalSaysWhatTheRobotHit) {
  const Goal none = parse_goal("none");
  e.goal = &none;
  EXPECT_THAT(why(Verdict::reached), EndsWith("went by without a failure."));
  e.collisions = 1;
  EXPECT_THAT(why(Verdict::reached), EndsWith("went by without a failure, but with 1 collision."));
  e.collisions = 3;
  EXPECT_THAT(why(Verdict::reached), EndsWith(", but with 3 collisions."));
}

TEST_F(Explain, LapsThatWereDrivenBesideTheLineAreSaidToBe) {
  const Goal laps = parse_goal("laps:1");
  e.goal = &laps;
  e.off_line = e.t / 5;
  EXPECT_THAT(why(Verdict::reached), Not(HasSubstr("off the line"))) << "as in gaps";
  e.off_line = e.t / 2;
  EXPECT_THAT(why(Verdict::reached), EndsWith(", but the robot was off the line for 6.00 s."));
  EXPECT_EQ(next(Verdict::reached), result::kWatch);
  EXPECT_EQ(decisive_moment(e).text, "") << "no time at which the robot left the line";
  lose_the_line();
  robot_is_at(2500 * kMillisecond, {5, 1}, true, true);
  EXPECT_THAT(
      why(Verdict::reached),
      EndsWith(", but the robot was off the line for 6.00 s, first from 2.00 s near column 3, row 1."));
  EXPECT_EQ(decisive_moment(e).t, 2 * kSecond);
  EXPECT_EQ(decisive_moment(e).text, "the robot left the line for the first time");
  e.off_line = 0;
  EXPECT_EQ(decisive_moment(e).text, "");
  EXPECT_EQ(next(Verdict::reached), "");
}

TEST_F(Explain, ATimeoutSaysWhatIsMissingAndWhatTheSketchWaitsFor) {
  e.activity.call = "digitalRead(4)";
  e.activity.pin = e.activity.polled = 4;
  e.activity.where = {"loop", "My.ino", 9};
  e.pin_level = true;
  EXPECT_EQ(why(Verdict::timeout),
            "The 60.00 s of simulated time are up before the goal tour: 0 of 3 stations visited; the sketch "
            "keeps reading pin 4 (button \"start\") with digitalRead(4), and finds it "
            "HIGH; it was last in loop, My.ino:9.");
}

TEST_F(Explain, ATimeoutSaysSinceWhenTheSketchIsSilent) {
  e.activity.last_call = 3 * kSecond;
  e.activity.call = "delay(1)";
  EXPECT_THAT(why(Verdict::timeout), EndsWith("; the sketch has called no Arduino function since 3.00 s."));
  e.activity.where = {"loop", "My.ino", 9};
  EXPECT_THAT(why(Verdict::timeout), EndsWith(" since 3.00 s, and was last in loop, My.ino:9."));
  e.on_chip = true;
  EXPECT_THAT(
      why(Verdict::timeout),
      HasSubstr("; the sketch has used no pin, timer or interface, except in interrupts, since 3.00 s"))
      << "a chip's calls without effect are not seen";
}

TEST_F(Explain, ATimeoutSaysByWhatTheSketchStoppedItself) {
  e.activity.stopped_by = "exit(0)";
  EXPECT_THAT(why(Verdict::timeout), EndsWith("visited; the sketch stopped itself by exit(0)."));
  e.activity.stopped_by.clear();
  EXPECT_THAT(why(Verdict::timeout), EndsWith("visited."));
}

TEST_F(Explain, ATimeoutNamesThePlaceIfNoCallIsKnown) {
  e.activity.where = {"loop", "My.ino", 9};
  EXPECT_THAT(why(Verdict::timeout), EndsWith("; the sketch was in loop, My.ino:9."));
  e.activity.call = "delay(5)";
  EXPECT_THAT(why(Verdict::timeout), EndsWith("; the sketch was last in delay(5) in loop, My.ino:9."));
}

TEST_F(Explain, AnExceededBudgetIsNamed) {
  e.exceeded = "its stack took 900 bytes, but the robot file allows 800";
  EXPECT_EQ(why(Verdict::over_budget),
            "The sketch is over its budget: its stack took 900 bytes, but the robot file allows 800 (0 of 3 "
            "stations visited).");
  EXPECT_THAT(why(Verdict::timeout), Not(HasSubstr("budget")));
}

TEST_F(Explain, AnInterruptedRunSaysWhenItEnded) {
  EXPECT_EQ(why(Verdict::interrupted),
            "Interrupted after 12.00 s of simulated time (0 of 3 stations visited).");
  EXPECT_THAT(why(Verdict::timeout), Not(HasSubstr("nterrupted")));
}

TEST_F(Explain, ARobotThatToppledIsToldWhetherItFell) {
  robot_is_at(12 * kSecond, {3, 1}, true, true);
  e.toppled = world::Toppled::off_an_edge;
  EXPECT_EQ(why(Verdict::toppled),
            "The robot fell off an edge near column 3, row 1 (0 of 3 stations visited).");
  e.toppled = world::Toppled::no;
  EXPECT_EQ(why(Verdict::toppled), "The robot tipped over near column 3, row 1 (0 of 3 stations visited).");
}

TEST_F(Explain, ARobotWithoutPowerIsToldWhy) {
  e.activity.last_call = 3 * kSecond;
  e.power = {.on = false, .since = 7 * kSecond, .charge = -0.01, .volts = 4.4, .needed = 4.5};
  EXPECT_THAT(why(Verdict::timeout),
              EndsWith(" visited; the board has had no power since 7.00 s: its battery is empty."));
  EXPECT_THAT(next(Verdict::timeout), HasSubstr("charge, in [battery]"));
  e.power.charge = 0.127;
  EXPECT_THAT(next(Verdict::timeout), Not(HasSubstr("[battery]"))) << "the battery is not empty";
  EXPECT_THAT(why(Verdict::timeout), EndsWith("since 7.00 s: its battery, at 13 % of its charge, gives "
                                              "4.40 V of the required 4.50 V."));
  e.power.charge.reset();
  EXPECT_THAT(why(Verdict::timeout), EndsWith("; the board has had no power since 7.00 s."));
  e.faults = {{"power", {"sag", "3V"}, {}, 7 * kSecond}};
  EXPECT_THAT(why(Verdict::timeout),
              EndsWith(" since 7.00 s: power got the fault \"sag 3V\" by the script."));
  e.power.switched_on = false;
  EXPECT_THAT(why(Verdict::crashed),
              EndsWith("unknown reason, 5.00 s after power got the fault \"sag 3V\" by "
                       "the script."));
  e.faults.clear();
  EXPECT_THAT(why(Verdict::timeout), EndsWith(" since 7.00 s: the script switched it off."));
  e.power = {};
  EXPECT_THAT(why(Verdict::timeout), Not(HasSubstr("power")));
}

TEST_F(Explain, AWeakBatteryIsNamedWhereItsRobotIsStuckOrLost) {
  e.power.charge = 0.5;
  const std::string none = why(Verdict::stuck);
  EXPECT_THAT(none, EndsWith("degree (0 of 3 stations visited)."));
  e.power.charge = 0.0;
  EXPECT_THAT(why(Verdict::stuck), EndsWith("visited); its battery is empty."));
  e.power = {.since = 9 * kSecond, .resets = 3, .recovered = 7 * kSecond, .charge = 0.6};
  EXPECT_THAT(why(Verdict::lost), EndsWith("visited); the chip was reset 3 times by brown-outs, and last "
                                           "ran again at 7.00 s."));
  e.power.resets = 1;
  EXPECT_THAT(why(Verdict::lost), EndsWith("; the chip was reset once by a brown-out, and ran again at "
                                           "7.00 s."));
  EXPECT_THAT(why(Verdict::reached), Not(HasSubstr("brown-out")));
}

TEST_F(Explain, APinThatNothingIsWiredToIsCalledSo) {
  e.activity.polled = 11;
  EXPECT_THAT(why(Verdict::timeout), HasSubstr("pin 11 (nothing is wired to it)"));
  robot_is_at(11 * kSecond, {4, 1}, true, true);
  robot_is_at(12 * kSecond, {5, 1}, true, true);  // a moving robot does not wait for an input
  e.activity.call = "delay(1)";
  EXPECT_THAT(why(Verdict::timeout), EndsWith("; the sketch was last in delay(1)."));
}

TEST_F(Explain, ThePlaceOfAReadIsNotThatOfWhatTheSketchDidAfterIt) {
  e.activity.polled = 4;
  e.activity.call = "digitalWrite(12, 0)";
  e.activity.where = {"latch_tx", "AFMotor.cpp", 64};
  EXPECT_THAT(why(Verdict::timeout), HasSubstr("keeps reading pin 4 (button \"start\"), and finds it LOW."));
}

TEST_F(Explain, ASketchThatDrivesItsMotorsWaitsForNoPinThatItLooksAt) {
  e.activity.polled = 4;
  e.activity.call = "analogWrite(5, 20)";
  e.left_command = 0.08;
  EXPECT_THAT(why(Verdict::timeout), EndsWith("; the sketch was last in analogWrite(5, 20)."));
  EXPECT_THAT(next(Verdict::timeout), Not(HasSubstr("keeps reading is")));
}

TEST_F(Explain, ASketchThatReadsSeveralInputsWaitsForNone) {
  e.activity.call = "digitalRead(4)";
  e.activity.pin = 4;
  e.activity.where = {"loop", "My.ino", 9};
  EXPECT_THAT(why(Verdict::timeout), EndsWith("; the sketch was last in digitalRead(4) in loop, My.ino:9."));
  EXPECT_THAT(next(Verdict::timeout), Not(HasSubstr("keeps reading is")));
}

TEST_F(Explain, ASketchInPulseInWaitsForItsPin) {
  e.activity.call = "pulseIn(4, 1)";
  e.activity.pin = 4;
  EXPECT_THAT(why(Verdict::timeout), HasSubstr("keeps reading pin 4 (button \"start\") with pulseIn(), and"));
  e.t += 3 * kSecond;
  EXPECT_THAT(why(Verdict::timeout), Not(HasSubstr("keeps reading"))) << "pulseIn() may have returned";
}

TEST_F(Explain, AnalogPinsHaveTheirNames) {
  e.board = find_board("uno");
  e.activity.call = "digitalRead(15)";
  e.activity.pin = e.activity.polled = 15;
  EXPECT_THAT(why(Verdict::timeout),
              HasSubstr("keeps reading pin A1 (nothing is wired to it) with digitalRead(A1)"));
}

TEST_F(Explain, ALostRobotIsToldFromWhereItSawTheLineLast) {
  lose_the_line();
  EXPECT_EQ(
      why(Verdict::lost),
      "The robot lost the line: its wheels have turned 1 m since the line was last under or between its "
      "sensors, at 2.00 s near column 3, row 1 (0 of 3 stations visited).");
}

TEST_F(Explain, ARobotThatNeverSawALineLostNoneAtAPlace) {
  e.moved = true;
  EXPECT_THAT(why(Verdict::lost),
              StartsWith("The robot lost the line: its wheels have turned 1 m, and no line was under "
                         "or between its sensors (0 of 3"));
}

TEST_F(Explain, ARobotThatHadLeftTheLineWhenItGotStuckLeftTheLineFirst) {
  lose_the_line();
  robot_is_at(5 * kSecond, {6, 0}, false, true);
  robot_is_at(9 * kSecond, {6, 0}, false, true);
  e.t = 9 * kSecond;
  e.in_contact = true;
  EXPECT_EQ(
      why(Verdict::stuck),
      "The robot left the line at 2.00 s near column 3, row 1, and is stuck: for 3 s its motors were "
      "driven, but it neither moved 1 mm nor turned 1 degree; it touches a wall, an obstacle or the map's "
      "edge (0 of 3 stations visited).");
  EXPECT_EQ(decisive_moment(e).text, "the robot left the line");
}

TEST_F(Explain, ARobotThatCreepsAlongAnotherPushesAgainstIt) {
  creep(true);
  e.in_contact = true;
  e.stopped_by = "another robot";
  EXPECT_EQ(why(Verdict::stuck),
            "The robot is stuck: for 5 s it has pushed against another robot, and has moved less than 10 cm "
            "(0 of 3 stations visited).");
  e.verdict = Verdict::stuck;
  EXPECT_EQ(decisive_moment(e).text, "from here on it pushed against another robot");
}

TEST_F(Explain, ARobotThatCreepsAndTouchesNothingDoesNotPush) {
  creep(false);
  EXPECT_THAT(why(Verdict::stuck), AllOf(Not(HasSubstr("pushed")), Not(HasSubstr("touches"))));
  EXPECT_EQ(decisive_moment(e).text, "its motors were driven from here on, but it did not move");
  e.in_contact = true;
  EXPECT_THAT(why(Verdict::stuck), HasSubstr("degree; it touches a wall, an obstacle or the map's edge ("));
  EXPECT_EQ(decisive_moment(e).text,
            "from here on its motors were driven, but it only touched a wall, an obstacle or the map's edge");
}

TEST_F(Explain, ARobotThatTurnsOnTheSpotIsSaidToAndNotWhatItReadLast) {
  e.activity.call = "analogRead(0)";
  lose_the_line();
  robot_is_at(3 * kSecond, {3, 1}, false, true);
  for (SimTime t = 4; t <= 12; ++t) robot_is_at(t * kSecond, {5, 3}, false, true);
  EXPECT_EQ(
      why(Verdict::timeout),
      "The 60.00 s of simulated time are up before the goal tour: 0 of 3 stations visited; the robot left "
      "the line at 2.00 s near column 3, row 1, and has stayed, with its motors driven, within 10 cm of "
      "column 5, row 3 since 4.00 s.");
}

TEST_F(Explain, ARobotThatStandsWhereItSawTheLineHasNotLeftIt) {
  lose_the_line();
  robot_is_at(9 * kSecond, {3, 1}, false, false);  // the script has erased the line
  EXPECT_THAT(why(Verdict::timeout), Not(HasSubstr("left the line")));
  EXPECT_THAT(decisive_moment(e).text, Not(HasSubstr("left the line")));
}

TEST_F(Explain, ARobotThatSpinsIsSaidToSpinAndNotToHaveLeftTheLineOrSteeredAway) {
  drive_circles(0.02, -1, true);
  e.steered = -0.5;
  e.left_command = 0.4;
  e.right_command = -0.4;
  EXPECT_THAT(why(Verdict::timeout),
              EndsWith("; the robot has been spinning clockwise near column 5, row 2 since 2.00 s."));
  EXPECT_EQ(next(Verdict::timeout), "");
  EXPECT_EQ(decisive_moment(e).text, "the robot spins from here on");
  std::swap(e.left_command, e.right_command);
  EXPECT_THAT(why(Verdict::timeout), Not(HasSubstr("spinning"))) << "the robot turns back";
  std::swap(e.left_command, e.right_command);
  e.t = 40 * kSecond;
  robot_is_at(39900 * kMillisecond, {5, 2}, true, true);
  EXPECT_THAT(why(Verdict::timeout), Not(HasSubstr("spinning"))) << "the robot's last turn was long ago";
}

TEST_F(Explain, ARobotThatCirclesIsSaidToCircle) {
  drive_circles(0.3, 1, false);
  e.right_command = 0.4;
  EXPECT_THAT(why(Verdict::timeout),
              HasSubstr("; the robot has been circling anticlockwise within 1 m of column "));
}

TEST_F(Explain, ARobotThatFollowsASmallLoopDoesNotCircle) {
  drive_circles(0.3, 1, true);
  e.right_command = 0.4;
  EXPECT_THAT(why(Verdict::timeout), Not(HasSubstr("circling"))) << "the robot saw the line in its last turn";
}

TEST_F(Explain, ARobotThatCirclesFarAroundDoesNot) {
  drive_circles(2.0, 1, true);
  EXPECT_THAT(why(Verdict::timeout), Not(HasSubstr("circling")));
}

TEST_F(Explain, ARobotThatWaitedFirstDrivesInOnePlaceOnlySinceItsMotorsRan) {
  robot_is_at(kMillisecond, {3, 1}, true, false);
  for (SimTime t = 4; t <= 12; ++t) robot_is_at(t * kSecond, {3, 1}, true, true);
  EXPECT_THAT(why(Verdict::timeout), HasSubstr("driven, within 10 cm of column 3, row 1 since 4.00 s"));
  EXPECT_EQ(decisive_moment(e).t, 4 * kSecond);
  EXPECT_EQ(decisive_moment(e).text, "the robot stayed in one place from here on, with its motors driven");
}

TEST_F(Explain, ARobotThatDrivesOnUntilItsTimeIsUpDoesNotDriveInOnePlace) {
  const map::CellAt way[] = {{2, 1}, {3, 1}, {4, 1}, {5, 1}};
  for (std::size_t i = 0; i < std::size(way); ++i)
    robot_is_at(static_cast<SimTime>(i + 9) * kSecond, way[i], true, true);
  EXPECT_THAT(why(Verdict::timeout), Not(HasSubstr("within 10 cm")));
  EXPECT_EQ(decisive_moment(e).text, "the robot was still driving when its time was up");
  EXPECT_EQ(decisive_moment(e).t, e.t);
}

TEST_F(Explain, ARobotThatStandsAfterItsDriveIsSaidToWithWhatItsSketchWaitsFor) {
  e.activity.call = "digitalRead(4)";
  e.activity.pin = e.activity.polled = 4;
  robot_is_at(2 * kSecond, {3, 1}, true, true);
  robot_is_at(11900 * kMillisecond, {3, 1}, true, false);
  EXPECT_THAT(why(Verdict::timeout),
              HasSubstr("visited; the robot has stood near column 3, row 1 since 2.00 s; the sketch keeps "
                        "reading pin 4"));
  EXPECT_THAT(why(Verdict::ended), EndsWith("; the robot has stood near column 3, row 1 since 2.00 s."));
}

TEST_F(Explain, ASketchThatHasFinishedWithoutAGoalDidNotEndBeforeOne) {
  EXPECT_THAT(why(Verdict::ended), HasSubstr("with the motors off, before the goal: 0 of 3 stations"));
  const Goal none = parse_goal("none");
  e.goal = &none;
  EXPECT_EQ(why(Verdict::ended),
            "The sketch ended: for 2 s it called no Arduino function, with the motors off.");
}

TEST_F(Explain, AFaultOfTheScriptIsNamedWhereItWasThereThen) {
  lose_the_line();
  e.faults = {{"S2", {"stuck", "1023"}, robot::Failure::stuck, 1700 * kMillisecond, kNever}};
  EXPECT_THAT(why(Verdict::lost),
              HasSubstr("column 3, row 1, 0.30 s after S2 was stuck at 1023 by the script"));
  e.faults[0].began = 3 * kSecond;
  EXPECT_THAT(why(Verdict::lost), Not(HasSubstr("S2"))) << "the fault came after the line was lost";
  EXPECT_THAT(why(Verdict::stuck), EndsWith(", 9.00 s after S2 was stuck at 1023 by the script."));
  e.faults[0].ended = 5 * kSecond;
  EXPECT_THAT(why(Verdict::stuck), Not(HasSubstr("S2"))) << "the fault had ended long before";
  EXPECT_THAT(why(Verdict::reached), Not(HasSubstr("S2")));
}

TEST_F(Explain, EachKindOfFaultIsToldInItsWords) {
  lose_the_line();
  const auto told = [&](const ScriptFault& fault) {
    e.faults = {fault};
    return why(Verdict::stuck);
  };
  using robot::Failure;
  EXPECT_THAT(told({"left", {"stuck"}, Failure::stuck}), HasSubstr(" after left was stuck by the script"));
  EXPECT_THAT(told({"S1", {"stuck", "512"}, Failure::stuck}), HasSubstr("S1 was stuck at 512 by the script"));
  EXPECT_THAT(told({"left", {"dead"}, Failure::dead}), HasSubstr("left was made dead by"));
  EXPECT_THAT(told({"left", {"reversed"}, Failure::reversed}), HasSubstr("left was made reversed by"));
  EXPECT_THAT(told({"START", {"pressed"}, Failure::pressed}), HasSubstr("START was stuck pressed by"));
  EXPECT_THAT(told({"START", {"released"}, Failure::released}),
              AllOf(HasSubstr("START was stuck released by"), Not(HasSubstr("pressed"))));
  EXPECT_THAT(told({"S1", {"swapped", "S2"}, Failure::swapped}), HasSubstr("S1 was swapped with S2 by"));
  EXPECT_THAT(told({"S1", {"noisy", "0.1"}, Failure::noisy}), HasSubstr("S1 got the fault \"noisy 0.1\" by"));
  EXPECT_THAT(told({"power", {"sag", "6V"}}), HasSubstr("power got the fault \"sag 6V\" by"));
}

TEST_F(Explain, ACrashNamesItsReasonAndPlaceAsFarAsTheyAreKnown) {
  EXPECT_EQ(why(Verdict::crashed), "The sketch crashed: for an unknown reason.");
  e.crash = exec::Crash{"division by zero", {}};
  EXPECT_EQ(why(Verdict::crashed), "The sketch crashed: division by zero.");
  e.crash->where = {"", "My.ino", 3};
  EXPECT_EQ(why(Verdict::crashed), "The sketch crashed: division by zero at My.ino:3.");
  e.crash->where = {"setup", "My.ino", 3};
  EXPECT_EQ(why(Verdict::crashed), "The sketch crashed: division by zero in setup, My.ino:3.");
  e.crash->check = "divrem_overflow";
  EXPECT_EQ(why(Verdict::crashed), "A check (--sanitize) failed: division by zero in setup, My.ino:3.");
}

TEST_F(Explain, ADivisionByZeroIsNamedIfTheRunFails) {
  e.divisions_by_zero = {{{"mean", "My.ino", 3}, 0.5, 7}};
  e.verdict = Verdict::lost;
  EXPECT_EQ(
      next_step(e).text,
      "the sketch divided by zero in mean, My.ino:3: the result is meaningless, so look at what uses it");
  e.verdict = Verdict::reached;
  EXPECT_EQ(next_step(e).text, "");
}

TEST_F(Explain, ASketchThatStopsItselfIsToldApartFromOneThatFallsSilent) {
  e.activity.where = {"loop", "My.ino", 4};
  for (const Verdict verdict : {Verdict::hung, Verdict::ended}) {
    e.activity.stopped_by = "exit(0)";
    EXPECT_THAT(why(verdict), StartsWith("The sketch stopped itself by exit(0) in loop, My.ino:4"));
    e.activity.stopped_by.clear();
    EXPECT_THAT(why(verdict), HasSubstr("for 2 s it called no Arduino function"));
  }
}

TEST_F(Explain, MotorsThatAreTooWeakToTurnAreToldWithTheirPower) {
  e.was_output[5] = e.went_high[5] = true;
  e.left_command = 0.12;
  e.right_command = -0.1;
  e.turning_drive = 0.131;
  for (const Verdict verdict : {Verdict::stuck, Verdict::timeout})
    EXPECT_THAT(next(verdict),
                HasSubstr("12 % and 10 % of full power, which is too little to turn the wheels; they "
                          "turn from 14 % on"));
  e.left_command = 0.14;
  for (const Verdict verdict : {Verdict::stuck, Verdict::timeout})
    EXPECT_EQ(next(verdict), "") << "something else holds the wheels";
  e.left_command = e.right_command = 0.0;
  e.wiring.clear();
  EXPECT_EQ(next(Verdict::timeout), "the robot never moved: it has no motors");
}

TEST_F(Explain, ADriverInStandbyIsNamedInsteadOfItsMotorPins) {
  e.wiring.push_back({"driver", "tb6612", "standby", 4});
  EXPECT_THAT(next(Verdict::timeout), Not(HasSubstr("standby"))) << "the sketch has not begun to drive";
  e.was_output[5] = e.went_high[5] = true;
  EXPECT_EQ(next(Verdict::timeout),
            "the robot never moved: the standby pin 4 of its motor driver was never set to OUTPUT, and the "
            "driver is "
            "off until this pin is HIGH");
  e.was_output[4] = true;
  EXPECT_THAT(next(Verdict::timeout), HasSubstr("standby pin 4 of its motor driver stayed LOW"));
  e.went_high[4] = true;
  EXPECT_THAT(next(Verdict::timeout), Not(HasSubstr("standby")));
}

TEST_F(Explain, ARobotThatNeverMovedIsLookedIntoPinByPin) {
  EXPECT_EQ(next(Verdict::timeout),
            "the robot never moved; motor pins 5 and 7 are inputs: no pinMode(…, OUTPUT) or analogWrite() "
            "has run for them");
  e.was_output[5] = e.was_output[7] = true;
  EXPECT_EQ(next(Verdict::timeout), "the robot never moved; motor pins 5 and 7 stayed LOW");
  e.went_high[7] = true;
  EXPECT_EQ(next(Verdict::timeout), "the robot never moved; its motors were never driven")
      << "one of the two inputs may stay low";
  e.went_high[5] = true;
  EXPECT_EQ(next(Verdict::timeout),
            "the robot never moved; its motors were never driven: with equal levels at both inputs, a driver "
            "brakes its motor");
  robot_is_at(9 * kSecond, {3, 1}, true, true);
  e.moved = false;
  EXPECT_EQ(
      next(Verdict::timeout),
      "the robot never moved; its motors were driven, but not strongly or long enough to turn the wheels");
}

TEST_F(Explain, AMotorOnAShiftRegisterWasNotDrivenByAPinOfTheBoard) {
  e.wiring = {{"left", "motor", "in1", 200}};
  EXPECT_EQ(next(Verdict::timeout), "the robot never moved; its motors were never driven");
}

TEST_F(Explain, AButtonThatIsWaitedForComesWithTheLineThatPressesIt) {
  e.activity.polled = 4;
  e.pin_level = true;
  EXPECT_THAT(
      next(Verdict::timeout),
      EndsWith("the pin that the sketch keeps reading is pin 4 (button \"start\"), which is HIGH: if it "
               "waits for this button, press it with this line in a script: at 1s press start 200ms"));
  EXPECT_EQ(next_step(e).by, NextStep::By::script);
  EXPECT_THAT(next(Verdict::crashed), Not(HasSubstr("keeps reading is"))) << "a crashed sketch reads nothing";
  e.pin_changed = true;
  EXPECT_THAT(next(Verdict::timeout), EndsWith("which is HIGH")) << "the button has been pressed";
}

TEST_F(Explain, ARobotThatTurnedAwayFromTheLineIsToldSo) {
  lose_the_line();
  e.steered = -0.4;
  e.line_side = 0.018;
  EXPECT_THAT(next(Verdict::lost),
              AllOf(StartsWith("it steered away from the line: the line was under its left "
                               "sensors, but it turned right; "),
                    HasSubstr("robosim wire"), Not(HasSubstr("16 bits"))));
  e.line_side = -0.018;
  EXPECT_THAT(next(Verdict::lost), HasSubstr("under its right sensors, but it turned left"));
  e.distance_m = 9.0;  // 9 m in 12 s are 1.5 m in the first 2 s
  EXPECT_EQ(next(Verdict::lost),
            "it steered away from the line: the line was under its right sensors, but it turned left; it had "
            "driven "
            "1.5 m until then: watch it in slow motion, or record what the sensors saw");
  e.distance_m = 0.0;
  e.int_bits = 16;
  EXPECT_THAT(next(Verdict::lost), AllOf(StartsWith("it steered away"), HasSubstr("int has 16 bits")));
  EXPECT_EQ(next_step(e).by, NextStep::By::host);
  e.int_bits = 32;
  robot_is_at(9 * kSecond, {6, 0}, false, true);
  EXPECT_THAT(next(Verdict::timeout), HasSubstr("steered away"));
  e.steered = 0.4;
  EXPECT_THAT(next(Verdict::lost), HasSubstr("slow motion"))
      << "the robot steered towards the line, but too late";
  e.steered = -0.4;
  e.faults.push_back({});
  EXPECT_THAT(next(Verdict::lost), Not(HasSubstr("steered away"))) << "the script caused a fault";
}

TEST_F(Explain, SensorsThatAreReadInSetupOnlyAreToldWhereTheLineIsLost) {
  lose_the_line();  // at 2 s
  e.sensors_read = kMillisecond;
  EXPECT_THAT(next(Verdict::lost), StartsWith("the sketch has read no line sensor since 0.00 s"));
  e.sensors_read = 1800 * kMillisecond;
  EXPECT_THAT(next(Verdict::lost), HasSubstr("slow motion"));
  e.sensors_read = kNever;
  EXPECT_THAT(next(Verdict::lost), HasSubstr("slow motion"))
      << "the robot has no sensors, or reads them without the sketch";
}

TEST_F(Explain, ALongDelayIsToldWhereTheLineIsLost) {
  lose_the_line();
  robot_is_at(11900 * kMillisecond, {4, 1}, false, true);
  e.activity.call = "delay(500)";
  e.activity.where = {"loop", "My.ino", 9};
  e.distance_m = 1.3;
  e.left_command = e.right_command = 0.5;
  EXPECT_EQ(next(Verdict::lost),
            "the sketch is in delay(500) in loop, My.ino:9: during this time it reads no sensor, but the "
            "robot drives on");
  e.steered = -0.4;
  e.line_side = 0.018;
  EXPECT_THAT(next(Verdict::lost), HasSubstr("delay(500)")) << "the late reaction looks like wrong steering";
  e.steered = 0.0;
  e.sensors_read = e.t;
  EXPECT_THAT(next(Verdict::lost), HasSubstr("slow motion"))
      << "a handler reads the sensors during the delay";
  e.sensors_read = kNever;
  e.distance_m = 0.6;
  EXPECT_THAT(next(Verdict::lost), HasSubstr("slow motion"))
      << "the robot drives only 2.5 cm during the delay";
  e.distance_m = 1.3;
  for (const char* call : {"delay(5)", "delay()", "delayMicroseconds(500)"}) {
    e.activity.call = call;
    EXPECT_THAT(next(Verdict::lost), HasSubstr("slow motion")) << call;
  }
  e.activity.call = "delay(500)";
  e.left_command = e.right_command = 0.0;
  EXPECT_THAT(next(Verdict::lost), HasSubstr("slow motion")) << "the motors are off";
}

TEST_F(Explain, MotorPinsThatWereNeverMadeOutputsAreNamedThoughPullUpsMoveThem) {
  lose_the_line();
  e.was_pulled_up.assign(20, false);
  e.was_pulled_up[5] = e.was_pulled_up[4] = true;  // pin 4 belongs to the button
  EXPECT_EQ(next(Verdict::lost),
            "motor pin 5 was never set to OUTPUT, and only its pull-up was on, as by digitalWrite(5, HIGH): "
            "pinMode(5, OUTPUT)");
  e.was_pulled_up[7] = true;
  EXPECT_THAT(next(Verdict::lost),
              HasSubstr("motor pins 5 and 7 were never set to OUTPUT, and only their pull"));
  e.was_pulled_up[7] = false;
  e.was_output[5] = true;
  EXPECT_THAT(next(Verdict::lost), HasSubstr("slow motion"));
}

TEST_F(Explain, AMotorThatNeverGotPowerIsNamedWithItsPinsIfTheOtherOneDid) {
  lose_the_line();
  e.wiring = {{"left", "motor", "en", 5, false, world::left},
              {"left", "motor", "in1", 7, false, world::left},
              {"left", "motor", "in2", 8, false, world::left},
              {"right", "motor", "en", 6, false, world::right},
              {"right", "motor", "in1", 9, false, world::right}};
  for (const Pin pin : {5, 6, 7, 8, 9}) e.was_output[pin] = true;
  e.went_high[6] = e.went_high[9] = e.went_high[7] = true;
  e.strongest_command[world::right] = 0.4;
  for (const Verdict verdict : {Verdict::lost, Verdict::stuck, Verdict::timeout})
    EXPECT_EQ(next(verdict), "the left motor never got power; motor pin 5 stayed LOW")
        << "in2 may stay low, since in1 was high";
  EXPECT_THAT(next(Verdict::crashed), Not(HasSubstr("never got power")));
  e.int_bits = 16;
  EXPECT_THAT(next(Verdict::lost),
              StartsWith("the left motor never got power; motor pin 5 stayed LOW; run it "
                         "on the host as well: "));
  EXPECT_EQ(next_step(e).by, NextStep::By::host);
  EXPECT_EQ(result::without_host(next(Verdict::lost)),
            "the left motor never got power; motor pin 5 stayed LOW");
  e.int_bits = 32;
  e.was_output[5] = false;
  EXPECT_THAT(next(Verdict::lost),
              HasSubstr("never got power; motor pin 5 is an input: no pinMode(…, OUTPUT)"));
  e.went_high[5] = e.went_high[8] = true;
  EXPECT_EQ(next(Verdict::lost),
            "the left motor never got power: with equal levels at both inputs, a driver brakes its motor");
  std::swap(e.strongest_command[world::left], e.strongest_command[world::right]);
  EXPECT_EQ(next(Verdict::lost), "the right motor never got power") << "all its pins were high at some time";
  e.strongest_command[world::right] = 0.02;
  EXPECT_THAT(next(Verdict::lost), Not(HasSubstr("never got power"))) << "weak power is power";
  e.strongest_command[world::left] = e.strongest_command[world::right] = 0.0;
  EXPECT_THAT(next(Verdict::lost), Not(HasSubstr("never got power"))) << "neither wheel got power";
}

TEST_F(Explain, ACrashInAPinFunctionIsDueToItsNumber) {
  e.board = find_board("uno");
  e.crash = exec::Crash{"read of address 0x930F", {}};
  EXPECT_EQ(next(Verdict::crashed), "");
  e.crash->calls = {{"digitalWrite", "arduino/wiring_digital.c", 159}, {"loop", "My.ino", 6}};
  EXPECT_EQ(next(Verdict::crashed), "digitalWrite() got a number that is not a pin of the uno");
  e.crash->calls[0].function = "drive";
  EXPECT_EQ(next(Verdict::crashed), "");
}

TEST_F(Explain, NothingIsAdvisedWhereTheVerdictSaysItAll) {
  EXPECT_EQ(next(Verdict::reached), "");
  EXPECT_EQ(next(Verdict::interrupted), "");
  e.moved = true;
  EXPECT_EQ(next(Verdict::stuck), "");
}

TEST_F(Explain, ALineThatWasLostIsLookedForOnTheHostIfTheFirmwaresIntIsNarrow) {
  e.moved = true;
  EXPECT_EQ(next(Verdict::lost), "watch it in slow motion, or record what the sensors saw");
  EXPECT_EQ(next_step(e).by, NextStep::By::watching);
  e.int_bits = 16;
  EXPECT_THAT(next(Verdict::lost),
              AllOf(StartsWith("run it on the host as well: if it keeps the line there, "),
                    HasSubstr("16 bits"), Not(HasSubstr("slow motion"))));
  EXPECT_EQ(next_step(e).by, NextStep::By::host);
}

TEST_F(Explain, TheDecisiveMomentIsWhereTheSketchEndedIfItEndedTheRun) {
  const auto moment = [&](Verdict verdict) {
    e.verdict = verdict;
    return decisive_moment(e).text;
  };
  EXPECT_EQ(moment(Verdict::crashed), "the sketch crashed");
  EXPECT_EQ(moment(Verdict::toppled), "the robot toppled");
  for (const Verdict verdict : {Verdict::hung, Verdict::ended}) {
    e.activity.stopped_by.clear();
    EXPECT_EQ(moment(verdict), "the sketch loops here and calls no functions any more");
    e.activity.stopped_by = "exit(0)";
    EXPECT_EQ(moment(verdict), "the sketch stopped itself here");
  }
  for (const Verdict verdict : {Verdict::reached, Verdict::over_budget, Verdict::interrupted})
    EXPECT_EQ(moment(verdict), "");
}

TEST_F(Explain, TheDecisiveMomentOfALostRobotIsItsLastSightOfTheLine) {
  e.verdict = Verdict::lost;
  e.moved = true;
  EXPECT_EQ(decisive_moment(e).text, "the robot drove, but no sensor had seen a line");
  lose_the_line();
  EXPECT_EQ(decisive_moment(e).text, "the robot left the line");
  EXPECT_EQ(decisive_moment(e).t, 2 * kSecond);
}

TEST_F(Explain, TheDecisiveMomentOfATimeoutIsWhatEndedTheDrive) {
  e.verdict = Verdict::timeout;
  EXPECT_EQ(decisive_moment(e).text, "the robot has not moved, and the sketch was here");
  e.power = {.on = false, .since = 7 * kSecond};
  EXPECT_EQ(decisive_moment(e).text, "the board lost its power");
  lose_the_line();
  e.at.x += 0.1;
  EXPECT_EQ(decisive_moment(e).text, "the robot left the line")
      << "the robot left the line before the power was off";
  e.power = {};
  robot_is_at(9 * kSecond, {5, 1}, true, true);
  robot_is_at(12 * kSecond, {5, 1}, true, false);
  EXPECT_EQ(decisive_moment(e).text, "its motors stopped here and stayed off");
  EXPECT_EQ(decisive_moment(e).t, 9 * kSecond);
  robot_is_at(12 * kSecond, {6, 1}, true, true);
  EXPECT_EQ(decisive_moment(e).text, "the robot was still driving when its time was up");
  robot_is_at(12 * kSecond + 500 * kMillisecond, {6, 1}, true, false);
  e.t += 500 * kMillisecond;
  EXPECT_EQ(decisive_moment(e).text,
            "the robot's motors were driven until less than a second before its time was up");
}

TEST_F(Explain, AnOverflowOnAChipIsExplainedByItsInt) {
  e.crash = exec::Crash{"1000 * 40 does not fit an int, which holds -32768 to 32767 here", {}};
  e.crash->check = "mul_overflow";
  e.int_bits = 16;
  EXPECT_THAT(next(Verdict::crashed), HasSubstr("On the chip, an int has 16 bits"));
  e.int_bits = 32;
  EXPECT_EQ(next(Verdict::crashed), "");
  e.int_bits = 16;
  e.crash->check = "out_of_bounds";
  EXPECT_EQ(next(Verdict::crashed), "");
  e.crash = exec::Crash{"2000000000 + 2000000000 does not fit a long, which holds … here", {}};
  e.crash->check = "add_overflow";
  EXPECT_EQ(next(Verdict::crashed), "") << "the number's type is already long";
  e.crash->reason = "-32500 + -2500 does not fit an int, which holds -32768 to 32767 here";
  EXPECT_THAT(next(Verdict::crashed), HasSubstr("declare the variables as long, or limit the result"));
}

}  // namespace robosim::judge::explain_test
