// Tests the coloured areas of a map, and the rules of competitions in a map.
#include <gmock/gmock.h>

#include "sim/map/map.h"
#include "sim/map/map_writer.h"
#include "tests/support/refusal.h"

namespace robosim::map::area_test {

using ::testing::HasSubstr;

Map map_of(const std::string& tables) {
  return parse_map(
      "+++\nsize = [\"2 m\", \"1 m\"]\n" + tables +
          "\n[[path]]\nfrom = [\"200 mm\", \"500 mm\"]\nsegments = [{ length = \"1 m\" }]\n+++\n",
      "m.map");
}

TEST(Area, IsARectangleOrADiscAtAPointOrBesideAPath) {
  const Map map = map_of(R"([[area]]
colour = "green"
along = "300 mm"
side = "right"
away = "25 mm"
size = ["25 mm", "20 mm"]
[[area]]
colour = "grey 40 %"
at = ["1.5 m", "300 mm"]
radius = "50 mm"
over_lines = true
[[area]]
colour = "silver"
at = ["1 m", "200 mm"]
size = ["250 mm", "25 mm"]
angle = "90 deg")");
  const std::vector<Area>& areas = map.course.areas;
  ASSERT_EQ(areas.size(), 3u);
  EXPECT_TRUE(areas[0].contains({0.512, 0.466}));
  EXPECT_FALSE(areas[0].contains({0.513, 0.466}));
  EXPECT_FALSE(areas[0].contains({0.5, 0.486}));
  EXPECT_EQ(areas[0].colour.hue, Hue::green);
  EXPECT_FALSE(areas[0].over_lines);
  EXPECT_TRUE(areas[1].contains({1.535, 0.335}));
  EXPECT_FALSE(areas[1].contains({1.536, 0.336}));
  EXPECT_NEAR(areas[1].colour.infrared(), 0.6, 1e-12);
  EXPECT_TRUE(areas[1].over_lines);
  EXPECT_TRUE(areas[2].contains({1.012, 0.324}));
  EXPECT_FALSE(areas[2].contains({1.1, 0.2}));

  const Map again = parse_map(write_map(map), "again.map");
  ASSERT_EQ(again.course.areas.size(), 3u);
  for (std::size_t i = 0; i < areas.size(); ++i) {
    const Area& a = areas[i];
    const Area& b = again.course.areas[i];
    EXPECT_EQ(a.colour, b.colour);
    EXPECT_NEAR(length(a.middle.position - b.middle.position), 0.0, 1e-12);
    EXPECT_NEAR(length(a.middle.heading - b.middle.heading), 0.0, 1e-9);
    EXPECT_EQ(a.radius, b.radius);
    EXPECT_EQ(a.half_width, b.half_width);
    EXPECT_EQ(a.over_lines, b.over_lines);
  }
}

TEST(Course, RulesOfRacesAndOfRescueLineAreWrittenAsTheyWereRead) {
  const std::string strip = R"([race]
start = "100 mm"
goal = "600 mm"
braking = "300 mm"
signal = "1.5 s"
)";
  const std::string tiles = R"([rescue]
tile = "250 mm"
checkpoints = ["300 mm", "700 mm"]
league = "entry"
end = "zone"
origin = ["100 mm", "200 mm"]
)";
  const std::string path = "[[path]]\nfrom = [\"200 mm\", \"500 mm\"]\nsegments = [{ length = \"1 m\" }]\n";
  const std::string written =
      write_map(parse_map("+++\nsize = [\"2 m\", \"1 m\"]\n" + path + strip + tiles + "+++\n", "m.map"));
  EXPECT_THAT(written, HasSubstr(strip));
  EXPECT_THAT(written, HasSubstr(tiles));
}

TEST(Area, ThatMakesNoSenseIsRefusedWithPlaceAndReason) {
  const std::string at = "at = [\"1 m\", \"200 mm\"]\n", size = "size = [\"25 mm\", \"25 mm\"]\n";
  const struct {
    std::string area;
    const char* message;
  } refused[] = {
      {at + size, "m.map:3:1: [[area]] lacks the key colour"},
      {"colour = \"blue\"\n" + at + size, "m.map:4:10: colour: expected black, white, grey,"},
      {"colour = \"grey 140 %\"\n" + at + size, "grey with its share of black, as in \"grey 40 %\""},
      {"colour = 3\n" + at + size, "colour: expected a string, got 3"},
      {"colour = \"red\"\n" + size, "an area requires a middle: either at = [\"X\", \"Y\"]"},
      {"colour = \"red\"\nalong = \"1 m\"\n" + at + size, "an area requires a middle: either"},
      {"colour = \"red\"\nat = \"1 m\"\n" + size, "at: expected two lengths, as in [\"300 mm\", \"1.2 m\"]"},
      {"colour = \"red\"\nat = [\"1 m\"]\n" + size, "at: expected two lengths"},
      {"colour = \"red\"\nat = [\"3 m\", \"0 mm\"]\n" + size,
       "the middle of this area is outside the floor: expected at most 2000 x 1000 mm, got 3000 mm, 0 mm"},
      {"colour = \"red\"\nalong = \"3 m\"\n" + size, "m.map:5:9: along: expected "},
      {"colour = \"red\"\nalong = \"1 m\"\npath = 2\n" + size,
       "path: expected a whole number from 1 to 1, got 2"},
      {"colour = \"red\"\nalong = \"1 m\"\nside = \"middle\"\n" + size,
       "side: expected left or right, got “middle”"},
      {"colour = \"red\"\n" + at,
       "an area requires either size = [\"25 mm\", \"250 mm\"], a rectangle, or radius"},
      {"colour = \"red\"\nradius = \"5 mm\"\n" + at + size, "an area requires either size = "},
      {"colour = \"red\"\nradius = \"0 mm\"\n" + at, "radius: expected "},
      {"colour = \"red\"\nradius = \"5 mm\"\nangle = \"5 deg\"\n" + at, "angle requires size, a rectangle"},
      {"colour = \"red\"\nsize = [\"25 mm\", \"25\"]\n" + at, "size: expected a number with a unit"},
      {"colour = \"red\"\nover_lines = \"yes\"\n" + at + size, "over_lines: expected true or false, got "},
      {"colour = \"red\"\nname = \"finish\"\n" + at + size, "name"},
  };
  for (const auto& one : refused) {
    EXPECT_THAT(test::refusal([&] { map_of("[[area]]\n" + one.area); }), HasSubstr(one.message)) << one.area;
  }
  std::string many;
  for (int i = 0; i <= 1000; ++i) many += "[[area]]\ncolour = \"red\"\n" + at + size;
  EXPECT_THROW(map_of(many), InputError);
  EXPECT_THROW(map_of("[area]\ncolour = \"red\"\n" + at + size), InputError);
}

}  // namespace robosim::map::area_test
