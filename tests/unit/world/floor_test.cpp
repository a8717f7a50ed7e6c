#include "sim/world/floor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "maps.h"
#include "tests/support/effort.h"

namespace robosim::world::floor_test {

struct Random {
  unsigned state = 1;
  double operator()() {
    state = state * 1664525u + 1013904223u;
    return (state >> 8) * 0x1p-24;
  }
};

map::Map random_map(Random& random, bool raster, double corner) {
  std::vector<std::string> rows(11, std::string(14, ' '));
  for (std::string& row : rows) {
    for (char& c : row) {
      const double r = random();
      c = r < 0.55 ? ' ' : r < 0.85 ? '.' : r < 0.92 ? 'o' : r < 0.96 ? 'x' : '#';
    }
  }
  map::Map map = map_of(rows);
  map.raster = raster;
  map.corner_m = corner;
  return map;
}

// Returns a map like a real floor: it has few lines, which are long and bend.
map::Map bends(double corner) {
  map::Map map = map_of({"                ", " .............. ", " .            . ", " .  .....     . ",
                         " .  .   .  oo... ", " .  .   .  .    ", " .  .   ....    ", " .  .           ",
                         " ....           ", "                "});
  map.corner_m = corner;
  return map;
}

// Returns a figure eight of arcs and of slanted straights, which cross.
map::Map eight_of_arcs() {
  return map::parse_map(R"(+++
line = "19 mm"
size = ["2.8 m", "1.4 m"]
[[path]]
from = ["1.4 m", "700 mm"]
heading = "30 deg"
segments = [
  { length = "519.6152422706632 mm" }, { radius = "300 mm", angle = "-240 deg" }, { length = "1039.2304845413264 mm" },
  { radius = "300 mm", angle = "240 deg" }, { length = "519.6152422706632 mm" },
]
+++
)",
                        "eight.map");
}

double brute_distance(const map::Stripes& stripes, Vec2 p, bool painted_only) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const map::Stripe& s : stripes.all()) {
    if (s.painted || !painted_only) nearest = std::min(nearest, map::distance(s, p));
  }
  return nearest;
}

void expect_exact(const map::Map& map, Random& random) {
  const Floor floor(map);
  const map::Stripes stripes(map, 0.01);
  for (int i = 0; i < 3000; ++i) {
    const Vec2 p{(random() * 1.1 - 0.05) * map.width * map.cell_m,
                 (random() * 1.1 - 0.05) * map.height * map.cell_m};
    const double truth = brute_distance(stripes, p, false);
    if (truth <= floor.far_m()) {
      ASSERT_NEAR(floor.distance_to_line(p), truth, 1e-12) << p.x << ", " << p.y;
    } else {
      ASSERT_GE(floor.distance_to_line(p), floor.far_m());
    }
    for (const double f : {0.0, 0.002, 0.006, 0.015, 0.03, 0.1, 0.25}) {
      const double footprint = std::max(f, 1e-9);
      const double d = brute_distance(stripes, p, true);
      const double share = (map.line_m / 2 + footprint / 2 - d) / footprint;
      // Without a footprint, coverage jumps at the stripe's border.
      if (f == 0.0 && std::fabs(d - map.line_m / 2) < 1e-8) continue;
      const double most = std::min(map.line_m / footprint, 1.0);
      ASSERT_NEAR(floor.on_line(p, f), std::max(std::min(share, most), 0.0), 1e-9)
          << p.x << ", " << p.y << " f " << f;
    }
  }
}

TEST(Floor, DistanceAndCoverageAreExactOverRandomMaps) {
  Random random;
  for (int round = 0; round < 20; ++round) expect_exact(random_map(random, false, 0.0), random);
}

TEST(Floor, DistanceAndCoverageAreExactOverRoundedBends) {
  Random random;
  for (const double corner : {0.02, 0.05, 0.1, 0.15, 0.25}) {
    expect_exact(bends(corner), random);
    for (int round = 0; round < test::rounds(4); ++round)
      expect_exact(random_map(random, false, corner), random);
  }
}

