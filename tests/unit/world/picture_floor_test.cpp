// Tests maps whose floor is a picture: `floor = "NAME.png"`.
#include <gmock/gmock.h>

#include <cmath>

#include "sim/world/floor.h"
#include "tests/support/png_file.h"

namespace robosim::world::picture_floor_test {

const std::string kPath =
    "line = \"20 mm\"\nsize = [\"200 mm\", \"200 mm\"]\n[[path]]\nfrom = [\"0 mm\", \"101 mm\"]\n"
    "segments = [{ length = \"200 mm\" }]\n+++\n";

map::Map map_with(const std::string& picture) {
  return map::parse_map("+++\nfloor = \"floor.png\"\npixel = \"0.5 mm\"\n" + kPath, "my.map", picture);
}

// The picture shows the line of the path, from 91 to 111 mm above the floor's lower edge.
TEST(PictureFloor, SensorsSeeWhatIsDrawnAsTheyWouldSeeItPainted) {
  const map::Map drawn =
      map_with(test::grey_png(400, 400, [](int, int y) { return y >= 178 && y < 218 ? 0 : 255; }));
  const map::Map painted = map::parse_map("+++\n" + kPath, "my.map");
  const Floor a(drawn), b(painted);
  for (double y = 0.080; y < 0.125; y += 0.0003)
    for (const double footprint : {0.0005, 0.002, 0.008, 0.030}) {
      const Vec2 p{0.1, y};
      EXPECT_NEAR(a.darkness(p, footprint), b.darkness(p, footprint), 1e-9) << y;
      EXPECT_EQ(a.on_line(p, footprint), b.on_line(p, footprint));
      EXPECT_EQ(a.distance_to_line(p), b.distance_to_line(p));
    }
}

TEST(PictureFloor, ThePathIsFollowedButNotPainted) {
  const map::Map white = map_with(test::grey_png(400, 400, [](int, int) { return 255; }));
  const Floor floor(white);
  EXPECT_EQ(floor.darkness({0.1, 0.101}, 0.008), 0.0);
  EXPECT_EQ(floor.distance_to_line({0.1, 0.121}), 0.121 - 0.101);
}

TEST(PictureFloor, GreysAreSeenAsGreys) {
  const map::Map grey = map_with(test::grey_png(400, 400, [](int, int) { return 102; }));
  EXPECT_NEAR(Floor(grey).darkness({0.1, 0.1}, 0.008), 0.6, 1e-12);
}

}  // namespace robosim::world::picture_floor_test
