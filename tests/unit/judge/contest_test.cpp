// Tests the scoring of drag races and of RoboCupJunior Rescue Line. The tests move a robot of 60 mm radius
// manually.
#include "sim/judge/contest.h"

#include <gmock/gmock.h>

#include <map>
#include <string>

#include "tests/unit/judge/hand_moved.h"

namespace robosim::judge::contest_test {

using ::testing::EndsWith;
using ::testing::HasSubstr;

struct Pushed : HandMoved {
  using HandMoved::HandMoved;
  // Moves the robot along the first path.
  void follow(double from, double to) {
    for (double along = from; along <= to; along += 0.001) put(map.course.paths[0].at(along, false).position);
  }
  int lacks() const {
    for (const result::ScorePart& part : score().score_parts)
      if (part.part == "lack of progress") return part.count;
    return 0;
  }
};

constexpr const char* kStrip = R"(+++
size = ["5 m", "600 mm"]
goal = "drag-race"
[[path]]
from = ["200 mm", "300 mm"]
segments = [{ length = "4.5 m" }]
[race]
start = "100 mm"
goal = "3.1 m"
braking = "1 m"
signal = "1 s"
+++
)";

TEST(DragRace, IsTimedFromTheSignalToTheFinishLineAndEndsWhereTheRobotStops) {
  Pushed race(kStrip);
  race.wait(1500 * kMillisecond);
  EXPECT_EQ(race.summary(), "the finish line was not passed");
  race.push({3.5, 0.3});
  // The robot starts half a second after the signal. It moves at 1 m/s from x = 0.2 m to x = 3.3 m - 0.06 m.
  EXPECT_NEAR(race.score().run_s, 3.54, 0.01);
  EXPECT_FALSE(race.progress.reached());
  EXPECT_EQ(race.summary(), "the finish line was passed after 3.54 s, but the robot did not stop after it");
  race.wait(500 * kMillisecond);
  EXPECT_TRUE(race.progress.reached());
  EXPECT_NEAR(race.score().score, 3.54, 0.01);
  EXPECT_THAT(race.summary(), HasSubstr("stopped within the braking distance"));
}

TEST(DragRace, OverrunningTheBrakingDistanceAndAHandCostFiveSecondsEach) {
  Pushed race(kStrip);
  race.wait(1000 * kMillisecond);
  race.push({1.0, 0.3});
  race.body.lift(true);
  race.look();
  race.body.lift(false);
  race.push({4.25, 0.3});
  race.wait(600 * kMillisecond);
  EXPECT_NEAR(race.score().score, race.score().run_s + 10.0, 1e-9);
  EXPECT_THAT(race.summary(), HasSubstr("2 × 5 s were added, because the braking distance was overrun"));
}

TEST(DragRace, WhoLeavesBeforeTheSignalIsOut) {
  Pushed race(kStrip);
  race.push({4.0, 0.3});
  race.wait(2 * kSecond);
  EXPECT_FALSE(race.progress.reached());
  EXPECT_TRUE(std::isnan(race.score().score));
  EXPECT_EQ(race.summary(), "the robot left before the starting signal and is disqualified");
}

// Returns a map with six tiles in a row: start, gap, checkpoint, intersection, obstacle and end. A cell is
// 100 mm wide, and a tile has 3 x 3 cells.
std::string rescue(const char* league = "line") {
  const std::string empty(18, '_');
  std::string text = std::string("+++\ngoal = \"rescue-line\"\n[rescue]\nleague = \"") + league + R"("
checkpoints = ["600 mm"]
[[path]]
from = ["150 mm", "450 mm"]
segments = [{ length = "200 mm" }, { length = "100 mm", gap = true }, { length = "1200 mm" }]
[[path]]
from = ["1050 mm", "450 mm"]
heading = "90 deg"
segments = [{ length = "150 mm" }]
+++
)";
  for (int row = 0; row < 9; ++row) text += (row == 4 ? "_____________#____" : empty) + "\n";
  return text;
}

TEST(RescueLine, GivesThePointsOfItsRules) {
  Pushed run(rescue());
  run.follow(0.0, 0.35);
  EXPECT_EQ(run.score().score, 5.0);  // the start tile
  run.follow(0.35, 0.5);
  EXPECT_EQ(run.score().score, 5.0 + 10.0 + 2 * 5.0);  // plus the gap, and two tiles at the checkpoint
  run.follow(0.5, 1.1);
  EXPECT_EQ(run.score().score, 35.0);  // plus the intersection
  run.push({1.2, 0.7});                // drives around the obstacle at 1.35 m
  run.push({1.5, 0.7});
  EXPECT_EQ(run.lacks(), 0);
  EXPECT_THAT(run.summary(), EndsWith("5 of 6 tiles, 0 lacks of progress"));
  run.push({1.55, 0.45});
  EXPECT_EQ(run.score().score, 35.0 + 20.0 + 3 * 5.0);
  EXPECT_FALSE(run.progress.reached());
  EXPECT_THAT(run.summary(), EndsWith("6 of 6 tiles, 0 lacks of progress, but the robot was not at rest on "
                                      "the end tile for 5 s"));
  run.wait(5100 * kMillisecond);
  EXPECT_TRUE(run.progress.reached());
  EXPECT_EQ(run.score().score, 130.0);
  EXPECT_EQ(run.summary(), "130 points, 6 of 6 tiles, 0 lacks of progress");
}