// Moves a point with steps of all lengths, also beyond the map's edge. Results with and without a remembered
// stripe must be bit-identical.
TEST(Floor, WhoRemembersTheNearestStripeFindsTheSame) {
  Random random;
  for (int i = 0; i < 24; ++i) {
    map::Map map = i % 3 == 0   ? eight_of_arcs()
                   : i % 3 == 1 ? bends(0.02 + 0.004 * i)
                                : random_map(random, i % 8 == 7, 0.02);
    map.light_line = i % 3 == 0;
    const Floor floor(map);
    const double footprint = 0.002 + 0.003 * (i % 6), width = map.width * map.cell_m,
                 height = map.height * map.cell_m;
    const FloorProbe of_line, of_footprint(footprint);
    Vec2 p{0.5 * width, 0.5 * height}, step;
    for (int k = 0; k < 20000; ++k) {
      if (k % 50 == 0) {
        const double stride = std::pow(10.0, -6.0 + 4.5 * random());
        step = {stride * (random() - 0.5), stride * (random() - 0.5)};
      }
      p = p + step;
      if (k % 500 == 0 || p.x < -0.1 || p.y < -0.1 || p.x > width + 0.1 || p.y > height + 0.1)
        p = {random() * width, random() * height};
      ASSERT_EQ(floor.distance_to_line(p, of_line), floor.distance_to_line(p)) << p.x << ", " << p.y;
      ASSERT_EQ(floor.darkness(p, of_footprint), floor.darkness(p, footprint)) << p.x << ", " << p.y;
      ASSERT_EQ(floor.on_line(p, of_footprint), floor.on_line(p, footprint));
    }
  }
}

TEST(Floor, AnEmptyFloorIsWhiteAndFarFromAnyLine) {
  const map::Map map = empty_map(30, 30);
  const Floor floor(map);
  EXPECT_EQ(floor.on_line({1.5, 1.5}, 0.003), 0.0);
  EXPECT_EQ(floor.on_line({-5.0, 99.0}, 0.003), 0.0);
  EXPECT_GE(floor.distance_to_line({1.5, 1.5}), floor.far_m());
  EXPECT_GE(floor.distance_to_line({-1e9, 1e9}), floor.far_m());
}

// Returns the exact share of a disc on the dark side of a straight edge. x is the distance of the disc's
// centre from the edge, and is positive on the dark side.
double disc_share(double x, double radius) {
  const double h = std::max(std::min(x / radius, 1.0), -1.0);
  return (std::asin(h) + h * std::sqrt(1.0 - h * h)) / 3.14159265358979323846 + 0.5;
}

TEST(Floor, CoverageIsWithin26ThousandthsOfTheShareOfADiscOfThatArea) {
  const map::Map map = map_of({"     ", ".....", "     "});
  const Floor floor(map);
  double worst = 0.0;
  for (const double f : {0.001, 0.003, 0.006, 0.012}) {
    for (int i = -300; i <= 300; ++i) {
      const double x = i / 300.0 * f;
      worst = std::max(worst, std::fabs(floor.on_line({0.25, 0.15 + 0.010 - x}, f) -
                                        disc_share(x, f / std::sqrt(3.14159265358979323846))));
    }
  }
  EXPECT_LT(worst, 0.026);
  EXPECT_GT(worst, 0.02);
}

TEST(Floor, AFootprintWiderThanTheLineSeesBothItsEdges) {
  const map::Map map = map_of({"     ", ".....", "     "});
  const Floor floor(map);
  for (const double f : {0.02, 0.025, 0.04}) {
    for (int i = -40; i <= 40; ++i) {
      const double x = i * 0.001;
      const double below = std::max(x - f / 2, -map.line_m / 2), above = std::min(x + f / 2, map.line_m / 2);
      EXPECT_NEAR(floor.on_line({0.25, 0.15 + x}, f), std::max(above - below, 0.0) / f, 1e-9) << f << x;
    }
  }
}

