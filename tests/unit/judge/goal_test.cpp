#include "sim/judge/goal.h"

#include <gmock/gmock.h>

#include <cmath>

#include "sim/base/error.h"
#include "tests/support/refusal.h"
#include "tests/unit/judge/hand_moved.h"

namespace robosim::judge::goal_test {

struct Course : HandMoved {
  explicit Course(const char* text, const char* goal) : HandMoved(text, goal ? goal : "") {}
  // Puts the robot on a cell for 10 ms. Returns whether the goal is reached, as wait() does.
  bool visit(int x, int y) {
    put(map.centre({x, y}));
    for (int i = 0; i < 9; ++i) look();
    return progress.reached();
  }
  bool wait(SimTime duration) {
    for (const SimTime end = now + duration; now < end && !progress.reached();) look();
    return progress.reached();
  }
};

constexpr const char* kFork =
    "_______\n"
    "_S1111_\n"
    "___1___\n"
    "___1___\n"
    "_______\n";

constexpr const char* kRing =
    "_____\n"
    "_S11_\n"
    "_1_1_\n"
    "_111_\n"
    "_____\n";

TEST(Goal, IsWrittenAsItIsRead) {
  for (const char* text : {"tour", "laps:3", "station:2", "station:dock", "robotrace", "ukmars", "drag-race",
                           "rescue-line", "line-maze", "line-maze:3", "still", "none"})
    EXPECT_EQ(to_string(parse_goal(text)), text);
}

TEST(Goal, RefusesWhatItDoesNotKnow) {
  for (const char* text :
       {"", "win", "laps", "laps:", "laps:0", "laps:x", "laps:3x", "station:", "tour:2", "still:1",
        "robotrace:1", "ukmars:2", "drag-race:1", "rescue-line:entry", "line-maze:0", "line-maze:4"})
    EXPECT_THROW(parse_goal(text), InputError) << text;
}

TEST(Goal, TourWantsEveryStationAndThenTheStart) {
  Course c(kFork, "tour");
  EXPECT_FALSE(c.visit(1, 1));
  EXPECT_FALSE(c.visit(5, 1));
  EXPECT_FALSE(c.visit(1, 1)) << "one station is missing";
  EXPECT_FALSE(c.visit(3, 3));
  EXPECT_TRUE(c.visit(1, 1));
  std::vector<std::string> visited;
  for (const auto& what : c.events) visited.push_back(std::get<result::StationVisited>(what).station);
  EXPECT_THAT(visited, testing::ElementsAre("1", testing::_, testing::_));
}

TEST(Goal, ATourSaysWhetherStationsOrTheWayBackAreMissing) {
  Course c(kFork, "tour");
  EXPECT_EQ(c.summary(), "0 of 3 stations visited");
  c.visit(5, 1);
  EXPECT_EQ(c.summary(), "1 of 3 stations visited");
  for (const auto& [x, y] : std::vector<std::pair<int, int>>{{1, 1}, {3, 3}}) c.visit(x, y);
  c.visit(3, 1);
  EXPECT_EQ(c.summary(), "all 3 stations visited, but not back at the start");
}

TEST(Goal, LapsCountEitherWayRoundButOnlyInOrder) {
  const std::vector<std::pair<int, int>> ring = {{2, 1}, {3, 1}, {3, 2}, {3, 3},
                                                 {2, 3}, {1, 3}, {1, 2}, {1, 1}};
  Course clockwise(kRing, "laps:2");
  Course counter(kRing, "laps:2");
  Course cheat(kRing, "laps:1");
  for (int lap = 0; lap < 2; ++lap) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const bool last = lap == 1 && i + 1 == ring.size();
      EXPECT_EQ(clockwise.visit(ring[i].first, ring[i].second), last);
      const auto [x, y] = i + 1 == ring.size() ? ring[i] : ring[ring.size() - 2 - i];
      EXPECT_EQ(counter.visit(x, y), last);
    }
    for (const std::size_t i : {0u, 7u, 0u, 7u}) EXPECT_FALSE(cheat.visit(ring[i].first, ring[i].second));
  }
  EXPECT_EQ(clockwise.progress.laps_s().size(), 2u);
}

/// Drives a robot over the cells of kRing, which are numbered from 0. Cell 0 is the start, and cell 8 is the
/// start after a lap.
struct Ring : Course {
  Ring() : Course(kRing, "laps:9") { visit(1, 1); }
  /// Drives to a cell, forwards or backwards. Returns the number of laps so far.
  std::size_t drive(int to) {
    constexpr std::pair<int, int> kCells[] = {{1, 1}, {2, 1}, {3, 1}, {3, 2}, {3, 3}, {2, 3}, {1, 3}, {1, 2}};
    while (at != to) {
      at += at < to ? 1 : -1;
      const auto [x, y] = kCells[static_cast<std::size_t>((at % 8 + 8) % 8)];
      visit(x, y);
    }
    return progress.laps_s().size();
  }
  int at = 0;
};

