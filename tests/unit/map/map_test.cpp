#include "sim/map/map.h"

#include <gmock/gmock.h>

#include <ostream>
#include <string>

#include "sim/base/file.h"
#include "tests/support/readable.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_folder.h"

namespace robosim::map::map_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

// Returns parse_map()'s error message, or "accepted".
std::string complaint(std::string_view text) {
  return test::refusal([&] { parse_map(text, "m.map"); });
}

// Robosim v1 wrote a map's cells as digits. Its display drew floor, line and wall as space, '.' and '#'.
constexpr const char* kClassic =
    "22222\n"
    "20002\n"
    "20112\n"
    "22222\n";
constexpr const char* kDisplayed =
    "#####\n"
    "#   #\n"
    "# ..#\n"
    "#####\n";

TEST(ReadMap, ClassicAndDisplayedFormAreTheSameMap) {
  const Map classic = parse_map(kClassic, "m.map");
  EXPECT_EQ(classic.width, 5);
  EXPECT_EQ(classic.height, 4);
  EXPECT_EQ(classic.at({2, 2}), Cell::line);
  EXPECT_EQ(classic.at({1, 2}), Cell::floor);
  EXPECT_EQ(classic.at({4, 2}), Cell::wall);
  EXPECT_EQ(parse_map(kDisplayed, "m.map").cells, classic.cells);
}

TEST(ReadMap, LineEndsAndAMissingLastNewlineMakeNoDifference) {
  const Map lf = parse_map("2222\n2112\n2222\n", "m.map");
  for (const char* text : {"2222\n2112\n2222", "2222\r\n2112\r\n2222\r\n", "2222\r\n2112\r\n2222",
                           "2222\r\n2112\n2222\r", "+++\r\n+++\r\n2222\r\n2112\r\n2222\r\n"})
    EXPECT_EQ(parse_map(text, "m.map").cells, lf.cells) << text;
}

TEST(ReadMap, OutsideTheMapIsWall) {
  const Map map = parse_map("11\n", "m.map");
  EXPECT_EQ(map.at({-1, 0}), Cell::wall);
  EXPECT_EQ(map.at({0, 1}), Cell::wall);
}

TEST(ReadMap, CentresAreMetresFromTheBottomLeftCorner) {
  const Map map = parse_map("+++\ncell = \"50 mm\"\n+++\n1_\n1_\n", "m.map");
  EXPECT_DOUBLE_EQ(map.centre({0, 1}).x, 0.025);
  EXPECT_DOUBLE_EQ(map.centre({0, 1}).y, 0.025);
  EXPECT_DOUBLE_EQ(map.centre({1, 0}).x, 0.075);
  EXPECT_DOUBLE_EQ(map.centre({1, 0}).y, 0.075);
}

TEST(ReadMap, FrontMatterSetsWhatItNames) {
  const Map map = parse_map(
      "+++\n"
      "name = \"demo\"\n"
      "cell = \"5 cm\"\n"
      "line = \"15 mm\"\n"
      "corner = \"0.1 m\"\n"
      "floor = \"raster\"\n"
      "goal = \"laps:3\"\n"
      "generator = \"maze 1 seed 7\"\n"
      "[start]\nx = 2\ny = 0\nfacing = \"W\"\n"
      "[stations]\ndock = [4, 0]\nfar-end = [0, 0]\n"
      "[legend]\n3 = \"gap\"\n4 = \"wall\"\n5 = \"floor\"\n6 = \"line\"\n9 = \"obstacle\"\n"
      "+++\n"
      "1111111\n"
      "_34569x\n",
      "some/m.map");
  EXPECT_EQ(map.name, "demo");
  EXPECT_DOUBLE_EQ(map.cell_m, 0.05);
  EXPECT_DOUBLE_EQ(map.line_m, 0.015);
  EXPECT_DOUBLE_EQ(map.corner_m, 0.1);
  EXPECT_TRUE(map.raster);
  EXPECT_EQ(map.goal, "laps:3");
  EXPECT_EQ(map.goal_place.line, 7);
  EXPECT_EQ(map.generator, "maze 1 seed 7");
  ASSERT_TRUE(map.start);
  EXPECT_EQ(map.start->cell, (CellAt{2, 0}));
  EXPECT_EQ(map.start->facing, Direction::west);
  ASSERT_EQ(map.stations.size(), 2u);
  EXPECT_EQ(map.stations[0].name, "dock");
  EXPECT_EQ(map.stations[0].cell, (CellAt{4, 0}));
  const std::vector<Cell> row(map.cells.begin() + 7, map.cells.end());
  EXPECT_THAT(row, ElementsAre(Cell::floor, Cell::gap, Cell::wall, Cell::floor, Cell::line, Cell::obstacle,
                               Cell::obstacle));
}

