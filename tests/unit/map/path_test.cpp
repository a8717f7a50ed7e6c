#include "sim/map/path.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "sim/base/deterministic_trig.h"
#include "sim/base/noise.h"
#include "sim/map/map.h"
#include "sim/map/map_writer.h"
#include "sim/map/network.h"
#include "sim/map/stripes.h"
#include "tests/support/effort.h"
#include "tests/support/refusal.h"

namespace robosim::map::path_test {

using ::testing::HasSubstr;

constexpr double kPi = std::numbers::pi;

// The path has two straights of 600 mm and two half circles of 300 mm radius. Its length is 1.2 m + pi * 0.6
// m.
constexpr const char* kOval = R"(+++
line = "19 mm"
size = ["2 m", "1 m"]
[[path]]
from = ["700 mm", "200 mm"]
segments = [
  { length = "600 mm" }, { radius = "300 mm", angle = "180 deg" },
  { length = "600 mm" }, { radius = "300 mm", angle = "180 deg" },
]
+++
)";
constexpr double kOvalLength = 1.2 + 0.6 * kPi;

Map map_of(const std::string& course) {
  return parse_map("+++\nsize = [\"2 m\", \"1 m\"]\n" + course + "\n+++\n", "m.map");
}

std::string message_of(const std::string& course) {
  return test::refusal([&] { map_of(course); }, "no error");
}

TEST(Angle, DirectionsAreThoseOfLibmAndExactAtQuarterTurns) {
  for (int i = -7200; i <= 7200; ++i) {
    const double angle = i * kPi / 1800.0;
    const Vec2 d = unit_vector(angle);
    ASSERT_NEAR(d.x, std::cos(angle), 1e-15) << i;
    ASSERT_NEAR(d.y, std::sin(angle), 1e-15) << i;
    ASSERT_NEAR(std::remainder(angle_of(d * 3.0) - angle, 2 * kPi), 0.0, 1e-12) << i;
  }
  EXPECT_EQ(unit_vector(kPi / 2), (Vec2{0, 1}));
  EXPECT_EQ(unit_vector(-kPi / 2), (Vec2{0, -1}));
  EXPECT_EQ(unit_vector(kPi), (Vec2{-1, 0}));
}

TEST(Path, OfStraightsAndArcsComesBackToItsBeginning) {
  const Map map = parse_map(kOval, "oval.map");
  EXPECT_EQ(map.width, 20);
  EXPECT_EQ(map.height, 10);
  ASSERT_EQ(map.course.paths.size(), 1u);
  const Path& path = map.course.paths[0];
  EXPECT_NEAR(path.length(), kOvalLength, 1e-12);
  EXPECT_TRUE(path.is_closed(1e-9));
  const Pose quarter = path.at(0.6 + 0.15 * kPi, true);
  EXPECT_NEAR(quarter.position.x, 1.6, 1e-12);
  EXPECT_NEAR(quarter.position.y, 0.5, 1e-12);
  EXPECT_NEAR(quarter.heading.y, 1.0, 1e-12);
  const Pose again = path.at(kOvalLength + 0.1, true);
  EXPECT_NEAR(again.position.x, 0.8, 1e-9);
  EXPECT_NEAR(path.at(kOvalLength + 5.0, false).position.x, 0.7, 1e-9);
}

TEST(Path, TurnsToTheRightByAnAngleBelowZeroAndOnTheSpotWithoutARadius) {
  const Path path = map_of(R"([[path]]
from = ["1 m", "500 mm"]
heading = "90 deg"
segments = [{ radius = "200 mm", angle = "-90 deg" }, { angle = "-90 deg" }, { length = "100 mm" }])")
                        .course.paths[0];
  EXPECT_NEAR(path.end().position.x, 1.2, 1e-12);
  EXPECT_NEAR(path.end().position.y, 0.6, 1e-12);
  EXPECT_NEAR(path.end().heading.y, -1.0, 1e-12);
  EXPECT_NEAR(path.length(), 0.1 * kPi + 0.1, 1e-12);
  EXPECT_FALSE(path.is_closed(0.02));
}

