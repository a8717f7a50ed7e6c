// The sketch AiNavigator on the robot uno5: it scans a map, and then drives to every station it is told.
//
// What it says is compared with what is: where the robot stands when it says that it has arrived.
// ROBOSIM_TEST_SEEDS=50 tries so many seeds on each map.

#include <stdlib.h>

#include <cmath>

#include "sim/grid/true_graph.h"
#include "tests/system/system_test.h"

namespace robosim::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

constexpr double kAtStation_mm = 25.0;  // of the axle's centre from the end of the line

std::uint64_t seeds() {
  const char* text = ::getenv("ROBOSIM_TEST_SEEDS");
  return text ? std::strtoull(text, nullptr, 10) : 2;
}

grid::TrueGraph graph_of(const std::string& map_name) {
  const grid::Map map = grid::read_map(grid::find_map(map_name));
  return grid::true_graph(map, grid::default_start(map));
}

// What a run has shown.
struct Seen {
  std::string text;           // what the sketch said, without CR
  std::vector<int> arrivals;  // "arrived at"
  int collisions = 0;
  double time_s = 0.0;
  std::string verdict;
};

const std::string kScan = "at 300ms press start 100ms\n";

// Interrupts the run when it has said the line `until`.
Seen watch(const Run& of, const std::string& until) {
  static client::Runner runner("host");
  const grid::Map map = grid::read_map(grid::find_map(of.map));
  const grid::TrueGraph graph = grid::true_graph(map, grid::default_start(map));
  client::RunRequest request = request_of(of);
  request.serial = true;
  request.samples_every_ns = 10'000'000;
  Seen seen;
  client::Sample last;
  const client::RunResult result = runner.run(request, [&](const client::Event& event) {
    if (const auto* sample = std::get_if<client::Sample>(&event)) last = *sample;
    const auto* serial = std::get_if<client::SerialText>(&event);
    if (!serial) return;
    const std::string line = serial->text.substr(0, serial->text.find_last_not_of("\r\n") + 1);
    seen.text += line + "\n";
    if (line == until) runner.interrupt();
    int number = 0;
    if (std::sscanf(line.c_str(), "arrived at %d", &number) != 1) return;
    seen.arrivals.push_back(number);
    ASSERT_LE(static_cast<std::size_t>(number), graph.stations.size());
    const Vec2 centre = map.centre(graph.stations[static_cast<std::size_t>(number) - 1].cell) * 1e3;
    EXPECT_LT(std::hypot(last.x_mm - centre.x, last.y_mm - centre.y), kAtStation_mm)
        << "station " << number << " of map " << of.map << ", seed " << of.seed;
  });
  seen.collisions = result.metrics.collisions;
  seen.time_s = result.time_s;
  seen.verdict = result.verdict;
  return seen;
}

std::string send_after(const std::string& text, const std::string& line) {
  return "after serial \"" + text + "\" send \"" + line + "\\n\"\n";
}

class AiNavigator : public testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(On, AiNavigator,
                         testing::Values("a", "b", "c", "d", "e", "f", "warehouse", "city", "blocked"),
                         [](const auto& map) { return std::string(map.param); });

TEST_P(AiNavigator, ScansTheMapAndThenVisitsEveryStation) {
  const grid::TrueGraph graph = graph_of(GetParam());
  const int stations = static_cast<int>(graph.stations.size());
  std::string script = kScan + send_after("at 1\\r\\n", "2");
  std::vector<int> all;
  for (int at = 2; at <= stations; ++at) {
    script += send_after("arrived at " + std::to_string(at) + "\\r\\n", std::to_string(at % stations + 1));
    all.push_back(at);
  }
  all.push_back(1);
  const std::string found = "scan complete: " + std::to_string(stations) + " stations, " +
                            std::to_string(graph.junctions.size()) + " junction";
  for (std::uint64_t seed = 1; seed <= seeds(); ++seed) {
    const Seen seen =
        watch({.sketch = "AiNavigator", .map = GetParam(), .goal = "none", .script = script, .seed = seed},
              "arrived at 1");
    EXPECT_THAT(seen.text, HasSubstr(found));
    EXPECT_EQ(seen.arrivals, all) << "map " << GetParam() << ", seed " << seed << "\n" << seen.text;
    EXPECT_EQ(seen.verdict, "interrupted") << seen.time_s << " s";
    if (std::string(GetParam()) != "blocked") {
      EXPECT_EQ(seen.collisions, 0);
    }
  }
}

}  // namespace
}  // namespace robosim::test
