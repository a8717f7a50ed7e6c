#include "sim/map/relief.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>

#include "sim/map/map.h"
#include "sim/map/map_writer.h"
#include "tests/support/refusal.h"

namespace robosim::map::relief_test {

using ::testing::HasSubstr;

Map relief_of(const std::string& tables) {
  return parse_map(
      "+++\nsize = [\"2 m\", \"1 m\"]\n" + tables +
          "\n[[path]]\nfrom = [\"200 mm\", \"500 mm\"]\nsegments = [{ length = \"1 m\" }]\n+++\n",
      "m.map");
}

constexpr const char* kHills = R"([[hill]]
along = "300 mm"
size = ["600 mm", "300 mm"]
slope = "-25 deg"
[[hill]]
at = ["1 m", "500 mm"]
size = ["60 mm", "300 mm"]
angle = "90 deg"
heights = ["0 mm", "10 mm", "3 mm"]
[[hill]]
at = ["1.5 m", "500 mm"]
size = ["600 mm", "300 mm"]
seesaw = "50 mm"
plank = "400 g"
[[surface]]
at = ["1 m", "500 mm"]
radius = "100 mm"
kind = "carpet"
[[surface]]
along = "500 mm"
size = ["200 mm", "300 mm"]
grip = "40 %"
rolling = 0.01
[[joint]]
along = "600 mm"
size = ["3 mm", "300 mm"]
)";

TEST(Relief, IsRampsProfilesSeesawsAndSurfaces) {
  const Map map = relief_of(kHills);
  for (const Map& m : {map, parse_map(write_map(map), "again.map")}) {
    ASSERT_EQ(m.course.hills.size(), 3u);
    const Hill &ramp = m.course.hills[0], &bump = m.course.hills[1], &seesaw = m.course.hills[2];
    ASSERT_EQ(ramp.heights.size(), 2u);
    EXPECT_NEAR(ramp.heights[0], 0.6 * 0.42261826174, 1e-8);
    EXPECT_EQ(ramp.heights[1], 0.0);
    EXPECT_NEAR(ramp.middle.position.x, 0.5, 1e-12);
    EXPECT_EQ(bump.heights, (std::vector<double>{0.0, 0.010, 0.003}));
    EXPECT_NEAR(bump.middle.heading.y, 1.0, 1e-12);
    EXPECT_EQ(seesaw.pivot, 0.05);
    EXPECT_EQ(seesaw.plank_kg, 0.4);
    ASSERT_EQ(m.course.surfaces.size(), 2u);
    EXPECT_EQ(m.course.surfaces[0].rolling, 0.05);
    EXPECT_EQ(m.course.surfaces[0].grip, 1.0);
    EXPECT_EQ(m.course.surfaces[1].grip, 0.4);
    EXPECT_EQ(m.course.surfaces[1].rolling, 0.01);
    ASSERT_EQ(m.course.joints.size(), 1u);
    EXPECT_NEAR(m.course.joints[0].middle.position.x, 0.8, 1e-12);
    EXPECT_NEAR(m.course.joints[0].half_length, 0.0015, 1e-12);
    EXPECT_NEAR(m.course.joints[0].half_width, 0.15, 1e-12);
    EXPECT_TRUE(m.course.areas.empty()) << "gaps are not areas of the map";
  }
}