// Compares distances to stripes with the smallest distance to points that are 0.1 mm apart on the path.
TEST(Path, StripesAreAsFarAsThePathIs) {
  const Map map = map_of(R"([[path]]
from = ["300 mm", "300 mm"]
heading = "33 deg"
segments = [{ length = "400 mm" }, { radius = "150 mm", angle = "250 deg" }, { length = "123 mm" },
  { angle = "-70 deg" }, { radius = "80 mm", angle = "-200 deg" }, { length = "200 mm" }])");
  const Stripes stripes(map, 0.3);
  const Path& path = map.course.paths[0];
  const NoiseStream noise(7, 0, "path", "test");
  for (std::uint64_t i = 0; i < test::rounds(300u); ++i) {
    const Vec2 p{noise.uniform(2 * i) * 2.0, noise.uniform(2 * i + 1)};
    double truth = std::numeric_limits<double>::infinity();
    for (double along = 0.0; along <= path.length(); along += 1e-4)
      truth = std::min(truth, length(path.at(along, false).position - p));
    if (truth > 0.29) continue;
    double found = std::numeric_limits<double>::infinity();
    const CellAt cell{static_cast<int>(p.x / map.cell_m),
                      map.height - 1 - static_cast<int>(p.y / map.cell_m)};
    for (const std::uint32_t n : stripes.near(cell)) found = std::min(found, distance(stripes.all()[n], p));
    ASSERT_NEAR(found, truth, 5e-5) << p.x << " " << p.y;
  }
}

// Tests points along the whole arc. Parts of the arc are outside the bounding box of the arc's two ends.
TEST(Path, StripesAreNearEachPointBesideIt) {
  const Map map = map_of(R"([[path]]
from = ["1357 mm", "226 mm"]
heading = "52.5 deg"
segments = [{ radius = "450 mm", angle = "300 deg" }])");
  const double reach_m = 0.015;
  const Stripes stripes(map, reach_m);
  const Path& path = map.course.paths[0];
  for (double along = 0.0; along <= path.length(); along += 1e-3)
    for (const double aside : {-0.9, 0.0, 0.9}) {
      const Pose at = path.at(along, false);
      const Vec2 p = at.position + Vec2{-at.heading.y, at.heading.x} * (aside * reach_m);
      double found = std::numeric_limits<double>::infinity();
      const CellAt cell{static_cast<int>(p.x / map.cell_m),
                        map.height - 1 - static_cast<int>(p.y / map.cell_m)};
      for (const std::uint32_t n : stripes.near(cell)) found = std::min(found, distance(stripes.all()[n], p));
      ASSERT_LT(found, reach_m) << along << " " << aside;
    }
}

TEST(Path, AGapIsFollowedButNotPainted) {
  const Map map = map_of(R"([[path]]
from = ["300 mm", "500 mm"]
segments = [{ length = "400 mm" }, { length = "100 mm", gap = true }, { length = "400 mm" }])");
  const Stripes stripes(map, 0.1);
  std::vector<Stripe> painted;
  for (const Stripe& stripe : stripes.all())
    if (stripe.painted) painted.push_back(stripe);
  ASSERT_EQ(painted.size(), 2u);
  // Paint reaches half a line's width, 10 mm, beyond a stripe's end.
  EXPECT_NEAR(painted[0].b.x, 0.690, 1e-12);
  EXPECT_NEAR(painted[1].a.x, 0.810, 1e-12);
  EXPECT_GT(stripes.all().size(), painted.size());
}

TEST(Path, ARobotStartsAtItsBeginningOrSoFarAlong) {
  const Map map = parse_map(kOval, "oval.map");
  const Stripes stripes(map, 0.1);
  const Pose first = stripes.pose_of(default_start(map));
  EXPECT_NEAR(first.position.x, 0.7, 1e-12);
  EXPECT_NEAR(first.position.y, 0.2, 1e-12);
  const Pose back = stripes.pose_of(parse_start(map, "250mm,back"));
  EXPECT_NEAR(back.position.x, 0.95, 1e-12);
  EXPECT_EQ(back.heading, (Vec2{-1, 0}));
  const Start start = parse_start(map, "250mm");
  EXPECT_EQ(start.cell, (CellAt{9, 7}));
  EXPECT_EQ(letter(start.facing), 'E');
  for (const char* bad : {"9m", "-1mm", "250mm,left"}) EXPECT_THROW(parse_start(map, bad), InputError) << bad;
}

