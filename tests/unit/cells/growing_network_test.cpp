#include "sim/map/cells/growing_network.h"

#include <gtest/gtest.h>

#include <vector>

#include "sim/base/noise.h"

namespace robosim::cells {
namespace growing_network_test {

TEST(GrowingNetworkTest, FindsEachJunctionByItsPlaceAndKnowsItsHeadings) {
  GrowingNetwork network;
  const NoiseStream chance(1, 0, "dice", "network");
  std::uint64_t drawn = 0;
  const auto below = [&](unsigned n) { return static_cast<unsigned>(chance.bits(drawn++) % n); };
  std::vector<nav::Place> places;
  GrowingNetwork::Id last = GrowingNetwork::kNone;
  for (int n = 0; n < 5000; ++n) {
    const nav::Place place{static_cast<std::int32_t>(below(400)), static_cast<std::int32_t>(below(300))};
    GrowingNetwork::Id expected = GrowingNetwork::kNone;
    for (std::size_t i = 0; i < places.size(); ++i)
      if (places[i].x == place.x && places[i].y == place.y) expected = static_cast<GrowingNetwork::Id>(i);
    ASSERT_EQ(network.find(place), expected) << n;
    if (expected != GrowingNetwork::kNone) continue;
    const auto entry = static_cast<nav::Heading>(below(4));
    const auto arms = static_cast<std::uint8_t>(below(16) | 1u << nav::opposite(entry));
    last = network.addJunction(last, last == GrowingNetwork::kNone ? 0 : 3, arms, entry, place, 1);
    ASSERT_EQ(last, places.size());
    places.push_back(place);
    for (std::uint8_t slot = 0; slot < nav::slotCount(arms); ++slot)
      ASSERT_EQ(network.heading(last, slot), nav::headingOf(arms, entry, slot)) << int{arms};
  }
  EXPECT_GT(places.size(), 4500u);
  network.clear();
  EXPECT_EQ(network.find(places[0]), GrowingNetwork::kNone);
}

}  // namespace growing_network_test
}  // namespace robosim::cells