TEST(Relief, ThatMakesNoSenseIsRefusedWithPlaceAndReason) {
  const std::string hill = "[[hill]]\n", surface = "[[surface]]\n", joint = "[[joint]]\n",
                    at = "at = [\"1 m\", \"200 mm\"]\n", size = "size = [\"300 mm\", \"300 mm\"]\n",
                    ramp = "slope = \"20 deg\"\n";
  const struct {
    std::string table;
    const char* message;
  } refused[] = {
      {hill + at + size, "m.map:3:1: invalid hill: expected one of heights = [\"0 mm\", \"60 mm\"], slope"},
      {hill + at + size + "slop = \"20 deg\"", "unknown key slop in [[hill]]; did you mean slope?"},
      {hill + at + size + ramp + "seesaw = \"20 mm\"", "invalid hill: expected one of heights"},
      {hill + at + size + ramp + "heights = [\"0 mm\", \"9 mm\"]", "invalid hill: expected one of heights"},
      {hill + at + ramp, "a hill requires either size = "},
      {hill + at + ramp + "radius = \"100 mm\"", "m.map:6:10: invalid hill: expected a rectangle, size = "},
      {hill + size + ramp, "a hill requires a middle: either at = [\"X\", \"Y\"]"},
      {hill + at + size + "slope = \"60 deg\"", "m.map:6:9: slope: expected -45 to 45 deg, got 60 deg"},
      {hill + at + size + "slope = \"20 %\"", "slope: expected"},
      {hill + at + size + "slope = 20", "slope: expected a string with a unit"},
      {hill + at + "size = [\"2 m\", \"300 mm\"]\nslope = \"20 deg\"",
       "the ramp is too high: expected at most 0.5 m, got 0.684 m"},
      {hill + at + size + "heights = \"9 mm\"", "heights: expected 2 to 33 heights"},
      {hill + at + size + "heights = []", "heights: expected 2 to 33 heights"},
      {hill + at + size + "heights = [\"9 mm\"]", "heights: expected 2 to 33 heights"},
      {hill + at + size + "heights = [\"0 mm\", \"-3 mm\"]",
       "m.map:6:20: a height: expected 0 to 500 mm, got -3 mm"},
      {hill + at + size + "heights = [\"0 mm\", \"1 m\"]", "a height: expected 0 to 0.5 m, got 1 m"},
      {hill + at + size + "heights = [\"0 mm\", 3]", "a height: expected a string with a unit"},
      {hill + at + size + "heights = [\"0 mm\", \"3 g\"]", "a height: expected a number with a unit"},
      {hill + at + size + "heights = [\"0 mm\", \"300 mm\"]",
       "m.map:6:20: the hill is too steep: expected at most 75 % of height along the slope, got 0 to 300 mm "
       "within 300 mm"},
      {hill + at + size + "heights = [\"0 mm\", \"200 mm\", \"0 mm\"]", "the hill is too steep"},
      {hill + at + size + ramp + "plank = \"600 g\"", "plank, the mass of a seesaw, requires seesaw"},
      {hill + at + size + "seesaw = \"100 mm\"", "the seesaw is too steep: expected at most 30 deg"},
      {hill + at + size + "seesaw = \"0 mm\"", "seesaw: expected "},
      {hill + at + size + "seesaw = \"20 mm\"\nplank = \"6 kg\"", "plank: expected "},
      {hill + at + size + ramp + "colour = \"red\"", "colour"},
      {hill + "at = [\"3 m\", \"0 mm\"]\n" + size + ramp, "the middle of this hill is outside the floor"},
      {hill + "along = \"3 m\"\n" + size + ramp, "along: expected "},
      {"[hill]\n" + at + size + ramp, "hill: expected [[hill]], with two brackets"},
      {surface + at + size,
       "m.map:3:1: invalid surface: expected either a kind, as in kind = \"carpet\", or values"},
      {surface + at + size + "kind = \"wet\"\ngrip = 0.5", "invalid surface: expected either a kind"},
      {surface + at + size + "kind = \"ice\"", "kind: expected wet, dusty or carpet"},
      {surface + at + size + "grip = 0", "grip: expected"},
      {surface + at + size + "grip = \"3 mm\"", "grip: expected"},
      {surface + at + size + "rolling = -0.1", "rolling: expected"},
      {surface + at + size + "kind = \"wet\"\nheights = []", "heights"},
      {surface + at + "kind = \"wet\"", "a surface requires either size = "},
      {surface + "at = [\"1 m\", \"2 m\"]\n" + size + "kind = \"wet\"",
       "the middle of this surface is outside the floor"},
      {joint + at + "size = [\"7 mm\", \"300 mm\"]",
       "m.map:5:9: the joint is too wide: expected at most 6 mm, got 7 mm"},
      {joint + at + "size = [{ value = \"5 mm\", spread = \"2 mm\" }, \"300 mm\"]",
       "the joint is too wide: expected at most 6 mm, got 7 mm"},
      {joint + at + "size = [\"0.5 mm\", \"300 mm\"]", "size: expected 1 mm"},
      {joint + at + "size = [\"3 mm\"]", "size: expected two lengths"},
      {joint + at + "radius = \"3 mm\"", "m.map:5:10: invalid joint: expected a gap between boards, size = "},
      {joint + at, "a joint requires either size = "},
      {joint + size, "a joint requires a middle"},
      {joint + at + "size = [\"3 mm\", \"300 mm\"]\nwidth = \"3 mm\"", "unknown key width in [[joint]]"},
      {joint + at + "size = [\"3 mm\", \"300 mm\"]\nangle = \"4 mm\"", "angle: expected"},
      {joint + "at = [\"1 m\", \"2 m\"]\nsize = [\"3 mm\", \"300 mm\"]",
       "the middle of this joint is outside the floor"},
      {joint + "along = \"3 m\"\nsize = [\"3 mm\", \"300 mm\"]", "along: expected "},
      {"[joint]\nsize = 3\n", "joint: expected [[joint]], with two brackets"},
      {"surface = 3\n", "surface: expected [[surface]], with two brackets"},
  };
  for (const auto& one : refused) {
    EXPECT_THAT(test::refusal([&] { relief_of(one.table + "\n"); }), HasSubstr(one.message)) << one.table;
  }
  std::string hills, surfaces, joints;
  for (int i = 0; i <= 64; ++i) hills += hill + at + size + ramp;
  for (int i = 0; i <= 256; ++i) surfaces += surface + at + size + "kind = \"wet\"\n";
  for (int i = 0; i <= 128; ++i) joints += joint + at + "size = [\"3 mm\", \"300 mm\"]\n";
  EXPECT_THROW(relief_of(joints), InputError);
  EXPECT_THROW(relief_of(hills), InputError);
  EXPECT_THROW(relief_of(surfaces), InputError);
}

