#include "sim/map/cells/survey.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "sim/map/cells/planners.h"
#include "sim/map/generator.h"
#include "tests/support/effort.h"

namespace robosim::cells {
namespace survey_test {

using ::testing::ElementsAre;

map::Map drawn(const std::string& rows) { return map::parse_map(rows, "drawn.map"); }

// A survey of a map. `from` is the start, as "X,Y,DIR"; an empty `from` stands for the map's default start.
struct Surveyed {
  map::Map map;
  map::Start start;
  CellFloor floor;
  CellRobot robot;
  Survey survey;

  explicit Surveyed(map::Map m, const std::string& from = "")
      : map(std::move(m)),
        start(from.empty() ? map::default_start(map) : map::parse_start(map, from)),
        floor(map),
        robot(floor, {start.cell, start.facing}),
        survey(robot) {
    robot.limit_moves(10'000'000);
  }
  std::string difference() const { return map::difference(map::true_graph(map, start), graph()); }
  const map::TrueGraph& graph() const { return scan_.graph; }
  const Scan& scan() { return scan_ = survey.scan(); }
  Scan scan_;
};

TEST(SurveyTest, TheMapsOfThePaperTakeThePapersTimes) {
  const std::vector<std::pair<const char*, double>> times{{"c", 94}, {"d", 141}, {"e", 129}, {"f", 247}};
  for (const auto& [name, time] : times) {
    Surveyed s(map::read_map(map::find_map(name)));
    EXPECT_EQ(s.scan().time, time) << name;
    EXPECT_EQ(s.difference(), "") << name;
  }
}

// Counts how often each border between cells is crossed, in each direction.
class EdgeCounter final : public MoveWatcher {
 public:
  explicit EdgeCounter(const CellRobot& robot) : robot_(robot) {}
  void moved(const CellPose& pose, Sense, Move, double) override {
    step_to(pose);
    before_ = pose;
  }
  void step_to(const CellPose& pose) {
    if (before_ && !(before_->cell == pose.cell)) {
      const auto edge =
          std::make_pair(robot_.floor().index_of(before_->cell), robot_.floor().index_of(pose.cell));
      most_ = std::max(most_, ++times_[edge]);
    }
  }
  int most() const { return most_; }