TEST(Floor, AVariedFloorHasPatchesOfThatSpreadAndSizeAndAnEvenOneHasNone) {
  const map::Map map = empty_map(30, 30);
  Floor floor(map);
  EXPECT_EQ(floor.brightness({1.234, 0.567}), 1.0);
  floor.vary(NoiseStream(1, 0, "floor", "brightness"), 0.05);
  double sum = 0.0, squares = 0.0, beside[3] = {};
  constexpr double kApart[] = {0.001, 0.005, 0.02};
  int count = 0;
  Random random;
  for (int i = 0; i < 40000; ++i, ++count) {
    const Vec2 p{random() * 3.0, random() * 3.0};
    const double v = floor.brightness(p) - 1.0;
    sum += v;
    squares += v * v;
    for (int k = 0; k < 3; ++k) beside[k] += v * (floor.brightness(p + Vec2{kApart[k], 0.0}) - 1.0);
  }
  EXPECT_NEAR(sum / count, 0.0, 0.001);
  EXPECT_NEAR(std::sqrt(squares / count), 0.05, 0.002);
  EXPECT_GT(beside[0] / squares, 0.95);
  EXPECT_NEAR(beside[1] / squares, 0.6, 0.1) << "5 mm apart";
  EXPECT_NEAR(beside[2] / squares, 0.0, 0.05) << "20 mm apart";
  const double here = floor.brightness({1.0, 1.0});
  floor.vary(NoiseStream(2, 0, "floor", "brightness"), 0.05);
  EXPECT_NE(floor.brightness({1.0, 1.0}), here) << "another seed gives another floor";
}

TEST(Floor, ARasterFloorIsTheExactAverageOverASquare) {
  Random random;
  for (int round = 0; round < 10; ++round) {
    const map::Map map = random_map(random, true, round % 2 ? 0.05 : 0.0);
    const Floor floor(map);
    for (int i = 0; i < 500; ++i) {
      const Vec2 p{(random() * 1.2 - 0.1) * 1.4, (random() * 1.2 - 0.1) * 1.1};
      const double f = i % 5 == 0 ? 0.1 + random() * 0.3 : 0.001 + random() * 0.099;
      double dark = 0.0;
      for (int y = 0; y < map.height; ++y) {
        for (int x = 0; x < map.width; ++x) {
          const map::Cell cell = map.at({x, y});
          if (cell != map::Cell::line && cell != map::Cell::obstacle) continue;
          const Vec2 c = map.centre({x, y});
          const double w = std::min(p.x + f / 2, c.x + 0.05) - std::max(p.x - f / 2, c.x - 0.05);
          const double h = std::min(p.y + f / 2, c.y + 0.05) - std::max(p.y - f / 2, c.y - 0.05);
          dark += std::max(w, 0.0) * std::max(h, 0.0);
        }
      }
      ASSERT_NEAR(floor.on_line(p, f), dark / (f * f), 1e-9) << p.x << ", " << p.y << " f " << f;
    }
  }
}

// The reference counts the marked points of a fine grid over the footprint.
TEST(Marks, ShareOfAFootprintIsTheAreaThatTheyCover) {
  const map::Map map = map::parse_map(
      "+++\nsize = [\"1 m\", \"1 m\"]\nline = \"1 mm\"\n[[path]]\nfrom = [\"100 mm\", \"500 mm\"]\n"
      "segments = [{ length = \"800 mm\" }]\n"
      "[[mark]]\nalong = \"400 mm\"\nwidth = \"19 mm\"\n[[mark]]\nalong = \"420 mm\"\nside = "
      "\"right\"\n+++\n",
      "m.map");
  const Floor floor(map);
  const auto is_marked = [](Vec2 p) {
    const bool left = std::abs(p.x - 0.5) <= 0.0095 && std::abs(p.y - 0.57) <= 0.02;
    const bool right = std::abs(p.x - 0.52) <= 0.0005 && std::abs(p.y - 0.43) <= 0.02;
    return left || right;
  };
  constexpr double kFootprint = 0.006;
  int counted = 0;
  for (double x = 0.47; x < 0.54; x += 0.0013)
    for (double y = 0.40; y < 0.60; y += 0.0017) {
      if (std::abs(y - 0.5) < 0.02) continue;
      double share = 0.0;
      for (int i = 0; i < 60; ++i)
        for (int j = 0; j < 60; ++j)
          share +=
              is_marked(Vec2{x, y} + Vec2{(i + 0.5) / 60 - 0.5, (j + 0.5) / 60 - 0.5} * kFootprint) / 3600.0;
      ASSERT_NEAR(floor.darkness({x, y}, kFootprint), share, 0.018) << x << " " << y;
      EXPECT_EQ(floor.on_line({x, y}, kFootprint), 0.0) << "a mark is no line";
      counted += share > 0.0;
    }
  EXPECT_GT(counted, 100);
}

