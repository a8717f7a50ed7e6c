#include "sim/view/terminal/graph_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/terminal/terminal_looks.h"

namespace robosim::terminal {
namespace graph_table_test {

using ::testing::ElementsAre;

map::TrueGraph graph_of(const char* text) {
  const map::Map map = map::parse_map(text, "test.map");
  return map::true_graph(map, map::default_start(map));
}

constexpr const char* kThreeWays = "_____\nS...G\n__.__\n";
constexpr const char* kRing = "_____\nS..._\n_._._\n_..._\n";

TEST(GraphTable, ATreeHasItsBranchesToTheRightHandFirst) {
  EXPECT_THAT(graph_lines(graph_of(kThreeWays), 80, kAscii),
              ElementsAre("S1 at 0,1", "`- east 2: J1 at 2,1", "   |- south 1: S2 at 2,2",
                          "   `- east 2: S3 goal at 4,1"));
}

TEST(GraphTable, AJunctionThatStandsAboveIsOnlyNamed) {
  EXPECT_THAT(graph_lines(graph_of(kRing), 80, kAscii),
              ElementsAre("S1 at 0,1", "`- east 1: J1 at 1,1", "   |- south 8: J1, see above",
                          "   `- east 8: J1, see above"));
}

TEST(GraphTable, WhatIsTooWideForATreeBecomesATable) {
  EXPECT_THAT(graph_lines(graph_of(kThreeWays), 20, kAscii),
              ElementsAre("S1 at 0,1: east 2 J1", "S2 at 2,2: north 1 J1", "S3 goal at 4,1: west 2 J1",
                          "J1 at 2,1: west 2 S1, south 1 S2, east 2 S3 goal"));
}

TEST(GraphTable, TheSummaryCountsAndNamesWhatCannotBeReached) {
  EXPECT_EQ(graph_summary(graph_of(kThreeWays)), "3 stations, 1 junction, 3 links; a tree");
  EXPECT_EQ(graph_summary(graph_of("S..__..\n")),
            "2 stations, 0 junctions, 1 link; a tree; unreachable: 2 dead ends (5,0 6,0)");
}

TEST(GraphTable, StationsAreMeantByNumberOrName) {
  const map::TrueGraph graph = graph_of(kThreeWays);
  EXPECT_EQ(find_station(graph, "2"), 2);
  EXPECT_EQ(find_station(graph, "S2"), 2);
  EXPECT_EQ(find_station(graph, "goal"), 3);
  for (const char* wrong : {"", "0", "4", "-1", "S", "2x", "99999999999", "J1"})
    EXPECT_EQ(find_station(graph, wrong), 0) << wrong;
}

}  // namespace graph_table_test
}  // namespace robosim::terminal