TEST(RescueLine, EntryCountsItsOwnHazardsOnlyAndLessForAnObstacle) {
  Pushed run(rescue("entry"));
  run.follow(0.0, 1.1);
  run.push({1.2, 0.7});
  run.push({1.5, 0.7});
  run.push({1.55, 0.45});
  run.wait(5100 * kMillisecond);
  EXPECT_TRUE(run.progress.reached());
  EXPECT_EQ(run.score().score, 10.0 + 10.0 + 5 * 5.0);  // a gap, an obstacle, five tiles after the start
  EXPECT_FALSE(run.progress.contest().over(359 * kSecond));
  EXPECT_TRUE(run.progress.contest().over(360 * kSecond));
}

// Returns a map with tiles in a row. The first tiles are a flat tile, a bump, a ramp of two tiles, the ramp's
// top and a seesaw. The last ones are a tile that is 3 mm high, and a tile with two bumps and two gaps.
std::string hills(const char* league) {
  std::string text =
      std::string("+++\nsize = [\"3 m\", \"300 mm\"]\ngoal = \"rescue-line\"\n[rescue]\nleague = \"") +
      league + R"("
checkpoints = ["2300 mm"]
[[path]]
from = ["150 mm", "150 mm"]
segments = [{ length = "1960 mm" }, { length = "50 mm", gap = true }, { length = "100 mm" }, { length = "50 mm", gap = true }, { length = "540 mm" }]
)";
  const auto hill = [&](int middle, int length, const char* shape) {
    text += "[[hill]]\nat = [\"" + std::to_string(middle) + " mm\", \"150 mm\"]\nsize = [\"" +
            std::to_string(length) + " mm\", \"300 mm\"]\n" + shape + "\n";
  };
  hill(450, 60, "heights = [\"0 mm\", \"10 mm\", \"0 mm\"]");
  hill(900, 600, "slope = \"20 deg\"");
  hill(1350, 300, "heights = [\"205 mm\", \"205 mm\"]");
  hill(1650, 300, "seesaw = \"30 mm\"");
  hill(1950, 300, "heights = [\"3 mm\", \"3 mm\"]");
  hill(2150, 20, "heights = [\"8 mm\", \"8 mm\"]");
  hill(2350, 20, "heights = [\"8 mm\", \"8 mm\"]");
  return text + "+++\n";
}

TEST(RescueLine, CountsTilesWithBumpsAndGapsEachTileOfARampAndSeesaws) {
  const std::map<std::string, double> both = {
      {"tile", 8 * 5.0}, {"speed bump", 20.0}, {"ramp", 20.0}, {"gap", 10.0}};
  for (const char* league : {"entry", "line"}) {
    Pushed run(hills(league));
    run.follow(0.0, 2.4);
    std::map<std::string, double> parts;
    for (const result::ScorePart& part : run.score().score_parts) parts[part.part] = part.value;
    std::map<std::string, double> expected = both;
    if (league == std::string("line")) expected.insert({{"start tile", 5.0}, {"seesaw", 20.0}});
    EXPECT_EQ(parts, expected) << league;
  }
}

TEST(RescueLine, WithoutAnEndTileEndsAtTheEvacuationZone) {
  std::string text = rescue();
  text.insert(text.find("checkpoints"), "end = \"zone\"\norigin = [\"0 mm\", \"300 mm\"]\n");
  Pushed run(text);
  run.follow(0.0, 1.1);
  run.push({1.2, 0.7});
  run.push({1.5, 0.7});
  EXPECT_FALSE(run.progress.reached());
  run.push({1.52, 0.45});
  EXPECT_TRUE(run.progress.reached());
  EXPECT_EQ(run.score().score, 70.0);
}

TEST(RescueLine, ALackOfProgressBringsItBackAndCostsPoints) {
  Pushed run(rescue());
  run.follow(0.0, 0.5);
  run.push({0.65, 0.75});  // leaves the checkpoint's tile
  EXPECT_EQ(run.lacks(), 1);
  const std::optional<Pose> hand = run.progress.contest().take_hand();
  ASSERT_TRUE(hand);
  EXPECT_NEAR(hand->position.x, 0.75, 0.01);
  EXPECT_FALSE(run.progress.contest().take_hand());
  run.put(hand->position);
  EXPECT_EQ(run.lacks(), 1);
  EXPECT_TRUE(run.progress.contest().give_up(run.events));  // as if the robot had left the line for good
  run.put(run.progress.contest().take_hand()->position);
  run.follow(0.6, 1.1);
  run.push({1.2, 0.7});
  run.push({1.5, 0.7});
  run.push({1.55, 0.45});
  EXPECT_EQ(run.score().score, 35.0 + 20.0 + 3 * 1.0);  // 5 points per tile, minus 2 per lack of progress
  run.wait(5100 * kMillisecond);
  EXPECT_EQ(run.score().score, 58.0 + 50.0);
}

TEST(RescueLine, AfterThreeLacksOfProgressItGoesOnAtTheNextCheckpoint) {
  Pushed run(rescue());
  for (int i = 0; i < 3; ++i) {
    EXPECT_TRUE(run.progress.contest().give_up(run.events));
    run.put(run.progress.contest().take_hand()->position);
    EXPECT_NEAR(run.body.pose().position.x, i < 2 ? 0.15 : 0.75, 0.01);
  }
  run.follow(0.6, 0.95);
  EXPECT_EQ(run.score().score, 0.0);
}

TEST(RescueLine, AndDragRacesNeedTheirTables) {
  std::string text = rescue();
  text.erase(text.find("[rescue]"), text.find("[[path]]") - text.find("[rescue]"));
  EXPECT_THROW(Pushed{text}, InputError);
  text = kStrip;
  text.replace(text.find("drag-race"), 9, "robotrace");
  EXPECT_THROW(Pushed{text}, InputError);  // the path is not closed
  text = kStrip;
  text.erase(text.find("[race]"), text.find("+++", 10) - text.find("[race]"));
  EXPECT_THROW(Pushed{text}, InputError);
}

}  // namespace robosim::judge::contest_test