TEST(ReadMap, AMapWithoutANameIsCalledAsItsFile) {
  EXPECT_EQ(parse_map("11\n", "some/where.map").name, "where");
}

TEST(ReadMap, SAndGAreLineAndMarkStartAndGoal) {
  const Map map = parse_map("_S..G_\n", "m.map");
  EXPECT_EQ(map.at({1, 0}), Cell::line);
  EXPECT_EQ(map.at({4, 0}), Cell::line);
  ASSERT_TRUE(map.start);
  EXPECT_EQ(map.start->cell, (CellAt{1, 0}));
  EXPECT_EQ(map.start->facing, Direction::east);
  ASSERT_TRUE(map.goal_cell);
  EXPECT_EQ(*map.goal_cell, (CellAt{4, 0}));
  EXPECT_EQ(map.goal, "station:goal");
  ASSERT_EQ(map.stations.size(), 1u);
  EXPECT_EQ(map.stations[0].name, "goal");
}

TEST(ReadMap, AGoalOnANamedStationIsThatStation) {
  const Map map = parse_map("+++\n[stations]\ndock = [4, 0]\n[goal]\nx = 4\ny = 0\n+++\n_S..._\n", "m.map");
  EXPECT_EQ(map.goal, "station:dock");
  EXPECT_EQ(map.stations.size(), 1u);
}

TEST(ReadMap, AGoalWordStandsBesideAGoalCell) {
  EXPECT_EQ(parse_map("+++\ngoal = \"tour\"\n+++\n_S..G_\n", "m.map").goal, "tour");
}

TEST(ReadMap, AStartTableMayOnlyTurnTheS) {
  const Map map = parse_map("+++\n[start]\nfacing = \"W\"\n+++\n..S..\n", "m.map");
  EXPECT_EQ(map.start->cell, (CellAt{2, 0}));
  EXPECT_EQ(map.start->facing, Direction::west);
}

TEST(ReadMap, HashesTheTextAsItStands) {
  EXPECT_EQ(parse_map("11\n", "m.map").sha256, sha256("11\n"));
  EXPECT_EQ(sha256_of(parse_map("11", "m.map")), sha256("11"));
}

TEST(ReadMap, AFileLargerThanAChunkReadsAsItsTextDoes) {
  std::string text = "+++\nname = \"big\"\n+++\n";
  for (int y = 0; y < 700; ++y) {
    std::string row(997, y % 2 ? '_' : ' ');
    row[static_cast<std::size_t>(y * 31 % 997)] = y == 350 ? 'S' : '.';
    text += row + (y % 3 ? "\n" : "\r\n");
  }
  const test::TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "big.map";
  write_file(file, text);
  const Map map = read_map(file);
  EXPECT_EQ(map.cells, parse_map(text, "big.map").cells);
  EXPECT_EQ(map.start->cell, (CellAt{350 * 31 % 997, 350}));
  EXPECT_EQ(map.sha256, "");
  EXPECT_EQ(sha256_of(map), sha256(text));
}