 private:
  const CellRobot& robot_;
  std::optional<CellPose> before_;
  std::map<std::pair<std::size_t, std::size_t>, int> times_;
  int most_ = 0;
};

// Returns the map's default start for every third `n`; otherwise any line cell with any heading.
map::Start somewhere(const map::Map& map, std::uint64_t n) {
  if (n % 3 == 0) return map::default_start(map);
  std::vector<map::CellAt> line;
  for (std::size_t i = 0; i < map.cells.size(); ++i)
    if (map::is_line(map.cells[i])) line.push_back(map.cell_at(i));
  return {line[n * 7919 % line.size()], static_cast<map::Direction>(n / 3 % 4)};
}

// Tests 1,000 maps of all families, with cycles, four-way crossings and up to 200 junctions.
class Generated : public ::testing::TestWithParam<map::Family> {};

TEST_P(Generated, FloorsAreFoundAsTheyAreAndEdgesUsedTwiceEachWayAtMost) {
  std::size_t most_junctions = 0;
  for (std::uint64_t n = 0; n < test::rounds(334u); ++n) {
    const int most = GetParam() == map::Family::tree ? 201 : GetParam() == map::Family::cycles ? 140 : 80;
    const int stations = 2 + static_cast<int>(n * n) % most;
    map::Map map = map::generate(GetParam(), stations, n);
    const map::Start start = somewhere(map, n);
    const map::TrueGraph truth = map::true_graph(map, start);
    ASSERT_LE(truth.junctions.size(), 200u);
    most_junctions = std::max(most_junctions, truth.junctions.size());
    const CellFloor floor(map);
    CellRobot robot(floor, {start.cell, start.facing});
    robot.limit_moves(1'000'000);
    EdgeCounter edges(robot);
    robot.watch(&edges);
    Survey survey(robot);
    const Scan& scan = survey.scan();
    robot.watch(nullptr);
    const std::string where = map.name + " from " + std::to_string(start.cell.x) + "," +
                              std::to_string(start.cell.y) + "," + letter(start.facing);
    ASSERT_EQ(scan.ending, Ending::complete) << where;
    ASSERT_EQ(map::difference(truth, scan.graph), "") << where;
    ASSERT_LE(edges.most(), 2) << where;
    ASSERT_EQ(survey.here(), 1) << where;
    for (int to = 2; to <= survey.stations(); ++to) {
      if (to % 2 == 0) survey.place_at(1);
      const Route route = survey.drive(to, survey.default_planner());
      ASSERT_EQ(route.ending, Ending::complete) << where << " to " << to;
      ASSERT_EQ(route.ratio_to_shortest, 1.0) << where << " from " << route.from << " to " << to;
      ASSERT_EQ(route.turns.size(), route.junctions.size());
    }
  }
  EXPECT_GE(most_junctions, 120u) << "some maps must be large";
}

INSTANTIATE_TEST_SUITE_P(Families, Generated,
                         ::testing::Values(map::Family::tree, map::Family::cycles, map::Family::grid),
                         [](const auto& family) { return map::name_of(family.param); });

TEST(SurveyTest, AllPlannersOfTreesGiveTheOneWayThereIs) {
  Surveyed s(map::generate(map::Family::tree, 40, 3));
  s.scan();
  for (const std::string& planner : planner_names()) {
    for (int to = 2; to <= s.survey.stations(); ++to) {
      s.survey.place_at(1);
      const Route route = s.survey.drive(to, planner);
      EXPECT_EQ(route.ending, Ending::complete) << planner;
      EXPECT_EQ(route.ratio_to_shortest, 1.0) << planner;
    }
  }
}

TEST(SurveyTest, APlannerOfTreesRefusesANetworkWithCycles) {
  Surveyed s(map::read_map(map::find_map("warehouse")));
  s.scan();
  for (const char* planner : {"climb", "interval", "pruned"}) {
    const Route route = s.survey.drive(2, planner);
    EXPECT_EQ(route.ending, Ending::refused) << planner;
    EXPECT_THAT(route.why, ::testing::HasSubstr("only trees")) << planner;
    EXPECT_EQ(s.survey.here(), 1) << "the robot has not moved";
  }
}

TEST(SurveyTest, AWallOnTheLineBlocksItAndItsFarSideIsReachedAnotherWay) {
  Surveyed s(
      drawn("0000000000\n"
            "0011111100\n"
            "0010000100\n"
            "1111211110\n"
            "0000000000\n"));
  EXPECT_EQ(s.scan().ending, Ending::complete);
  EXPECT_EQ(s.difference(), "");
  ASSERT_EQ(s.graph().junctions.size(), 2u);
  EXPECT_EQ(s.graph().stations.size(), 2u) << "there is no station at the wall";
  int blocked = 0;
  for (const map::GraphJunction& junction : s.graph().junctions)
    for (const map::Arm& arm : junction.arms)
      if (arm.behind == map::Arm::Behind::blocked) {
        ++blocked;
        EXPECT_EQ(arm.obstacle, (map::CellAt{4, 3}));
      }
  EXPECT_EQ(blocked, 2) << "the obstacle is found from both sides";
  EXPECT_EQ(s.survey.drive(2, "dijkstra").ending, Ending::complete);
}

TEST(SurveyTest, WhatLiesBehindAnObstacleIsReportedUnreachable) {
  Surveyed s(drawn("0000000\n1111x11\n0000000\n"));
  EXPECT_EQ(s.scan().ending, Ending::complete);
  EXPECT_THAT(s.graph().unreachable, ElementsAre(map::CellAt{6, 1}));
  EXPECT_EQ(s.difference(), "");
}

TEST(SurveyTest, AnObstacleRightBesideAJunctionCostsNoMove) {
  Surveyed s(
      drawn("0000000\n"
            "0001000\n"
            "1111x11\n"
            "0001000\n"
            "0000000\n"));
  EXPECT_EQ(s.scan().ending, Ending::complete);
  EXPECT_EQ(s.difference(), "");
  ASSERT_EQ(s.graph().junctions.size(), 1u);
  EXPECT_EQ(s.graph().junctions[0].arms.size(), 4u);
}

// Tests the maps on which Robosim v1 crashed or never ended.
TEST(WhereTheOriginalFailed, ALineWithoutJunctionsHasTwoStations) {
  for (const char* start :
       {"0,1,E", "0,1,W", "0,1,N", "2,1,E", "2,1,W", "2,1,N", "2,1,S", "4,1,W", "4,1,E"}) {
    Surveyed s(drawn("00000\n11111\n00000\n"), start);
    EXPECT_EQ(s.scan().ending, Ending::complete) << start;
    EXPECT_EQ(s.difference(), "") << start;
    EXPECT_EQ(s.survey.stations(), 2) << start;
    EXPECT_EQ(s.survey.here(), 1) << start;
    EXPECT_EQ(s.survey.drive(2, "climb").time, 5.0) << start << ": four cells and the turn";
  }
}

TEST(WhereTheOriginalFailed, ASingleCellIsOneStation) {
  Surveyed s(drawn("000\n010\n000\n"));
  EXPECT_EQ(s.scan().ending, Ending::complete);
  EXPECT_EQ(s.survey.stations(), 1);
  EXPECT_EQ(s.difference(), "");
}

TEST(WhereTheOriginalFailed, AStartThatFacesAwayTurnsRoundFirst) {
  const map::Map map = map::read_map(map::find_map("c"));
  const map::Start start = map::default_start(map);
  Surveyed away(map, std::to_string(start.cell.x) + "," + std::to_string(start.cell.y) + "," +
                         letter(reversed(start.facing)));
  EXPECT_EQ(away.scan().time, 94 + 1);
}

TEST(WhereTheOriginalFailed, ALineMayEndAtTheMapsEdge) {
  Surveyed s(drawn("00100\n00100\n11111\n"));
  EXPECT_EQ(s.scan().ending, Ending::complete);
  EXPECT_EQ(s.survey.stations(), 3);
  EXPECT_EQ(s.scan_.time, 2 * (7 - 1) + 3) << "the time is the same as with floor after the line's end";
}

TEST(WhereTheOriginalFailed, ARingHasNoStationsAndEnds) {
  for (const char* start : {"1,1,E", "1,1,W", "2,1,E", "2,1,N", "1,2,S"}) {
    Surveyed s(drawn("00000\n01110\n01010\n01110\n00000\n"), start);
    EXPECT_EQ(s.scan().ending, Ending::complete) << start;
    EXPECT_EQ(s.survey.stations(), 0) << start;
    EXPECT_EQ(s.difference(), "") << start;
  }
}

TEST(WhereTheOriginalFailed, AStartOnAJunctionIsAsGoodAsAnyOther) {
  for (const char* direction : {"N", "E", "S", "W"}) {
    Surveyed s(map::read_map(map::find_map("b")), std::string("9,10,") + direction);
    EXPECT_EQ(s.scan().ending, Ending::complete) << direction;
    EXPECT_EQ(s.difference(), "") << direction;
    EXPECT_EQ(s.survey.here(), 1) << direction;
  }
}

TEST(WhereTheOriginalFailed, JunctionsMayBeNestedDeeperThanAHundred) {
  // On a line with a dead end at every other cell, the scan meets 300 junctions in a row.
  std::string tooth, spine;
  for (int i = 0; i < 300; ++i) {
    tooth += "01";
    spine += "11";
  }
  Surveyed s(drawn(tooth + "0\n" + spine + "1\n"), "0,1,E");
  EXPECT_EQ(s.scan().ending, Ending::complete);
  EXPECT_EQ(s.difference(), "");
  EXPECT_EQ(s.graph().junctions.size(), 300u);
}

TEST(SurveyTest, WithNoiseItAlwaysEnds) {
  int lost = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    Surveyed s(map::read_map(map::find_map("d")));
    s.robot.limit_moves(5000);
    s.robot.set_noise({0.01, 0.005, seed});
    lost += s.scan().ending != Ending::complete || !s.difference().empty();
  }
  EXPECT_GT(lost, 20) << "a fault in one per cent of the sensings spoils many scans";
  EXPECT_LT(lost, 200);
}

}  // namespace survey_test
}  // namespace robosim::cells
