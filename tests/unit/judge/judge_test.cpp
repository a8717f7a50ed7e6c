#include "sim/judge/judge.h"

#include <gtest/gtest.h>

#include <cmath>

namespace robosim::judge::judge_test {

// A robot that a test moves manually.
struct Driver {
  explicit Driver(bool senses = true) : judge(senses) {
    now.pose = &pose;
    now.sees_line = true;
  }
  // Runs for `duration`, or until the judge returns a verdict. Returns the verdict. Calls `each` before every
  // tick to change the situation.
  template <typename Each>
  std::optional<Verdict> run(SimTime duration, Each each) {
    const SimTime end = now.t + duration;
    while (now.t < end) {
      now.t += kTick;
      each();
      if (const auto verdict = judge.look(now)) return verdict;
    }
    return std::nullopt;
  }
  void call() { now.last_call = now.t; }

  Judge judge;
  Pose pose;
  Situation now;
};

TEST(Judge, CallsItLostAfterOneMetreOfWheelTravelWithoutALine) {
  Driver d;
  EXPECT_EQ(d.run(kSecond,
                  [&] {
                    d.call();
                    d.now.wheel_travel_m += 0.001;
                    d.pose.position.x += 0.001;
                  }),
            std::nullopt);
  d.now.sees_line = false;
  EXPECT_EQ(d.run(3 * kSecond,
                  [&] {
                    d.call();
                    d.now.wheel_travel_m += 0.001;
                    d.pose.position.x += 0.001;
                  }),
            Verdict::lost);
  EXPECT_NEAR(d.now.wheel_travel_m, 2.0, 0.0015);
  ASSERT_TRUE(d.judge.line_last_seen());
  EXPECT_EQ(d.judge.line_last_seen()->at, kSecond);
}

TEST(Judge, CallsARobotStuckThatCreepsAlongWhatItPushesAgainst) {
  const auto ends = [](double mm_per_s, double degrees_per_s, bool touches, bool driven) {
    Driver d;
    d.now.driven = driven;
    double angle = 0.0;
    return d.run(20 * kSecond, [&] {
      d.call();
      d.pose.position.y += mm_per_s * 1e-6;
      angle += degrees_per_s * 1e-3 * 0.0174532925;
      d.pose.heading = {std::cos(angle), std::sin(angle)};
      d.now.driven = driven && d.now.t % (100 * kMillisecond) < 50 * kMillisecond;       // pulsed motors
      d.now.in_contact = touches && d.now.t % (100 * kMillisecond) < 20 * kMillisecond;  // bounces
    });
  };
  EXPECT_EQ(ends(10.0, 2.0, true, true), Verdict::stuck);
  EXPECT_EQ(ends(30.0, 2.0, true, true), std::nullopt) << "the robot follows the wall";
  EXPECT_EQ(ends(10.0, 10.0, true, true), std::nullopt) << "the robot turns away";
  EXPECT_EQ(ends(10.0, 2.0, false, true), std::nullopt) << "the robot touches nothing";
  EXPECT_EQ(ends(10.0, 2.0, true, false), std::nullopt) << "something else moves the robot";
}

TEST(Judge, HasNotSeenALineWhereARobotHasNoSensorsForIt) {
  Driver d(false);
  d.run(kSecond, [&] { d.call(); });
  EXPECT_FALSE(d.judge.line_last_seen());
}

TEST(Judge, NeverCallsARobotWithoutLineSensorsLost) {
  Driver d(false);
  d.now.sees_line = false;
  EXPECT_EQ(d.run(5 * kSecond,
                  [&] {
                    d.call();
                    d.now.wheel_travel_m += 0.001;
                    d.pose.position.x += 0.001;
                  }),
            std::nullopt);
}

TEST(Judge, CallsItStuckAfterThreeSecondsOfDrivingWithoutMoving) {
  Driver d;
  d.now.driven = true;
  EXPECT_EQ(d.run(10 * kSecond, [&] { d.call(); }), Verdict::stuck);
  EXPECT_NEAR(static_cast<double>(d.now.t), 3e9, 2e6);
}

TEST(Judge, SeesTurningOnTheSpotAndMovingAsNotStuck) {
  Driver d;
  d.now.driven = true;
  const Vec2 a{1.0, 0.0}, b{0.9986, 0.0523};  // 3 degrees apart
  EXPECT_EQ(d.run(10 * kSecond,
                  [&] {
                    d.call();
                    d.pose.heading = d.now.t / kSecond % 2 ? a : b;
                  }),
            std::nullopt);
  EXPECT_EQ(d.run(10 * kSecond,
                  [&] {
                    d.call();
                    d.pose.position.x += 1e-6;
                  }),
            std::nullopt);
}

TEST(Judge, KnowsSinceWhenARobotThatTurnsOnTheSpotIsInOnePlace) {
  Driver d;
  d.now.driven = true;
  const Vec2 headings[] = {{1.0, 0.0}, {0.0, 1.0}, {-1.0, 0.0}, {0.0, -1.0}};
  d.run(2 * kSecond, [&] {
    d.call();
    d.pose.position.x += 0.0002;
  });
  EXPECT_GT(d.judge.place().since, 1500 * kMillisecond);
  const SimTime before = d.judge.place().since;
  d.run(60 * kSecond, [&] {
    d.call();
    d.pose.heading = headings[d.now.t / kSecond % 4];
  });
  EXPECT_EQ(d.judge.place().since, before);
  EXPECT_EQ(d.judge.last_driven(), d.now.t);
}

TEST(Judge, SumsTheTurnsOfARobotInOnePlaceAndAroundIt) {
  Driver d;
  d.now.driven = true;
  const auto turn = [&](double rad_per_ms) {
    const Vec2 h = d.pose.heading;
    const double s = std::sin(rad_per_ms), c = std::cos(rad_per_ms);
    d.call();
    d.pose.heading = {h.x * c - h.y * s, h.x * s + h.y * c};
  };
  d.run(10 * kSecond, [&] { turn(0.004); });
  EXPECT_NEAR(d.judge.turned_during(d.judge.place()), 40.0, 0.1);
  EXPECT_NEAR(1e-9 * static_cast<double>(d.judge.turns_since(d.judge.place())), 0.05, 0.01);
  d.run(10 * kSecond, [&] { turn(-0.004); });
  EXPECT_NEAR(d.judge.turned_during(d.judge.place()), 0.0, 0.1) << "turns back and forth cancel each other";
  d.run(10 * kSecond, [&] {  // a circle with a radius of 0.3 m
    turn(0.002);
    d.pose.position = d.pose.position + d.pose.heading * 0.0006;
  });
  EXPECT_LT(d.judge.place().since, d.now.t);
  EXPECT_LT(std::abs(d.judge.turned_during(d.judge.place())), 1.0) << "the robot has left each place";
  EXPECT_NEAR(d.judge.turned_during(d.judge.surroundings()), 20.0, 0.1);
  EXPECT_EQ(d.judge.surroundings().since, 0);
}

TEST(Judge, KnowsSinceWhenARobotThatSwungFirstTurnsInOneDirection) {
  Driver d;
  d.now.driven = true;
  const auto turn = [&](double rad_per_ms) {
    const Vec2 h = d.pose.heading;
    const double s = std::sin(rad_per_ms), c = std::cos(rad_per_ms);
    d.call();
    d.pose.heading = {h.x * c - h.y * s, h.x * s + h.y * c};
  };
  for (int swing = 0; swing < 3; ++swing) {
    d.run(kSecond / 2, [&] { turn(0.002); });
    d.run(kSecond / 2, [&] { turn(-0.002); });
  }
  const SimTime began = d.now.t;
  d.run(5 * kSecond, [&] { turn(-0.004); });
  EXPECT_NEAR(1e-9 * static_cast<double>(d.judge.turns_since(d.judge.place()) - began), 0.05, 0.02);
}

TEST(Judge, KnowsSinceWhenARobotThatWaitedFirstDrivesInOnePlace) {
  Driver d;
  d.run(3 * kSecond, [&] { d.call(); });
  d.now.driven = true;
  const SimTime began = d.now.t;
  d.run(2 * kSecond, [&] {
    d.call();
    d.pose.heading = d.now.t / kSecond % 2 ? Vec2{1.0, 0.0} : Vec2{0.0, 1.0};
  });
  EXPECT_NEAR(static_cast<double>(d.judge.drives_here_since()), static_cast<double>(began), 2e6);
  EXPECT_TRUE(d.judge.drives(d.now.t));
}

TEST(Judge, ShortPausesDoNotInterruptDrivingAndLongOnesDo) {
  Driver d;
  const auto drive_with_pauses = [&](SimTime pause) {
    d.run(6 * kSecond, [&] {
      d.call();
      d.now.driven = d.now.t % (pause + kSecond) >= pause;
      d.pose.heading = d.now.t / kSecond % 2 ? Vec2{1.0, 0.0} : Vec2{0.0, 1.0};
    });
  };
  drive_with_pauses(kSecond / 2);
  EXPECT_LT(d.judge.drives_here_since(), kSecond);
  drive_with_pauses(2 * kSecond);
  EXPECT_GT(d.judge.drives_here_since(), 6 * kSecond);
}

TEST(Judge, CountsPulsedMotorsAsDrivenAndParkedOnesNot) {
  Driver pulsed;
  EXPECT_EQ(pulsed.run(10 * kSecond,
                       [&] {
                         pulsed.call();
                         pulsed.now.driven = pulsed.now.t / kTick % 30 < 10;
                       }),
            Verdict::stuck);
  Driver parked;
  EXPECT_EQ(parked.run(60 * kSecond, [&] { parked.call(); }), std::nullopt);
}

TEST(Judge, TellsAHangFromAParkedSketchByItsMotors) {
  Driver hung;
  hung.now.driven = true;
  hung.now.hangs = true;
  EXPECT_EQ(hung.run(10 * kSecond, [] {}), Verdict::hung);
  EXPECT_EQ(hung.now.t, 2 * kSecond);
  Driver ended;
  ended.now.hangs = true;
  EXPECT_EQ(ended.run(10 * kSecond, [] {}), Verdict::ended);
}

TEST(Judge, WaitsForASilentSketchThatMayGoOn) {
  Driver waits;
  EXPECT_EQ(waits.run(600 * kSecond, [] {}), std::nullopt);
  waits.now.hangs = true;
  EXPECT_EQ(waits.run(kSecond, [] {}), Verdict::ended);
}

TEST(Judge, ForgivesSilenceWhileThePowerIsOff) {
  Driver d;
  d.now.powered = false;
  EXPECT_EQ(d.run(10 * kSecond, [] {}), std::nullopt);
}

}  // namespace robosim::judge::judge_test