TEST(Goal, ARobotThatTurnsBackHalfWayOnBothSidesHasNotGoneRound) {
  for (const int far : {5, 6, 7}) {
    Ring to_and_fro;
    EXPECT_EQ(to_and_fro.drive(far), 0u);
    EXPECT_EQ(to_and_fro.drive(-far), 0u);
    EXPECT_EQ(to_and_fro.drive(0), 0u)
        << "the robot passed all nodes in order, but turned back " << far << " cells from 0";
    EXPECT_EQ(to_and_fro.drive(8), 1u);
  }
}

TEST(Goal, ALapCountsAlthoughTheRobotTurnedBackDuringItOrBefore) {
  Ring in_between;
  in_between.drive(5);
  in_between.drive(2);
  EXPECT_EQ(in_between.drive(8), 1u);
  EXPECT_EQ(in_between.drive(16), 2u);
  Ring before;
  before.drive(-3);
  EXPECT_EQ(before.drive(7), 0u);
  EXPECT_EQ(before.drive(8), 1u);
  Ring both_ways;
  EXPECT_EQ(both_ways.drive(8), 1u);
  EXPECT_EQ(both_ways.drive(0), 2u) << "the second lap is the other way round";
  EXPECT_EQ(both_ways.drive(-8), 3u);
}

// A square of 1.2 m with round corners. The goal line is 0.5 m before the start line.
constexpr const char* kRace = R"(+++
size = ["2 m", "2 m"]
goal = "robotrace"
[start]
along = "4.3 m"
[[path]]
from = ["1.2 m", "200 mm"]
segments = [
  { length = "200 mm" }, { radius = "200 mm", angle = "90 deg" }, { length = "800 mm" }, { radius = "200 mm", angle = "90 deg" },
  { length = "800 mm" }, { radius = "200 mm", angle = "90 deg" }, { length = "800 mm" }, { radius = "200 mm", angle = "90 deg" },
  { length = "600 mm" },
]
[race]
start = "0 mm"
goal = "3.9566 m"
+++
)";

// Moves the robot manually along the path, 5 mm per millisecond.
struct RaceCourse : Course {
  explicit RaceCourse(const char* goal = nullptr) : Course(kRace, goal) {}
  const map::Path& path() const { return map.course.paths.front(); }
  void drive(double from, double to) {
    for (double at = from; at < to; at += 0.005) {
      body.place(path().at(at, true));
      progress.update(body, now += kTick, events);
    }
  }
};

TEST(Goal, RobotraceIsTimedFromTheStartLineToTheGoalLineAndEndsAtRestBetweenThem) {
  RaceCourse c;
  const double length = c.path().length();
  c.drive(length - 0.5, length - 0.1);
  EXPECT_EQ(c.progress.summary(), "the start line was not passed");
  c.drive(length - 0.1, length + 2.0);
  EXPECT_THAT(c.progress.summary(), testing::HasSubstr(" of 3.96 m from the start line to the goal line"));
  c.drive(length + 2.0, length + 3.0);
  EXPECT_TRUE(c.progress.laps_s().empty());
  c.drive(length + 3.0, 2 * length - 0.25);
  ASSERT_EQ(c.progress.laps_s().size(), 1u);
  // 3.9566 m at 5 m/s take 0.7913 s. The judge checks the robot's place only every 4 mm.
  EXPECT_NEAR(c.progress.laps_s()[0], 0.7913, 0.002);
  EXPECT_FALSE(c.wait(1900 * kMillisecond));
  EXPECT_THAT(c.progress.summary(), testing::HasSubstr("but the robot was not at rest for 2 s"));
  EXPECT_TRUE(c.wait(100 * kMillisecond));
  EXPECT_THAT(c.progress.summary(), testing::HasSubstr("and the robot stopped in the area"));
}

TEST(Goal, RobotraceIsNotReachedBehindTheAreaOrWithoutTheWholeCourse) {
  RaceCourse beyond;
  const double length = beyond.path().length();
  beyond.drive(length - 0.5, 2 * length + 0.5);
  EXPECT_EQ(beyond.progress.laps_s().size(), 1u);
  EXPECT_FALSE(beyond.wait(5 * kSecond));
  RaceCourse cheat;
  cheat.drive(length - 0.5, length + 1.0);
  cheat.drive(length + 2.0, 2 * length - 0.25);
  EXPECT_FALSE(cheat.wait(5 * kSecond));
  EXPECT_TRUE(cheat.progress.laps_s().empty());
  RaceCourse still;
  EXPECT_FALSE(still.wait(5 * kSecond));
  EXPECT_EQ(still.progress.summary(), "the start line was not passed");
}