TEST(AHillWithASpread, IsAsItsFileInIdealAndDrawnByTheSeedElse) {
  const std::string text =
      "+++\nsize = [\"2 m\", \"1 m\"]\n"
      "[[hill]]\nat = [\"1 m\", \"500 mm\"]\nsize = [\"600 mm\", \"300 mm\"]\n"
      "slope = { value = \"15 deg\", spread = \"5 deg\" }\n"
      "[[surface]]\nat = [\"1 m\", \"500 mm\"]\nradius = \"100 mm\"\ngrip = { value = 0.5, spread = \"20 %\" "
      "}\n"
      "[[path]]\nfrom = [\"200 mm\", \"500 mm\"]\nsegments = [{ length = \"1 m\" }]\n+++\n";
  const auto rise = [&](Draw draw) { return parse_map(text, "m.map", "", draw).course.hills[0].heights[1]; };
  const auto grip = [&](Draw draw) { return parse_map(text, "m.map", "", draw).course.surfaces[0].grip; };
  EXPECT_NEAR(rise({7, Profile::ideal}), 0.6 * std::sin(std::numbers::pi / 12), 1e-12);
  EXPECT_EQ(grip({}), 0.5);
  double least = 1.0, most = 0.0;
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    const Draw draw{seed, Profile::typical};
    least = std::min(least, rise(draw));
    most = std::max(most, rise(draw));
    EXPECT_NEAR(grip(draw), 0.5, 0.1);
    EXPECT_EQ(rise(draw), rise(draw));
  }
  EXPECT_GT(least, 0.6 * std::sin(std::numbers::pi / 18));
  EXPECT_LT(least, 0.6 * std::sin(std::numbers::pi / 16));
  EXPECT_GT(most, 0.6 * std::sin(std::numbers::pi / 10));
  EXPECT_LT(most, 0.6 * std::sin(std::numbers::pi / 9));
}

