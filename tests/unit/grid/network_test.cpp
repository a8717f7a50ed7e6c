#include "sim/grid/network.h"

#include <gmock/gmock.h>

#include <string>

#include "sim/base/file.h"

namespace robosim::grid {
namespace {


std::string order(const Network& network, const Map& map) {
  // Letters in row order, as the table of v1 names the dead ends of its sample.
  std::string text;
  std::vector<CellAt> ends;
  for (std::size_t i = 0; i < map.cells.size(); ++i) {
    const CellAt c = map.cell_at(i);
    if (!is_line(map.at(c))) continue;
    const unsigned lines = line_neighbours(map, c);
    if (lines != 0 && (lines & (lines - 1)) == 0) ends.push_back(c);
  }
  for (const Station& s : network.stations) {
    const auto found = std::find(ends.begin(), ends.end(), s.cell);
    text += found == ends.end() ? '?' : static_cast<char>('A' + (found - ends.begin()));
  }
  return text;
}

Network trace(const Map& map, const char* start) { return trace_network(map, parse_start(map, start)); }

// A network with the branches of v1's sample map: a trunk, a loop-free tree of five forks and seven ends.
TEST(Network, StationsAreNumberedByTheRightHandWalk) {
  const Map map = parse_map(
      "_______\n"
      "_.___._\n"
      "_.___._\n"
      "_....._\n"
      "___.___\n"
      "___.___\n"
      "_______\n",
      "fork.map");
  // A = 1,1  B = 5,1  C = 3,5
  EXPECT_EQ(order(trace(map, "1,1"), map), "ACB");
  EXPECT_EQ(order(trace(map, "5,1"), map), "BAC");
  EXPECT_EQ(order(trace(map, "3,5"), map), "CBA");
}

}  // namespace
}  // namespace robosim::grid
