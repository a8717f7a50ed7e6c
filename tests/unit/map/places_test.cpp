#include "sim/map/places.h"

#include <gtest/gtest.h>

namespace robosim::map::places_test {

// Returns the map 1 - J - 3 with station 2 below J. From J, stations 1 and 3 are four cells away, and station
// 2 three cells.
const Map& tee() {
  static const Map map = parse_map(
      "___________\n"
      "_S........_\n"
      "_____._____\n"
      "_____._____\n"
      "_____._____\n"
      "___________\n",
      "tee.map");
  return map;
}

std::string at(double column, double row) {
  const Places places(tee(), default_start(tee()));
  return places.at({(column + 0.5) * 0.1, (5 - row + 0.5) * 0.1});
}

TEST(Places, TheNearestAlongTheLineCounts) {
  EXPECT_EQ(at(1, 1), "station 1");
  EXPECT_EQ(at(2.6, 1.2), "station 1");
  EXPECT_EQ(at(3.4, 0.8), "junction 1");
  EXPECT_EQ(at(5, 2), "junction 1");
  EXPECT_EQ(at(5, 3), "station 2");
  EXPECT_EQ(at(5, 4.4), "station 2") << "beyond the line's end";
  EXPECT_EQ(at(9, 1), "station 3");
}

TEST(Places, BetweenTwoThereIsNone) {
  EXPECT_EQ(at(3, 1), "");
  EXPECT_EQ(at(3.2, 1), "");
  EXPECT_EQ(at(2.8, 1), "");
}

TEST(Places, APlaceThatIsNearAsTheCrowFliesButFarAlongTheLineDoesNotCount) {
  const Map map = parse_map(
      "_____________\n"
      "_S.........._\n"
      "___________._\n"
      "___________._\n"
      "_____......._\n"
      "_____________\n",
      "hairpin.map");
  const Places places(map, default_start(map));
  EXPECT_EQ(places.at(map.centre({5, 1})), "station 1");
  EXPECT_EQ(places.at(map.centre({5, 4})), "station 2");
}

TEST(Places, TheDistanceIsThatToTheLine) {
  const Places places(tee(), default_start(tee()));
  EXPECT_NEAR(places.cells_off({0.35, 0.45}), 0.0, 1e-9);
  EXPECT_NEAR(places.cells_off({0.33, 0.52}), 0.7, 1e-9);
  EXPECT_NEAR(places.cells_off({0.02, 0.45}), 1.3, 1e-9) << "the point is 1.3 cells from the line's end";
}

TEST(Places, ARingHasNone) {
  const Map map = parse_map("_____\n_S.._\n_._._\n_..._\n_____\n", "ring.map");
  EXPECT_EQ(Places(map, default_start(map)).at(map.centre({1, 1})), "");
}

}  // namespace robosim::map::places_test