// The floor is 2 m x 1 m large, and has a straight path along y = 500 mm. The test draws places and sizes
// with 40 seeds.
TEST(APlaceWithASpread, IsAsItsFileInIdealAndDrawnByTheSeedElse) {
  const std::string text =
      "+++\nsize = [\"2 m\", \"1 m\"]\n"
      "[[hill]]\nalong = { value = \"600 mm\", spread = \"100 mm\" }\naway = { value = \"50 mm\", spread = "
      "\"20 mm\" }\nside = \"right\"\nsize = [{ value = \"600 mm\", spread = \"10 %\" }, \"300 "
      "mm\"]\nangle = { value = \"0 deg\", spread = \"30 deg\" }\nheights = [\"0 mm\", \"50 mm\"]\n"
      "[[surface]]\nat = [{ value = \"1 m\", spread = \"200 mm\" }, \"500 mm\"]\nradius = { value = "
      "\"100 mm\", spread = \"20 mm\" }\nkind = \"wet\"\n"
      "[[light]]\nlevel = 0.5\nat = [\"1 m\", { value = \"500 mm\", spread = \"100 mm\" }]\nradius = "
      "\"150 mm\"\nmoves = [{ value = \"2 mm/s\", spread = \"2 mm/s\" }, \"0 mm/s\"]\n"
      "[[path]]\nfrom = [\"200 mm\", \"500 mm\"]\nsegments = [{ length = \"1 m\" }]\n+++\n";
  using Figure = std::function<double(const Map&)>;
  const auto middle = [](const Map& map) { return map.course.hills[0].middle; };
  const struct {
    const char* name;
    double value, spread;
    Figure of;
  } figures[] = {
      {"along", 0.8, 0.1, [&](const Map& map) { return middle(map).position.x; }},
      {"away", 0.45, 0.02, [&](const Map& map) { return middle(map).position.y; }},
      {"size", 0.3, 0.03, [](const Map& map) { return map.course.hills[0].half_length; }},
      {"angle", 0.0, 0.5, [&](const Map& map) { return middle(map).heading.y; }},
      {"at", 1.0, 0.2, [](const Map& map) { return map.course.surfaces[0].middle.position.x; }},
      {"radius", 0.1, 0.02, [](const Map& map) { return map.course.surfaces[0].radius; }},
      {"a light's at", 0.5, 0.1, [](const Map& map) { return map.lights[0].at->y; }},
      {"moves", 0.002, 0.002, [](const Map& map) { return map.lights[0].moves.x; }},
  };
  for (const auto& [name, value, spread, of] : figures) {
    EXPECT_NEAR(of(parse_map(text, "m.map")), value, 1e-12) << name;
    double least = 1e9, most = -1e9;
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
      const double drawn = of(parse_map(text, "m.map", "", {seed, Profile::typical}));
      least = std::min(least, drawn), most = std::max(most, drawn);
    }
    EXPECT_GE(least, value - spread - 1e-12) << name;
    EXPECT_LT(least, value - 0.7 * spread) << name;
    EXPECT_LE(most, value + spread + 1e-12) << name;
    EXPECT_GT(most, value + 0.7 * spread) << name;
  }
}

TEST(APlaceWithASpread, IsRefusedWhereNotAllOfItIsAllowedWhateverTheSeed) {
  const auto refused = [](const std::string& table) { return test::refusal([&] { relief_of(table); }, ""); };
  const std::string size = "size = [\"600 mm\", \"300 mm\"]\n", at = "at = [\"1 m\", \"500 mm\"]\n";
  EXPECT_THAT(
      refused("[[surface]]\nat = [\"1 m\", { value = \"900 mm\", spread = \"200 mm\" }]\nradius = \"9 mm\"\n"
              "kind = \"wet\"\n"),
      HasSubstr("the middle of this surface may be outside the floor"));
  EXPECT_THAT(refused("[[hill]]\nat = [{ value = \"50 mm\", spread = \"60 mm\" }, \"500 mm\"]\n" + size +
                      "slope = \"9 deg\"\n"),
              HasSubstr("the spread of at: expected values from 0 to "));
  EXPECT_THAT(refused("[[hill]]\n" + at +
                      "size = [{ value = \"600 mm\", spread = \"50 mm\" }, \"300 mm\"]\n"
                      "heights = [\"0 mm\", \"440 mm\"]\n"),
              HasSubstr("got 0 to 440 mm within 550 mm"));
  EXPECT_THAT(
      refused("[[hill]]\n" + at +
              "size = [{ value = \"700 mm\", spread = \"100 mm\" }, \"300 mm\"]\nslope = \"44 deg\"\n"),
      HasSubstr("the ramp is too high: expected at most 0.5 m, got 0.5557 m"));
}

TEST(AHillWithASpread, IsRefusedWhereNotAllOfItIsAllowed) {
  const auto refused = [](const std::string& figure) {
    return test::refusal(
        [&] {
          relief_of("[[hill]]\nat = [\"1 m\", \"500 mm\"]\nsize = [\"600 mm\", \"300 mm\"]\n" + figure);
        },
        "");
  };
  EXPECT_THAT(refused("slope = { value = \"40 deg\", spread = \"6 deg\" }"),
              HasSubstr("m.map:6:38: the spread of slope: expected values from -45 to 45 deg, got 34 to 46"));
  EXPECT_THAT(refused("seesaw = { value = \"145 mm\", spread = \"10 mm\" }"),
              HasSubstr("the seesaw is too steep: expected at most 30 deg"));
  EXPECT_THAT(refused("heights = [\"0 mm\", { value = \"440 mm\", spread = \"20 mm\" }]"),
              HasSubstr("got 0 to 460 mm within 600 mm"));
  EXPECT_THAT(refused("slope = { value = \"4 deg\", spread = \"6 kg\" }"), HasSubstr("the spread of slope"));
}

}  // namespace robosim::map::relief_test