TEST(ReadMap, FilesThatCannotBeReadAreNamed) {
  EXPECT_THROW(read_map("no/such.map"), InputError);
  EXPECT_THROW(read_map(test::TemporaryFolder().path()), InputError);
}

TEST(FindMap, KnowsTheSamplesAndListsThem) {
  EXPECT_EQ(read_map(find_map("oval")).name, "oval");
  EXPECT_EQ(find_map("./x.map"), "./x.map");
  EXPECT_EQ(find_map("x.map"), "x.map");
  EXPECT_THAT(test::refusal([] { find_map("ovall"); }),
              testing::AllOf(HasSubstr("oval"), HasSubstr("tight")));
}

struct Refused {
  const char* what;
  std::string_view text;
  const char* place;
  const char* says;
};

void PrintTo(const Refused& refused, std::ostream* out) { *out << refused.what; }

std::string name_of(const testing::TestParamInfo<Refused>& test) { return test::readable(test.param.what); }

class RefusedMap : public testing::TestWithParam<Refused> {};

TEST_P(RefusedMap, SaysWhereAndWhat) {
  const std::string said = complaint(GetParam().text);
  EXPECT_TRUE(said.starts_with(GetParam().place)) << said;
  EXPECT_THAT(said, HasSubstr(GetParam().says));
}

using namespace std::string_view_literals;