TEST(Goal, UkmarsIsTimedInTheSameWayAndNeedsNoStop) {
  RaceCourse c("ukmars");
  const double length = c.path().length();
  c.drive(length - 0.5, 2 * length + 1.0);
  result::Metrics metrics;
  c.progress.score(metrics);
  EXPECT_NEAR(metrics.score, 0.7913, 0.002);
  EXPECT_FALSE(c.progress.reached());
  EXPECT_EQ(c.progress.summary(), "the goal line was passed after 0.79 s");
  c.drive(length + 1.0, 3 * length);
  c.drive(length, 3 * length);
  EXPECT_TRUE(c.progress.reached());
}

TEST(Goal, RobotraceNeedsItsLines) { EXPECT_THROW(Course(kRing, "robotrace"), InputError); }

TEST(Goal, TheFirstLapBeginsWhenTheRobotLeavesItsStart) {
  Course c(kRing, "laps:1");
  c.wait(5 * kSecond);
  const Vec2 start = c.body.pose().position;
  for (const double turned : {0.5, -0.5}) {  // turns left and right, as a robot does to calibrate
    c.body.place({start + Vec2{0.008, 0.0}, {std::cos(turned), std::sin(turned)}});
    c.wait(kSecond);
  }
  for (const auto& [x, y] :
       std::vector<std::pair<int, int>>{{2, 1}, {3, 1}, {3, 2}, {3, 3}, {2, 3}, {1, 3}, {1, 2}, {1, 1}})
    c.visit(x, y);
  ASSERT_EQ(c.progress.laps_s().size(), 1u);
  EXPECT_NEAR(c.progress.laps_s()[0], 0.071, 0.002) << "10 ms at each of the first 7 of 8 places";
}

TEST(Goal, ARobotThatRestsWhereItJustCoversAStationHasVisitedIt) {
  Course c(kFork, "station:2");
  const Vec2 two = c.progress.stations()[1].centre;
  const auto rest_short_of_it_by = [&](double distance) {
    c.body.place({two - Vec2{distance, 0.0}, {1.0, 0.0}});
    c.wait(100 * kMillisecond);
    return c.progress.is_visited("2");
  };
  EXPECT_FALSE(rest_short_of_it_by(0.061));
  EXPECT_TRUE(rest_short_of_it_by(0.059));
}

TEST(Goal, StationWantsRestThere) {
  Course c(kFork, "station:2");
  EXPECT_FALSE(c.wait(2 * kSecond)) << "the robot rests at the start";
  EXPECT_FALSE(c.visit(3, 1));
  EXPECT_EQ(c.summary(), "station 2 not visited");
  const Vec2 two = c.progress.stations()[1].centre;
  c.body.place({two, {1.0, 0.0}});
  EXPECT_FALSE(c.wait(400 * kMillisecond));
  EXPECT_EQ(c.summary(), "station 2 visited, but not at rest there for 0.5 s");
  EXPECT_TRUE(c.wait(200 * kMillisecond));
  EXPECT_EQ(c.summary(), "station 2 reached, and at rest there");
}

TEST(Goal, StillSaysWhetherTheRobotEverMoved) {
  Course c(kFork, "still");
  c.wait(2 * kSecond);
  EXPECT_EQ(c.summary(), "it never moved");
}

TEST(Goal, NoneSaysThatNoneWasSet) {
  EXPECT_EQ(Course(kFork, "none").summary(), "no goal was set");
  EXPECT_NE(Course(kFork, "still").summary(), "no goal was set");
}

TEST(Goal, NamesTheStationsThatExistAndTheGoalThatFits) {
  EXPECT_EQ(test::refusal([] { Course c(kFork, "station:9"); }),
            "test.map: unknown station: expected 1, 2 or 3, got “9”");
  EXPECT_THROW(Course(kFork, "laps:1"), InputError);
}

TEST(Goal, DefaultsToALapOnALoopAndToATourElsewhere) {
  EXPECT_EQ(to_string(default_goal(Course(kRing, nullptr).map, Course(kRing, nullptr).network)), "laps:1");
  EXPECT_EQ(to_string(default_goal(Course(kFork, nullptr).map, Course(kFork, nullptr).network)), "tour");
}

}  // namespace robosim::judge::goal_test
