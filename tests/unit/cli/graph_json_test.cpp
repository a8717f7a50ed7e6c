// Tests the JSON of graphs and of `robosim classic`, with names that contain special characters.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "sim/cli/files/graph_text.h"
#include "sim/cli/run/classic_text.h"

namespace robosim::cli::graph_json_test {

constexpr const char* kOdd = "a \"quoted\" \\ name";

map::TrueGraph graph_of_one() {
  map::TrueGraph graph;
  graph.stations.push_back({{1, 2}, kOdd, {}});
  return graph;
}

TEST(GraphJson, IsLaidOutAnElementToALine) {
  EXPECT_EQ(graph_json({{1, 2}, map::Direction::east}, graph_of_one()), R"({
  "schema": "robosim.graph/1",
  "start": [1, 2, "E"],
  "stations": [
    {"id": 1, "x": 1, "y": 2, "name": "a \"quoted\" \\ name"}
  ],
  "junctions": [],
  "unreachable": [],
  "edges": []
}
)");
}

TEST(ClassicJson, HoldsAnyPathAndAnyName) {
  map::Map map;
  ClassicArguments arguments;
  arguments.algorithm = "sketches/my \"best\" one.cpp";
  arguments.speed = 1.5;
  arguments.trace = true;
  const std::vector<TapedMove> trace{{}};
  ClassicReport report{map, {}, arguments, cells::Scan(), {}, {}, trace};
  report.scan->graph = graph_of_one();
  const auto json = nlohmann::json::parse(classic_json(report));
  EXPECT_EQ(json["algorithm"], arguments.algorithm);
  EXPECT_EQ(json["speed"], 1.5);
  EXPECT_EQ(json["scan"]["stations"][0]["name"], kOdd);
  EXPECT_EQ(json["trace"][0].size(), 6u);
}

}  // namespace robosim::cli::graph_json_test
