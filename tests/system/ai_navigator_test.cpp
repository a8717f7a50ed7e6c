// Tests the sketch AiNavigator on the robot uno5: the robot scans a map, and then drives to every requested
// station.
//
// Whenever the sketch prints that it has arrived at a station, compares the station's position with the
// robot's true position. ROBOSIM_TEST_SEEDS=50 tries 50 seeds on each map, on the host and on the chips.

#include <cmath>

#include "sim/map/true_graph.h"
#include "tests/support/effort.h"
#include "tests/system/system_test.h"

namespace robosim::test {
namespace ai_navigator_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

constexpr double kAtStation_mm = 25.0;  // largest distance of the axle's centre from the end of the line

map::TrueGraph graph_of(const std::string& map_name, const std::string& start = "") {
  const map::Map map = map::read_map(map::find_map(map_name));
  return map::true_graph(map, start.empty() ? map::default_start(map) : map::parse_start(map, start));
}

// Observations of a run.
struct Seen {
  std::string text;           // the sketch's output, without CR
  std::vector<int> arrivals;  // stations that the sketch prints after "arrived at"
  int collisions = 0;
  double time_s = 0.0;
  std::string verdict;
  std::string trace_hash;
};

const std::string kScan = "at 300ms press start 100ms\n";

// Runs until the sketch has printed the line `until`, then interrupts the run.
Seen watch(const Run& of, const std::string& until, const std::string& start = "") {
  client::Runner& runner = runner_of(of.target);
  const map::Map map = map::read_map(map::find_map(of.map));
  const map::TrueGraph graph = graph_of(of.map, start);
  wire::RunRequest request = request_of(of);
  request.start = start;
  request.serial = true;
  request.samples_every_ns = 10'000'000;
  Seen seen;
  wire::Sample last;
  const result::RunResult result = runner.run(request, [&](const wire::Event& event) {
    if (const auto* sample = std::get_if<wire::Sample>(&event)) last = *sample;
    const auto* serial = std::get_if<wire::SerialText>(&event);
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
  seen.trace_hash = result.trace_hash;
  return seen;
}

std::string send_after(const std::string& text, const std::string& line) {
  return "after serial \"" + text + "\" send \"" + line + "\\n\"\n";
}

class AiNavigator : public testing::TestWithParam<Trial> {
 protected:
  void SetUp() override { needs_target(GetParam().target); }
};

INSTANTIATE_TEST_SUITE_P(
    On, AiNavigator,
    testing::ValuesIn(trials({"a", "b", "c", "d", "e", "f", "warehouse", "city", "blocked"}, "b")), name_of);

TEST_P(AiNavigator, ScansTheMapAndThenVisitsEveryStation) {
  const auto [target, map] = GetParam();
  const map::TrueGraph graph = graph_of(map);
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
  for (std::uint64_t seed = 1; seed <= seeds_of(GetParam()); ++seed) {
    const Seen seen = watch({.sketch = "AiNavigator",
                             .map = map,
                             .robot = "uno5",
                             .goal = "none",
                             .script = script,
                             .seed = seed,
                             .target = target},
                            "arrived at 1");
    EXPECT_THAT(seen.text, HasSubstr(found));
    EXPECT_EQ(seen.arrivals, all) << "map " << map << ", seed " << seed << "\n" << seen.text;
    EXPECT_EQ(seen.verdict, "interrupted") << seen.time_s << " s";
    if (std::string(map) != "blocked") {
      EXPECT_EQ(seen.collisions, 0);
    }
  }
}

Seen watch(const std::string& map, const std::string& script, const std::string& until) {
  return watch({.sketch = "AiNavigator", .map = map, .goal = "none", .script = script}, until);
}

TEST(AiNavigatorsDestinations, AreNumbersOrNamesAndTheRestIsRefusedWithTheList) {
  const std::string list = "refused. Stations: 1 home, 2 dock, 3 shelf, 4\n";
  std::string script = kScan;
  int second = 60;
  for (const char* word : {"", "0", "5", "2x", "-1", "65537", "Home", "much too long a word for it", "dock"})
    script += "at " + std::to_string(second++) + "s send \"" + word + "\\r\\n\"\n";
  script += send_after("arrived at 2", "home");
  const Seen seen = watch("b", script, "arrived at 1");
  EXPECT_THAT(seen.arrivals, ElementsAre(2, 1)) << seen.text;
  std::size_t refusals = 0;
  for (std::size_t at = 0; (at = seen.text.find(list, at)) != std::string::npos; ++at) ++refusals;
  EXPECT_EQ(refusals, 7u) << seen.text;
  EXPECT_THAT(seen.text, HasSubstr("way: junction 1 straight, junction 2 right, station 2\n"));
}

TEST(AiNavigatorsDestinations, AreRefusedBeforeItHasScanned) {
  const Seen seen = watch("b", "at 1s send \"2\\n\"\n", "refused: I do not know where I am.");
  EXPECT_EQ(seen.verdict, "interrupted");
}

TEST(AiNavigatorsMap, OutlastsAPowerCycleAtAStation) {
  const Seen seen =
      watch("c",
            kScan + send_after("at 1\\r\\n", "4") + "after serial \"arrived at 4\" power off 100ms\n" +
                send_after("I have a map: 6 stations, 4 junctions\\r\\nat 4", "2") +
                send_after("arrived at 2", "1"),
            "arrived at 1");
  EXPECT_THAT(seen.arrivals, ElementsAre(4, 2, 1)) << seen.text;
}

TEST(AiNavigatorsMap, IsNoUseAfterAPowerCycleUnderWay) {
  const Seen seen = watch("c",
                          kScan + send_after("at 1\\r\\n", "4") + "after serial \"way:\" power off 2s\n" +
                              "after serial \"I was switched off under way.\" press start 100ms\n" +
                              send_after("under way.\\r\\nPut me on a line and press the button: I will "
                                         "scan.\\r\\nscanning",
                                         "3"),
                          "going to 3");
  EXPECT_THAT(seen.text, HasSubstr("I do not know where I am: I was switched off under way.\n"
                                   "Put me on a line and press the button: I will scan.\nscanning"));
}

TEST(AiNavigatorsMap, IsNoUseIfThePowerFailedWhileItWasStored) {
  const Seen seen = watch("c", kScan + "after serial \" s\\r\\n\" power off 100ms\n", "My map is damaged.");
  EXPECT_EQ(seen.verdict, "interrupted") << seen.text;
}

TEST(AiNavigatorsMap, IsNotTrustedIfTheRobotWasMoved) {
  const Seen seen = watch("c",
                          kScan + "after serial \"at 1\\r\\n\" power off 100ms\n" +
                              "after serial \"I have a map\" place 6,9,E\n" +
                              send_after("I have a map: 6 stations, 4 junctions\\r\\nat 1", "2"),
                          "Put me on a line and press the button: I will scan.");
  EXPECT_THAT(seen.text, Not(HasSubstr("arrived")));
}

TEST(AiNavigatorsBumper, PausesTheRobotUntilTheWayIsFree) {
  const Seen seen = watch(
      "b", kScan + send_after("at 1\\r\\n", "2") + "after serial \"way:\" press bumper 2s\n", "arrived at 2");
  EXPECT_THAT(seen.text, HasSubstr("collision: waiting\ngoing on\narrived at 2"));
}

TEST(AiNavigatorsBumper, TurnsTheRobotBackIfTheBumperStaysPressedAndNoOtherPathExists) {
  const Seen seen = watch(
      "b", kScan + send_after("at 1\\r\\n", "2") + "after serial \"way:\" press bumper 6s\n", "no way to 2");
  EXPECT_THAT(seen.text, HasSubstr("an obstacle: going back\n"));
  EXPECT_THAT(seen.arrivals, ElementsAre()) << seen.text;
}

// Presses the bumper at a node, soon after it, at bends, and before the next node. At some of these places,
// the robot sees no line while it turns back.
TEST(AiNavigatorsBumper, LeadsTheRobotBackFromAnyPlaceOnThePath) {
  for (int moment = 0; moment < 12; moment += 12 / rounds(12)) {
    const Seen seen = watch("d",
                            kScan + "at 130s send \"4\\n\"\nat " + std::to_string(130100 + 530 * moment) +
                                "ms press bumper 6s\n" + send_after("no way to 4", "1"),
                            "arrived at 1");
    EXPECT_THAT(seen.arrivals, ElementsAre(1)) << "moment " << moment << "\n" << seen.text;
  }
}

struct Beginning {
  const char* name;
  const char* map;
  const char* start;
};

class AiNavigatorsStart : public testing::TestWithParam<Beginning> {};

INSTANTIATE_TEST_SUITE_P(At, AiNavigatorsStart,
                         testing::Values(Beginning{"MidLine", "c", "6,9,E"},
                                         Beginning{"MidLineTheOtherWay", "c", "6,9,W"},
                                         Beginning{"AStationFacingOutward", "c", "4,9,W"},
                                         Beginning{"AJunction", "warehouse", "13,8,E"},
                                         Beginning{"AJunctionFacingNoLine", "warehouse", "10,14,E"},
                                         Beginning{"ACrossing", "city", "11,11,N"}),
                         [](const auto& at) { return std::string(at.param.name); });

TEST_P(AiNavigatorsStart, DoesNotMatter) {
  const auto [name, map, start] = GetParam();
  const map::TrueGraph graph = graph_of(map, start);
  const int stations = static_cast<int>(graph.stations.size());
  std::string script = kScan;
  std::vector<int> all;
  for (int at = 1; at <= stations; ++at) {
    script +=
        send_after(at == 1 ? "destination?" : "arrived at " + std::to_string(at - 1), std::to_string(at));
    all.push_back(at);
  }
  const Seen seen = watch({.sketch = "AiNavigator", .map = map, .goal = "none", .script = script},
                          "arrived at " + std::to_string(stations), start);
  EXPECT_EQ(seen.arrivals, all) << seen.text;
  EXPECT_THAT(seen.text, HasSubstr("scan complete: " + std::to_string(stations) + " stations, " +
                                   std::to_string(graph.junctions.size()) + " junctions"));
}

}  // namespace ai_navigator_test
}  // namespace robosim::test