TEST(Path, AClosedOneIsALap) {
  const Map map = parse_map(kOval, "oval.map");
  const Network network = trace_network(map, parse_start(map, "300mm"));
  ASSERT_TRUE(network.has_laps());
  EXPECT_NEAR(network.lap.front().x, 1.0, 1e-12);
  EXPECT_GT(network.lap[1].x, 1.0);
  EXPECT_LT(trace_network(map, parse_start(map, "300mm,back")).lap[1].x, 1.0);
  const Map open = map_of("[[path]]\nfrom = [\"1 m\", \"0.5 m\"]\nsegments = [{ length = \"0.5 m\" }]");
  EXPECT_FALSE(trace_network(open, default_start(open)).has_laps());
}

TEST(Path, AndMarksAreWrittenAsTheyWereRead) {
  const std::string text = write_map(map_of(R"(paint = "white on black"
variation = "12.5 %"
[start]
along = "50 mm"
backwards = true
[[path]]
from = ["1.1 m", "512.5 mm"]
heading = "-12.3456789 deg"
segments = [{ length = "333.3 mm" }, { radius = "100 mm", angle = "-77 deg" }, { angle = "45 deg" }, { length = "50 mm", gap = true }]
[[mark]]
along = "100 mm"
side = "right"
length = "25 mm")"));
  const Map read = parse_map(text, "again.map");
  EXPECT_TRUE(read.light_line);
  EXPECT_EQ(read.variation, 0.125);
  ASSERT_TRUE(read.start && read.start->on_path);
  EXPECT_TRUE(read.start->on_path->backwards);
  EXPECT_NEAR(read.start->on_path->along, 0.05, 1e-12);
  ASSERT_EQ(read.course.paths.size(), 1u);
  EXPECT_EQ(read.course.paths[0].pieces().size(), 4u);
  EXPECT_TRUE(read.course.paths[0].pieces()[3].is_gap);
  ASSERT_EQ(read.course.marks.size(), 1u);
  EXPECT_NEAR(read.course.marks[0].away, -0.070, 1e-12);
  EXPECT_NEAR(read.course.marks[0].half_length, 0.0125, 1e-12);
  EXPECT_EQ(write_map(read), text);
}

struct Refused {
  std::string course;
  const char* message;
};

TEST(Path, ThatMakesNoSenseIsRefusedWithPlaceAndReason) {
  const std::string path = "[[path]]\nfrom = [\"1 m\", \"0.5 m\"]\n";
  const std::string straight = "[[path]]\nfrom = [\"1 m\", \"0.5 m\"]\nsegments = [{ length = \"0.5 m\" }]\n";
  const Refused refused[] = {
      {"[path]\nfrom = [\"1 m\", \"1 m\"]",
       "m.map:3:1: path: expected [[path]], with two brackets, got a table"},
      {"[[path]]\nsegments = []", "[[path]] lacks the key from"},
      {"[[path]]\nfrom = [1, 2]\nsegments = []", "m.map:4:9: from: expected"},
      {"[[path]]\nfrom = \"1 m\"\nsegments = []", "from: expected [\"X\", \"Y\"]"},
      {"[[path]]\nfrom = [\"1 m\", \"0.5 m\"]\nsegments = []",
       "segments: expected a list of straights and arcs"},
      {"[[path]]\nfrom = [\"1 m\", \"0.5 m\"]\nsegments = [{ radius = \"100 mm\" }]",
       "invalid segment: expected a straight"},
      {"[[path]]\nfrom = [\"1 m\", \"0.5 m\"]\nsegments = [{ length = \"1 m\", angle = \"90 deg\" }]",
       "invalid segment: expected a straight"},
      {"[[path]]\nfrom = [\"1 m\", \"0.5 m\"]\nsegments = [{ radius = \"0.1 m\", angle = \"0 deg\" }]",
       "angle: expected at least 0.000001 deg"},
      {"[[path]]\nfrom = [\"1 m\", \"0.5 m\"]\nsegments = [{ radius = \"0.1 m\", angle = \"1e-7 deg\" }]",
       "angle: expected at least 0.000001 deg"},
      {"[[path]]\nfrom = [\"1 m\", \"0.5 m\"]\nsegments = [{ length = \"0.1 m\" }, { angle = \"-0 deg\" }]",
       "angle: expected at least 0.000001 deg"},
      {"[[path]]\nfrom = [\"1 m\", \"0.5 m\"]\nsegments = [{ radius = \"0.1 m\", angle = \"400 deg\" }]",
       "angle: expected "},
      {"[[path]]\nfrom = [\"1 m\", \"0.5 m\"]\nsegments = [{ length = \"0.1 m\", wide = 3 }]", "wide"},
      {"[[path]]\nfrom = [\"1 m\", \"0.5 m\"]\nsegments = [{ length = \"2 m\" }]",
       "segment 1 of this path leaves the floor at 3000 mm, 500 mm; the floor is 2000 x 1000 mm"},
      {"[[path]]\nfrom = [\"1 m\", \"0.8 m\"]\nsegments = [{ radius = \"300 mm\", angle = \"360 deg\" }]",
       "segment 1 of this path leaves the floor"},
      {"[[mark]]\nalong = \"1 m\"", "[[mark]] requires a [[path]]"},
      {"floor = \"raster\"\n[[path]]\nfrom = [\"1 m\", \"0.5 m\"]\nsegments = [{ length = \"0.1 m\" }]",
       "paints cells only, but this map has paths"},
      {"[start]\nalong = \"1 m\"", "[start] with along requires a [[path]]"},
      {"[race]\ngoal = \"1 m\"", "[race] requires a [[path]]"},
      {"[[path]]\nfrom = [\"1 m\", \"0.5 m\"]\nsegments = [{ length = \"0.5 m\" }]\n[race]\ngoal = \"0.1 m\"",
       "[race] requires a closed path"},
      {straight + "[race]\ngoal = \"0.1 m\"\nsignal = \"1 s\"", "[race] requires a closed path"},
      {straight + "[race]\ngoal = \"0.4 m\"\nbraking = \"0.2 m\"", "the path is too short for a drag race"},
      {straight + "[race]\nstart = \"0.4 m\"\ngoal = \"0.2 m\"\nbraking = \"0.1 m\"",
       "the path is too short for a drag race"},
      {straight + "[race]\ngoal = \"0.2 m\"\nbraking = \"0.1\"", "braking: expected"},
      {straight + "[race]\ngoal = \"0.2 m\"\nbraking = \"0.1 m\"\nsignal = \"1 h\"", "signal: expected "},
      {"[rescue]", "[rescue] requires a [[path]]"},
      {straight + "[rescue]\ntile = \"1 mm\"", "tile: expected "},
      {straight + "[rescue]\nleague = \"maze\"", "league: expected"},
      {straight + "[rescue]\ncheckpoints = \"1 m\"",
       "checkpoints: expected a list of lengths along the first path"},
      {straight + "[rescue]\ncheckpoints = [\"1 m\"]", "a checkpoint: expected "},
      {straight + "[rescue]\ncheckpoints = [\"0.4 m\", \"0.2 m\"]",
       "checkpoints: expected increasing lengths"},
      {straight + "[rescue]\nvictims = 3", "victims"},
      {"variation = \"31 %\"", "variation: expected 0 to 30 %, got 31 %"},
      {"paint = \"red\"", "paint: expected black on white or white on black"},
  };
  for (const Refused& one : refused)
    EXPECT_THAT(message_of(one.course), HasSubstr(one.message)) << one.course;
  EXPECT_THAT(message_of(path + "segments = [{ length = \"0.5 m\" }]\n[[mark]]\nalong = \"0.6 m\""),
              HasSubstr("m.map:7:9: along: expected 0 to 0.5 m, got 0.6"));
  EXPECT_THROW(parse_map("+++\n[[path]]\nfrom = [\"1 m\", \"1 m\"]\nsegments = [{ length = \"1 m\" }]\n+++\n",
                         "m.map"),
               InputError);
  EXPECT_THROW(parse_map("+++\nsize = [\"1000 m\", \"1000 m\"]\n+++\n", "m.map"), InputError);
  EXPECT_THROW(parse_map("+++\nsize = [\"1 m\", \"1 m\"]\n+++\n...\n", "m.map"), InputError);
}

}  // namespace robosim::map::path_test
