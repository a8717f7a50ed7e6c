#include "sim/map/course/import.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <numbers>
#include <string>

#include "sim/map/course/rescue_tiles.h"
#include "sim/map/map_writer.h"
#include "sim/map/network.h"
#include "sim/map/path_survey.h"

namespace robosim::course {
namespace import_test {

using ::testing::HasSubstr;

constexpr double kPi = std::numbers::pi;
// The tolerance in metres. The rounding errors of written values add up to a few micrometres over a course.
constexpr double kRounding = 1e-5;

map::Map import(const std::string& text) { return import_course(text, "course.txt", "course").map; }

map::PathSurvey survey(const map::Map& map) { return map::survey_path(map.course.paths.at(0), map.line_m); }

std::string message_of(const std::string& text, double walls_m = 0.0) {
  try {
    import_course(text, "course.txt", "course", walls_m);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

std::string robotrace(const std::string& circles, const std::string& more = "") {
  return R"({"board":{"width_cm":360,"height_cm":180},"line_width_cm":1.9,)" + more + R"("circles":[)" +
         circles + "]}";
}

TEST(ImportRobotrace, TwoCirclesOfOneSenseAreAnOval) {
  const map::Map map = import(robotrace(R"({"x":100,"y":60,"r":40},{"x":300,"y":60,"r":40,"turn":"ccw"})"));
  const map::PathSurvey found = survey(map);
  EXPECT_NEAR(found.length_m, 4.0 + 0.8 * kPi, kRounding);
  EXPECT_TRUE(found.is_closed);
  EXPECT_EQ(found.crossings, 0);
  EXPECT_NEAR(found.smallest_radius_m, 0.4, kRounding);
  EXPECT_TRUE(map.light_line);
  EXPECT_NEAR(map.line_m, 0.019, 1e-12);
  // The marks are at four changes of curvature, the start and the goal.
  ASSERT_EQ(map.course.marks.size(), 6u);
  EXPECT_NEAR(map.course.marks[5].along, found.length_m - 1.0, kRounding);
  EXPECT_LT(map.course.marks[5].away, 0.0);
  EXPECT_GT(map.course.marks[0].away, 0.0);
  EXPECT_EQ(map.goal, "robotrace");
  ASSERT_TRUE(map.course.race);
  EXPECT_NEAR(map.course.race->goal, found.length_m - 1.0, kRounding);
  ASSERT_TRUE(map.start && map.start->on_path);
  EXPECT_NEAR(map.start->on_path->along, found.length_m - 0.5, kRounding);
  // The margin between the line and each edge of the map is 20 cm.
  EXPECT_NEAR(map.width * map.cell_m, 2.8 + 0.4, 0.1001);
  EXPECT_NEAR(map.height * map.cell_m, 0.8 + 0.4, 0.1001);
}

TEST(ImportRobotrace, TwoCirclesOfOppositeSensesAreAnEight) {
  const map::Map map = import(robotrace(R"({"x":-100,"y":0,"r":40},{"x":100,"y":0,"r":40,"turn":"cw"})"));
  const map::PathSurvey found = survey(map);
  const double straight = std::sqrt(2.0 * 2.0 - 0.8 * 0.8);
  EXPECT_NEAR(found.length_m, 2 * straight + 2 * 0.4 * (kPi + 2 * std::asin(0.8 / 2.0)), kRounding);
  EXPECT_EQ(found.crossings, 1);
  EXPECT_TRUE(found.is_closed);
}

TEST(ImportRobotrace, AStraightThatIsTooShortForStartAndGoalHasNone) {
  const auto imported =
      import_course(robotrace(R"({"x":100,"y":60,"r":40},{"x":190,"y":60,"r":40})"), "c.json", "c");
  EXPECT_EQ(imported.remarks.size(), 1u);
  EXPECT_EQ(imported.map.course.marks.size(), 4u);
  EXPECT_NEAR(survey(imported.map).length_m, 1.8 + 0.8 * kPi, kRounding);
}

TEST(ImportRobotrace, IsReadBackFromTheMapThatIsWritten) {
  const map::Map map = import(robotrace(R"({"x":-100,"y":3.3,"r":40},{"x":100,"y":0,"r":33.3,"turn":"cw"})"));
  const map::Map again = map::parse_map(map::write_map(map), "again.map");
  EXPECT_NEAR(survey(again).length_m, survey(map).length_m, kRounding);
  EXPECT_TRUE(survey(again).is_closed);
  EXPECT_EQ(again.course.marks.size(), map.course.marks.size());
  EXPECT_TRUE(map::trace_network(again, *again.start).has_laps());
}

TEST(ImportCurvature, SegmentsAreStraightsAndArcsAndTheWayFromGoalToStartIsAdded) {
  const std::string half = fmt::format("{}, 2.0\n", kPi / 2);
  const map::Map map = import("#length[m], curvature[rad/m]\n1.0, 0\n" + half + "2.0, 0.0\n" + half);
  const map::PathSurvey found = survey(map);
  EXPECT_TRUE(found.is_closed);
  EXPECT_NEAR(found.length_m, 4.0 + kPi, kRounding);
  EXPECT_NEAR(found.smallest_radius_m, 0.5, 1e-12);
  // A file without a heading line is valid, too.
  EXPECT_NEAR(survey(import("1.0, 0\n0.5, -1.0\n")).length_m, 1.5, kRounding);
}

TEST(ImportPoints, AreStraightsWithCornersBetweenThem) {
  const map::PathSurvey found = survey(import("0 0\n0.5 0\n0.5 0.5\n0 0.5\n0 0.01\n"));
  EXPECT_NEAR(found.length_m, 1.99, 1e-12);
  EXPECT_EQ(found.corners, 3);
}

TEST(ImportPoints, ACircleOfManyPointsStaysWithinAThirdOfAMillimetre) {
  std::string text;
  for (int i = 0; i <= 2000; ++i)
    text += fmt::format("{} {}\n", 0.4 * std::cos(i * kPi / 1000), 0.4 * std::sin(i * kPi / 1000));
  const map::Map map = import(text);
  const map::PathSurvey found = survey(map);
  EXPECT_TRUE(found.is_closed);
  EXPECT_NEAR(found.length_m, 0.8 * kPi, 0.002);
  EXPECT_LT(found.corners, 150);
  EXPECT_LT(map::write_map(map).size(), 20'000u);
}

// A maze of 3 x 3 cells: a passage leads around two enclosed cells, one of which is the goal.
constexpr const char* kMaze =
    "o---o---o---o\n"
    "|           |\n"
    "o   o---o   o\n"
    "|   | G |   |\n"
    "o   o   o   o\n"
    "| S |   |   |\n"
    "o---o---o---o\n";

TEST(ImportMaze, PassagesBecomeLines) {
  const map::Map map = import(kMaze);
  ASSERT_TRUE(map.start);
  const map::Network network = map::trace_network(map, *map.start);
  // The stations are the passage's two ends. The goal and the cell below the goal are unreachable from the
  // passage.
  EXPECT_EQ(network.stations.size(), 2u);
  EXPECT_EQ(network.unreachable.size(), 2u);
  const map::Map crlf = import([] {
    std::string text;
    for (const char* c = kMaze; *c; ++c) text += *c == '\n' ? "\r\n" : std::string(1, *c);
    return text;
  }());
  EXPECT_EQ(crlf.cells, map.cells);
}

TEST(ImportMaze, NumbersSayTheSameAsCharacters) {
  std::string numbers;
  // The columns are x, y and the walls N, E, S, W.
  for (const char* row : {"0 0 0 1 1 1", "1 0 0 1 1 1", "2 0 0 1 1 1", "0 1 0 1 0 1", "1 1 1 1 0 1",
                          "2 1 0 1 0 1", "0 2 1 0 0 1", "1 2 1 0 1 0", "2 2 1 1 0 0"})
    numbers += std::string(row) + "\n";
  EXPECT_EQ(import(numbers).cells, import(kMaze).cells);
}

TEST(Import, WhatIsNoCourseIsRefusedWithAReason) {
  const std::string ok = R"({"x":100,"y":60,"r":40})";
  struct Refused {
    std::string text;
    const char* message;
  };
  const Refused refused[] = {
      {"", "the file is empty"},
      {"\n \n", "the file is empty"},
      {std::string("1 2\0 3", 6), "not a text file"},
      {"{", "not valid JSON from here on"},
      {"[]", "expected JSON of robotrace_course_cad (a list “circles”) or of rcj-rescue-cms (“tiles”)"},
      {"{}", "expected JSON of robotrace_course_cad (a list “circles”) or of rcj-rescue-cms (“tiles”)"},
      {R"({"tiles":[]})", "width: expected a whole number of tiles"},
      {robotrace(""), "circles: expected 2 to 1000 circles, got 0"},
      {robotrace(ok), "circles: expected 2 to 1000 circles, got 1"},
      {robotrace(ok + ",5"), "circle 2: expected x, y and r"},
      {robotrace(ok + R"(,{"x":300,"y":60})"), "circle 2: expected x, y and r"},
      {robotrace(ok + R"(,{"x":300,"y":60,"r":0})"), "circle 2: r: expected a radius above 0"},
      {robotrace(ok + R"(,{"x":300,"y":60,"r":"40"})"), "r: expected a number of centimetres"},
      {robotrace(ok + R"(,{"x":1e300,"y":60,"r":40})"), "x: expected a number of centimetres"},
      {robotrace(ok + R"(,{"x":300,"y":60,"r":40,"turn":"left"})"), "turn: expected “cw” or “ccw”"},
      {robotrace(ok + R"(,{"x":100,"y":60,"r":20})"), "circles 1 and 2 have no tangent"},
      {robotrace(ok + R"(,{"x":110,"y":60,"r":20})"), "circles 1 and 2 have no tangent"},
      {robotrace(ok + R"(,{"x":300,"y":60,"r":40})", R"("line_width_cm":50,)"), "line_width_cm"},
      {"1.0, x\n", "unknown kind of course"},
      {"#length[m], curvature[rad/m]\n1.0, x\n",
       "course.txt:2: expected a number from -10000 to 10000, got “x”"},
      {"1.0, 2.0\n1.0\n", "course.txt:2: the segment: expected its length in m and its curvature"},
      {"-1.0, 2.0\n", "the segment: expected its length"},
      {"1.0, 1e3\n", "the segment turns too far: expected at most 100 rad, got 1000 rad"},
      {"1 2 3\n", "course.txt:1: unknown kind of line: expected two numbers"},
      {"0 0\n1 nan\n", "course.txt:2: expected a number from -10000 to 10000, got “nan”"},
      {"0 0\n1 1 1\n", "course.txt:2: the point: expected two numbers"},
      {"0 0\n0 0\n", "the course has too few points: expected at least 2, got 1"},
      {"0 0\n0.01 0\n", "the course is too short: expected at least 100 mm"},
      {"0 0\n4000 0\n4000 3000\n",
       "the course is too large: expected at most 40000 square metres, got 4000 x 3000 m"},
      {"9999 0\n-9999 0\n", "the course is too long: expected at most 10 km"},
      {"hello\nworld\n", "unknown kind of course"},
      {"xello world\nabcdefghijk\nx\nx\nx\n", "a maze that begins with o or +, got “x”"},
      {"o---o---o\n|   |   |\no---o---o\n|   |   |\no---o---o\n", "the maze has no passage"},
      {"0 0 1 1 1 2\n", "the maze's cell: expected x y N E S W"},
      {"0 0 1 1 1 1\n1 1 1 1 1 1\n", "a maze of 2 x 2 cells: expected 4 cells, got 2"},
  };
  for (const Refused& one : refused) {
    EXPECT_THAT(message_of(one.text), HasSubstr(one.message)) << one.text;
    EXPECT_THAT(message_of(one.text), HasSubstr("course.txt")) << one.text;
  }
}

// The posts of this maze are "+". A wrong import would mistake the first line for a row of numbers.
constexpr const char* kPlusMaze =
    "+---+---+---+\n"
    "|       |   |\n"
    "+   +   +   +\n"
    "|   |     G |\n"
    "+   +---+---+\n"
    "| S |       |\n"
    "+---+---+---+\n";

TEST(Maze, MayHavePlusesForPosts) {
  const map::Map map = import(kPlusMaze);
  EXPECT_EQ(map.width, 9);
  EXPECT_EQ(map.at({2, 6}), map::Cell::line);
  EXPECT_EQ(map.goal, "station:goal");
}

TEST(Maze, WithItsWallsHasThemAsThickAsASixteenthOfACellAndItsLinesAreNotPainted) {
  const map::Map map = import_course(kPlusMaze, "m.txt", "m", 0.180).map;
  EXPECT_DOUBLE_EQ(map.cell_m, 0.180 / 16);
  ASSERT_EQ(map.width, 3 * 16 + 1);
  ASSERT_EQ(map.height, 3 * 16 + 1);
  EXPECT_EQ(map.goal, "station:goal");
  const auto middle = [](int x, int y) { return map::CellAt{16 * x + 8, 48 - 8 - 16 * y}; };
  EXPECT_EQ(map.start->cell, middle(0, 0));
  EXPECT_EQ(*map.goal_cell, middle(2, 1));
  for (int i = 0; i < 49; ++i)
    for (const map::CellAt edge :
         {map::CellAt{i, 0}, map::CellAt{i, 48}, map::CellAt{0, i}, map::CellAt{48, i}})
      EXPECT_EQ(map.at(edge), map::Cell::wall) << i;
  // Checks the gap to the north of the start cell, and the wall to the right of the start cell.
  EXPECT_EQ(map.at({8, 24}), map::Cell::gap);
  EXPECT_EQ(map.at({16, 40}), map::Cell::wall);
  EXPECT_EQ(map.at({16, 8}), map::Cell::gap) << "between the two upper left cells";
  int walls = 0, lines = 0;
  for (const map::Cell cell : map.cells) {
    walls += cell == map::Cell::wall;
    lines += cell == map::Cell::line;
  }
  EXPECT_EQ(lines, 0) << "nothing is painted";
  // Counts the walls around the maze, and five walls between cells: two up from the lower edge, two to the
  // right in the middle, and one down from the upper edge.
  EXPECT_EQ(walls, 4 * 48 + 31 + 32 + 16);
  EXPECT_NO_THROW(map::parse_map(map::write_map(map), "again.map"));
  EXPECT_THAT(message_of("0 0\n1 0\n", 0.18), HasSubstr("walls require a maze"));
}

TEST(Import, DepthAndLengthAreNoHarm) {
  EXPECT_THAT(message_of(std::string(64, '[')), HasSubstr("not valid JSON from here on"));
  EXPECT_THAT(message_of(std::string(64, '[') + std::string(64, ']')), HasSubstr("circles"));
  EXPECT_THAT(message_of(std::string(1'000'000, '[')), HasSubstr("at most 64 nested brackets"));
  EXPECT_THAT(message_of(std::string(100'000, 'o')), HasSubstr("the maze is too large"));
}

// --- courses of rcj-rescue-cms, the course editor of RoboCupJunior ---

std::string rescue_tile(int x, int y, int rot, const std::string& id, const std::string& more = "") {
  return fmt::format(R"({{"x":{},"y":{},"z":0,"rot":{},"tileType":"{}"{}}})", x, y, rot, id, more);
}

std::string rescue(const std::string& tiles, const std::string& more = "", int width = 3, int length = 2) {
  return fmt::format(
      R"({{"name":"own","width":{},"length":{},"height":1,"startTile":{{"x":0,"y":0,"z":0}},{}"tiles":[{}]}})",
      width, length, more, tiles);
}

const std::string kStraight = "570c27c3f5a9dabe23f3af90", kArc = "570c27c3f5a9dabe23f3af9c",
                  kOneGap = "58cfe0d457501b50da7afa62", kPlus = "570c27c3f5a9dabe23f3afae",
                  kExit = "58cfd6549792e9313b1610e0", kZone = "58cfd6549792e9313b1610e1";

TEST(ImportRescue, AStraightAGapAndTheExitAreOneWay) {
  const map::Map map = import(rescue(rescue_tile(0, 0, 0, kStraight) + "," + rescue_tile(1, 0, 0, kOneGap) +
                                         "," + rescue_tile(2, 0, 90, kExit),
                                     "", 3, 1));
  ASSERT_EQ(map.course.paths.size(), 1u);
  const map::Path& path = map.course.paths[0];
  EXPECT_NEAR(path.length(), 0.3 + 0.3 + 0.15, kRounding);  // the line ends at the bar in the exit tile
  double gap = 0.0;
  for (const map::PathPiece& piece : path.pieces()) gap += piece.is_gap ? piece.length : 0.0;
  EXPECT_NEAR(gap, 0.05, kRounding);
  ASSERT_EQ(map.course.areas.size(), 1u);
  EXPECT_EQ(map.course.areas[0].colour.hue, map::Hue::red);
  EXPECT_FALSE(map.light_line);
  EXPECT_NEAR(map.start->on_path->along, 0.15, 1e-9);
}

TEST(ImportRescue, ItsGoalIsTheCompetitionsWithTheCheckpointsAlongTheWay) {
  const std::string marked = R"(,"checkPoint":true)";
  const map::Map map =
      import(rescue(rescue_tile(0, 0, 0, kStraight, marked) + "," + rescue_tile(1, 0, 0, kArc) + "," +
                        rescue_tile(1, 1, 90, kStraight, marked) + "," + rescue_tile(1, 2, 180, kExit),
                    "", 3, 3));
  EXPECT_EQ(map.goal, "rescue-line");
  ASSERT_TRUE(map.course.rescue);
  EXPECT_NEAR(map.course.rescue->tile, 0.3, 1e-12);
  ASSERT_EQ(map.course.rescue->checkpoints.size(), 1u);
  EXPECT_NEAR(map.course.rescue->checkpoints[0], 0.3 + kPi / 2.0 * 0.15 + 0.15, 0.01);
  EXPECT_FALSE(map.course.rescue->to_zone);
}

// The first arc has a radius of 150 mm and leads down. The second arc is turned by 90 degrees and leads back
// to the left.
TEST(ImportRescue, TilesAreTurnedClockwise) {
  const map::Map map =
      import(rescue(rescue_tile(0, 0, 0, kStraight) + "," + rescue_tile(1, 0, 0, kArc) + "," +
                    rescue_tile(1, 1, 90, kArc) + "," + rescue_tile(0, 1, 180, kStraight)));
  const map::Path& path = map.course.paths.at(0);
  EXPECT_NEAR(path.length(), 0.3 + kPi * 0.15 + 0.3, kRounding);
  EXPECT_NEAR(path.end().position.x, 0.3, kRounding);
  EXPECT_NEAR(path.end().position.y, 0.3 + 0.15, kRounding);
}

// The robot enters the intersection from the left. The green square is beyond the intersection, so the route
// goes straight on.
TEST(ImportRescue, AtAnIntersectionTheWayTurnsAsTheGreensSayAndTheOtherArmsStay) {
  const std::string to_the_right = rescue_tile(0, 0, 0, kStraight) + "," + rescue_tile(1, 0, 0, kPlus) + "," +
                                   rescue_tile(2, 0, 0, kStraight);
  const map::Map map = import(rescue(to_the_right));
  ASSERT_EQ(map.course.paths.size(), 3u);  // paths 1 and 2 are the arms up and down
  EXPECT_NEAR(map.course.paths[0].length(), 0.9, kRounding);
  EXPECT_NEAR(map.course.paths[1].length(), 0.15, kRounding);
  ASSERT_EQ(map.course.areas.size(), 1u);
  const map::Area& green = map.course.areas[0];
  EXPECT_EQ(green.colour.hue, map::Hue::green);
  EXPECT_NEAR(green.middle.position.x, 0.3 + 0.45 + 0.0225, 1e-9);
  EXPECT_NEAR(green.middle.position.y, 0.3 + 0.45 + 0.0225, 1e-9);
  EXPECT_NEAR(2.0 * green.half_length, 0.025, 1e-12);
  // Turned by 180 degrees, the tile has its green square before the intersection, on the right. The route
  // leads down.
  const map::Map turned =
      import(rescue(rescue_tile(0, 0, 0, kStraight) + "," + rescue_tile(1, 0, 180, kPlus) + "," +
                    rescue_tile(1, 1, 90, kStraight)));
  EXPECT_NEAR(turned.course.paths[0].end().position.x, 0.75, kRounding);
  EXPECT_NEAR(turned.course.paths[0].end().position.y, 0.3, kRounding);
}

TEST(ImportRescue, TheWayGoesOnBehindTheEvacuationZone) {
  const Imported imported =
      import_course(rescue(rescue_tile(0, 0, 0, kStraight) + "," + rescue_tile(1, 0, 0, kZone) + "," +
                               rescue_tile(1, 1, 0, kZone) + "," + rescue_tile(2, 1, 0, kStraight),
                           R"("startTile2":{"x":2,"y":1,"z":0},"indexCount":2,)"),
                    "own.json", "own");
  ASSERT_EQ(imported.map.course.paths.size(), 2u);
  EXPECT_NEAR(imported.map.course.paths[1].begin().position.x, 0.3 + 0.6, kRounding);
  ASSERT_EQ(imported.map.course.areas.size(), 2u);
  EXPECT_EQ(imported.map.course.areas[0].colour.hue, map::Hue::silver);
  ASSERT_EQ(imported.remarks.size(), 2u);
  EXPECT_THAT(imported.remarks[0], HasSubstr("so the map has no goal"));  // a goal requires a second tile
  EXPECT_THAT(imported.remarks[1], HasSubstr("2 tiles of the evacuation zone"));
}

TEST(ImportRescue, WhatAMapCannotHoldIsSaid) {
  const Imported imported = import_course(
      rescue(
          rescue_tile(0, 0, 0, kStraight, R"(,"checkPoint":true)") + "," +
              rescue_tile(1, 0, 0, kStraight, R"(,"items":{"obstacles":1,"speedbumps":2,"rampPoints":true})"),
          R"("indexCount":5,)"),
      "own.json", "own");
  std::string all;
  for (const std::string& remark : imported.remarks) all += remark + "\n";
  for (const char* what : {"1 tile with obstacles", "2 speed bumps", "1 tile with ramps",
                           "the path leads over 2 tiles, but the file states 5"})
    EXPECT_THAT(all, HasSubstr(what));
  EXPECT_EQ(imported.map.at({3 + 3 + 1, 3 + 1}), map::Cell::wall);
}

// Puts each kind of tile between four straight tiles, and starts on each of these straight tiles once.
TEST(ImportRescue, EveryTileLeadsFromOneSideToAnotherHoweverItIsTurned) {
  for (const TileKind& kind : rescue_tiles()) {
    for (const int rot : {0, 90, 180, 270}) {
      double longest = 0.0;
      for (const auto& [x, y] : {std::pair{0, 1}, {2, 1}, {1, 0}, {1, 2}}) {
        const std::string text = fmt::format(
            R"({{"width":3,"length":3,"startTile":{{"x":{},"y":{},"z":0}},"tiles":[{},{},{},{},{}]}})", x, y,
            rescue_tile(1, 1, rot, std::string(kind.id)), rescue_tile(0, 1, 0, kStraight),
            rescue_tile(2, 1, 180, kStraight), rescue_tile(1, 0, 90, kStraight),
            rescue_tile(1, 2, 270, kStraight));
        const map::Map map = import(text);
        const map::Path& path = map.course.paths.at(0);
        longest = std::max(longest, path.length());
        EXPECT_LT(path.length(), 3.0) << kind.id;
        EXPECT_NEAR(map::parse_map(map::write_map(map), "again").course.paths.at(0).length(), path.length(),
                    1e-6);
      }
      EXPECT_GT(longest, kind.id == kRescueExit ? 0.4 : 0.7) << kind.id << " turned by " << rot;
    }
  }
}

TEST(ImportRescue, BadFilesAreToldInASentence) {
  const std::string fine = rescue_tile(0, 0, 0, kStraight) + "," + rescue_tile(1, 0, 0, kStraight);
  const auto with = [&](const std::string& tile) { return rescue(fine + "," + tile); };
  struct Case {
    std::string text, message;
  };
  for (const Case& c :
       {Case{"{\"tiles\":\n[}", "course.txt:2: not valid JSON from here on"},
        Case{R"({"tiles":[]})", "width: expected a whole number of tiles"},
        Case{rescue(fine, "", 1000), "width: expected 1 to 100 tiles, got 1000"},
        Case{rescue(fine, "", 3, 0), "length: expected 1 to 100 tiles, got 0"},
        Case{rescue(""), "tiles: expected at least one tile"},
        Case{R"({"width":1,"length":1,"tiles":3})", "tiles: expected a list or an object"},
        Case{rescue("7"), "tile 1: expected whole numbers x, y and z"},
        Case{with(R"({"x":"2","y":0,"z":0})"), "tile 3: expected whole numbers x, y and z"},
        Case{with(R"({"x":99999999999,"y":0,"z":0})"), "tile 3: expected whole numbers"},
        Case{with(rescue_tile(5, 0, 0, kStraight)),
             "tile 5,0: expected a tile inside the field of 3 x 2 tiles"},
        Case{with(rescue_tile(1, 0, 0, kStraight)), "tile 1,0 is given twice"},
        Case{with(rescue_tile(2, 0, 45, kStraight)), "tile 2,0: rot: expected 0, 90, 180 or 270, got 45"},
        Case{with(R"({"x":2,"y":0,"z":0})"), "tile 2,0: tileType is missing"},
        Case{with(rescue_tile(2, 0, 0, "nobody")), "tile 2,0: unknown type of tile"},
        Case{with(R"({"x":2,"y":0,"z":0,"tileType":{"_id":"new","paths":{"left":"up"}}})"),
             "tile 2,0: invalid value of the key left: expected left, top, right or bottom"},
        Case{with(rescue_tile(2, 0, 0, kStraight, R"(,"levelUp":"north")")),
             "tile 2,0: invalid value of the key levelUp: expected left, top, right or bottom"},
        Case{rescue(rescue_tile(1, 0, 0, kStraight)), "startTile: expected one of the tiles"},
        Case{rescue(rescue_tile(0, 0, 0, kStraight)),
             "startTile: expected a tile that is joined to another tile, got 0,0"},
        Case{rescue(fine, R"("startTile2":7,)"), "startTile2: expected whole numbers"},
        Case{R"({"neither":1})",
             "expected JSON of robotrace_course_cad (a list “circles”) or of rcj-rescue-cms (“tiles”)"}}) {
    EXPECT_THAT(message_of(c.text), HasSubstr(c.message));
    EXPECT_THAT(message_of(c.text), ::testing::StartsWith("course.txt"));
  }
}

}  // namespace import_test
}  // namespace robosim::course