INSTANTIATE_TEST_SUITE_P(
    Cells, RefusedMap,
    testing::Values(
        Refused{"an empty file", "", "m.map: ", "empty"},
        Refused{"only a newline", "\n", "m.map:1:1: ", "empty line"},
        Refused{"a blank first line", "\n111\n", "m.map:1:1: ", "empty line"},
        Refused{"a blank line within", "111\n\n111\n", "m.map:2:1: ", "empty line"},
        Refused{"a blank line at the end", "111\n\n", "m.map:2:1: ", "empty line"},
        Refused{"a short row", "111\n111\n11\n", "m.map:3:3: ",
                "the row is too short: expected 3 cells, as in the first row, got 2; were trailing spaces "
                "stripped? Use `_`"},
        Refused{"a short first row", "11\n111\n",
                "m.map:2:3: ", "were trailing spaces stripped from the first? Use `_`"},
        Refused{"CR only", "111\r101\r111\r", "m.map:1:4: ", "carriage return"},
        Refused{"CR CR LF", "111\r\r\n111\r\r\n", "m.map:1:4: ", "carriage return"},
        Refused{"a NUL byte", "1\0001\n"sv, "m.map:1:2: ", "NUL"},
        Refused{"bad UTF-8", "11\n1\xE9\n", "m.map:2:2: ", "0xE9, which is not UTF-8"},
        Refused{"truncated UTF-8", "11\n1\xC3", "m.map:2:2: ", "not UTF-8"},
        Refused{"overlong UTF-8", "\xC0\xAF", "m.map:1:1: ", "not UTF-8"},
        Refused{"a letter beyond ASCII", "1\xC3\xA9\n", "m.map:1:2: ", "`\xC3\xA9` (U+00E9)"},
        Refused{"a byte order mark within",
                "1\xEF\xBB\xBF"
                "1\n",
                "m.map:1:2: ", "byte order mark"},
        Refused{"UTF-16",
                "\xFF\xFE"
                "1\0"
                "1\0"sv,
                "m.map:1:1: ", "0xFF"},
        Refused{"a tab", "1\t1\n", "m.map:1:2: ", "a tab"},
        Refused{"a control character", "1\x1B[m\n", "m.map:1:2: ", "control character 0x1B"},
        Refused{"an unknown letter", "111\n1a1\n",
                "m.map:2:2: ", "unexpected character: expected `0`, space or `_` for floor"},
        Refused{"a strange character before a wrong length", "111\n1a111\n", "m.map:2:2: ", "got `a`"},
        Refused{"a digit without legend", "151\n", "m.map:1:2: ", "no [legend]"},
        Refused{"a second S", "S1\n1S\n",
                "m.map:2:2: ", "second `S`: expected at most one; the first is in line 1, column 1"},
        Refused{"a second G", "GG\n", "m.map:1:2: ", "second `G`: expected at most one"},
        Refused{". and # swapped", "......\n.####.\n......\n", "m.map:1:1: ", "were `.` and `#` swapped?"}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    FrontMatter, RefusedMap,
    testing::Values(
        Refused{"unclosed", "+++\nname = \"x\"\n111\n", "m.map:1:1: ", "never ends"},
        Refused{"nothing after it", "+++\n+++\n", "m.map:2:1: ", "no cells"},
        Refused{"not on the first line", "111\n+++\n", "m.map:2:1: ", "first line"},
        Refused{"text on the fence", "+++ x\n", "m.map:1:4: ", "after +++"},
        Refused{"CR only", "+++\r+++\r11\r", "m.map:1:4: ", "carriage return"},
        Refused{"broken TOML", "+++\nname = \n+++\n11\n", "m.map:2:", "TOML"},
        Refused{"an unknown key", "+++\nname = \"a\"\nsizes = 3\n+++\n11\n", "m.map:3:", "unknown key sizes"},
        Refused{"no unit", "+++\ncell = 50\n+++\n11\n", "m.map:2:", "expected a string with a unit"},
        Refused{"a cell of no size", "+++\ncell = \"0 mm\"\n+++\n11\n", "m.map:2:", "cell: expected"},
        Refused{"a line wider than a cell", "+++\ncell = \"20 mm\"\nline = \"30 mm\"\n+++\n11\n",
                "m.map:3:", "line: expected at most the width of a cell, 20 mm, got 30 mm"},
        Refused{"an unknown floor", "+++\nfloor = \"grass\"\n+++\n11\n", "m.map:2:", "raster"},
        Refused{"an unknown goal", "+++\ngoal = \"win\"\n+++\n11\n", "m.map:2:", "laps:N"},
        Refused{"laps without a number", "+++\ngoal = \"laps:0\"\n+++\n11\n", "m.map:2:", "laps:N"},
        Refused{"an unknown legend word", "+++\n[legend]\n3 = \"hole\"\n+++\n11\n",
                "m.map:3:", "gap or obstacle"},
        Refused{"a legend for a fixed sign", "+++\n[legend]\n2 = \"floor\"\n+++\n11\n", "m.map:3:", "3 to 9"},
        Refused{"a start off the line", "+++\n[start]\nx = 0\ny = 0\n+++\n_1\n", "m.map:2:", "not on a line"},
        Refused{"a start outside", "+++\n[start]\nx = 2\ny = 0\n+++\n_1\n", "m.map:2:", "outside the map"},
        Refused{"half a start", "+++\n[start]\nx = 1\n+++\n_1\n", "m.map:2:", "lacks the key y"},
        Refused{"an empty start", "+++\n[start]\n+++\n_1\n", "m.map:2:", "requires x and y"},
        Refused{"two starts", "+++\n[start]\nx = 0\ny = 0\n+++\n1S\n", "m.map:2:", "remove one of them"},
        Refused{"a start on an obstacle", "+++\n[start]\nx = 0\ny = 0\n+++\nx1\n", "m.map:2:", "obstacle"},
        Refused{"two goals", "+++\n[goal]\nx = 0\ny = 0\n+++\n1G\n", "m.map:2:", "remove one of them"},
        Refused{"a goal off the line", "+++\n[goal]\nx = 0\ny = 0\n+++\n_1\n", "m.map:2:", "not on a line"},
        Refused{"a station off the line", "+++\n[stations]\ndock = [0, 0]\n+++\n_1\n",
                "m.map:3:", "station dock"},
        Refused{"a station named by a number", "+++\n[stations]\n2 = [1, 0]\n+++\n_1\n",
                "m.map:3:", "station name"},
        Refused{"a station of one number", "+++\n[stations]\ndock = [1]\n+++\n_1\n",
                "m.map:3:", "[column, row]"},
        Refused{"two stations on a cell", "+++\n[stations]\na = [1, 0]\nb = [1, 0]\n+++\n_1\n",
                "m.map:4:", "same cell"}),
    name_of);

TEST(RefusedMap, AbsurdSizesEndSoon) {
  EXPECT_THAT(complaint(std::string(300'000, '1')),
              HasSubstr("the row is too long: expected at most 100000 cells"));
  std::string tall;
  for (int y = 0; y < kMaxSide + 1; ++y) tall += "1\n";
  EXPECT_THAT(complaint(tall), HasSubstr("m.map:100001:1: "));
  EXPECT_THAT(complaint("+++\n" + std::string(3 << 20, '#')), HasSubstr("too long: expected at most 1 MB"));
}

TEST(RefusedMap, ADenseGridWrittenInDigitsIsNoSwap) {
  EXPECT_EQ(complaint("11111\n12121\n11111\n"), "accepted");
  EXPECT_EQ(complaint("....\n....\n"), "accepted");
  EXPECT_EQ(complaint("\xEF\xBB\xBF....\n....\n"), "accepted") << "a Windows editor wrote the file";
  EXPECT_EQ(complaint("\xEF\xBB\xBF+++\nname = \"m\"\n+++\n....\n"), "accepted");
}

TEST(Start, IsTheFirstDeadEndInRowOrderFacingItsLine) {
  const Start start =
      default_start(parse_map("______\n"
                              "_111__\n"
                              "_1_1__\n"
                              "_111__\n"
                              "__1___\n"
                              "______\n",
                              "m.map"));
  EXPECT_EQ(start.cell, (CellAt{2, 4}));
  EXPECT_EQ(start.facing, Direction::north);
}

TEST(Start, OnALoopIsTheFirstLineCellFacingEast) {
  const Start start = default_start(parse_map("____\n_11_\n_11_\n", "m.map"));
  EXPECT_EQ(start.cell, (CellAt{1, 1}));
  EXPECT_EQ(start.facing, Direction::east);
}

TEST(Start, FacesTheFirstOfEastSouthWestNorth) {
  const Map map = parse_map("_1_\n111\n_1_\n", "m.map");
  EXPECT_EQ(default_facing(map, {1, 1}), Direction::east);
  EXPECT_EQ(default_facing(map, {0, 1}), Direction::east);
  EXPECT_EQ(default_facing(map, {2, 1}), Direction::west);
  EXPECT_EQ(default_facing(map, {1, 0}), Direction::south);
  EXPECT_EQ(default_facing(map, {1, 2}), Direction::north);
  EXPECT_EQ(default_facing(parse_map("_1_\n_11\n", "m.map"), {1, 1}), Direction::east);
  EXPECT_EQ(default_facing(parse_map("_1_\n11_\n", "m.map"), {1, 1}), Direction::west);
}

TEST(Start, NeedsALine) { EXPECT_THROW(default_start(parse_map("___\n", "m.map")), InputError); }

TEST(Start, OfTheUserIsColumnRowAndDirection) {
  const Map map = parse_map("_11_\n_1__\n", "m.map");
  const Start start = parse_start(map, "1,1,S");
  EXPECT_EQ(start.cell, (CellAt{1, 1}));
  EXPECT_EQ(start.facing, Direction::south);
  EXPECT_EQ(parse_start(map, "1,1").facing, Direction::north);
  EXPECT_EQ(parse_start(map, "2,0,w").facing, Direction::west);
  for (const char* wrong : {"", "1", "1,", "1,1,", "1,1,Q", "1,1,EE", "1;1", "a,1", "-1,1", "1,1,E,", " 1,1",
                            "0,0", "9,0", "1,99999999999"})
    EXPECT_THROW(parse_start(map, wrong), InputError) << wrong;
}

}  // namespace robosim::map::map_test
