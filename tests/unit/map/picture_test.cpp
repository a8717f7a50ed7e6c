#include "sim/map/picture.h"

#include <gmock/gmock.h>

#include <string>

namespace robosim::map::picture_test {

using ::testing::HasSubstr;
using ::testing::Not;

std::string picture(const Map& map, const PictureOptions& options) {
  const Start start = default_start(map);
  return draw(map, trace_network(map, start), start, options);
}

TEST(Picture, ShowsLinesStationsStartAndCoordinates) {
  const Map map = parse_map(
      "#######\n"
      "#_____#\n"
      "#_..._#\n"
      "#_._._#\n"
      "#_S___#\n"
      "#######\n",
      "m.map");
  EXPECT_EQ(picture(map, {}),
            "  0         5\n"
            "0 ▒▒▒▒▒▒▒▒▒▒▒▒▒▒\n"
            "1 ▒▒          ▒▒\n"
            "2 ▒▒  ┌───┐   ▒▒\n"
            "3 ▒▒  │   2   ▒▒\n"
            "4 ▒▒  ▲1      ▒▒\n"
            "5 ▒▒▒▒▒▒▒▒▒▒▒▒▒▒\n"
            "▲ start, 1 to 2 stations, ▒ wall\n");
}

TEST(Picture, CanDoWithAsciiAndNarrowCells) {
  const Map map =
      parse_map("+++\ncorner = \"50 mm\"\n[legend]\n3 = \"gap\"\n+++\n__...3..x.\n__.______.\n", "m.map");
  EXPECT_EQ(picture(map, {14, 20, true}),
            "  0    5\n"
            "0   +--.--x+\n"
            "1   ^1     ?\n"
            "^ start, 1 the station, ? not reachable, . gap, x obstacle\n");
}

TEST(Picture, ALargeMapIsClippedAroundTheStartAndSaysSo) {
  std::string text;
  for (int y = 0; y < 300; ++y) {
    std::string row(400, '_');
    if (y == 200) row.replace(150, 100, std::string(100, '.')).replace(240, 1, "S");
    text += row + '\n';
  }
  const std::string drawn = picture(parse_map(text, "m.map"), {80, 24, false});
  EXPECT_THAT(drawn, HasSubstr("►"));
  EXPECT_THAT(drawn, HasSubstr("Only columns 202 to 277 of 400 and rows 190 to 209 of 300 are shown"));
  EXPECT_THAT(drawn, Not(HasSubstr("\n189")));
}

}  // namespace robosim::map::picture_test