// The reference checks every mark. The floor checks only the marks that its index finds nearby.
TEST(Marks, AreSeenFromEverywhereBesideLinesOfOneKindOrOfSeveral) {
  const auto course = [](const std::string& of_one_bend) {
    std::string text =
        "+++\ncell = \"20 mm\"\nsize = [\"3 m\", \"3 m\"]\n[[path]]\nfrom = [\"600 mm\", \"600 "
        "mm\"]\nheading = \"20 deg\"\n"
        "segments = [";
    for (int i = 0; i < 4; ++i)
      text += "{ length = \"1.1 m\" }, { radius = \"150 mm\", angle = \"90 deg\"" +
              (i == 0 ? of_one_bend : std::string()) + " }, ";
    text += "]\n";
    for (int i = 0; i < 48; ++i)
      text += "[[mark]]\nalong = \"" + std::to_string(5 + 110 * i) + " mm\"\nside = \"" +
              (i % 2 ? "left" : "right") + "\"\nlength = \"" + std::to_string(20 + 3 * i) +
              " mm\"\nwidth = \"" + std::to_string(4 + 2 * i) + " mm\"\n";
    return map::parse_map(text + "+++\n", "m.map");
  };
  const map::Map alike = course(""), several = course(", colour = \"grey 99 %\"");
  ASSERT_EQ(alike.course.marks.size(), 48u);
  const Floor floor(alike), with_grey(several);
  const auto share = [](double away, double half, double f) {
    return std::max(std::min(away + f / 2, half) - std::max(away - f / 2, -half), 0.0) / f;
  };
  Random random;
  int marked = 0;
  for (int i = 0; i < 60'000; ++i) {
    const Vec2 p{3.0 * random(), 3.0 * random()};
    const double f = i % 10 == 0 ? 0.03 : 0.016 * random() + 1e-6;
    double on_mark = 0.0;
    for (const map::Mark& mark : alike.course.marks) {
      const Vec2 own = mark.middle.to_body(p);
      on_mark = std::max(on_mark, share(own.x, mark.half_length, f) * share(own.y, mark.half_width, f));
    }
    const double line = floor.on_line(p, f);
    ASSERT_EQ(floor.darkness(p, f), std::max(line, on_mark)) << p.x << ", " << p.y << " f " << f;
    if (line == 0.0) {
      ASSERT_NEAR(with_grey.darkness(p, f), on_mark, 1e-12) << p.x << ", " << p.y << " f " << f;
    }
    marked += on_mark > line;
  }
  EXPECT_GT(marked, 2'000);
}

TEST(Floor, OfALightLineIsDarkBesideIt) {
  const std::string course =
      "size = [\"1 m\", \"1 m\"]\n[[path]]\nfrom = [\"100 mm\", \"500 mm\"]\nsegments = [{ length = \"800 "
      "mm\" }]\n+++\n";
  const map::Map light = map::parse_map("+++\npaint = \"white on black\"\n" + course, "m.map");
  const map::Map dark = map::parse_map("+++\n" + course, "m.map");
  const Floor on_light(light), on_dark(dark);
  for (double y = 0.45; y < 0.55; y += 0.001) {
    EXPECT_DOUBLE_EQ(on_light.darkness({0.5, y}, 0.006), 1.0 - on_dark.darkness({0.5, y}, 0.006));
    EXPECT_EQ(on_light.on_line({0.5, y}, 0.006), on_dark.on_line({0.5, y}, 0.006));
  }
  EXPECT_EQ(on_light.darkness({0.5, 0.5}, 0.006), 0.0);
  EXPECT_EQ(on_light.darkness({0.5, 0.2}, 0.006), 1.0);
}

}  // namespace robosim::world::floor_test
