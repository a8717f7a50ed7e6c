// Tests the sketch PonyNavigator on the robot pony: it scans maps a to f, and then visits every station.
//
// Whenever the sketch reports a station, compares the station's position with the robot's true position.
// ROBOSIM_TEST_SEEDS=50 tries 50 seeds on each map, on the host and on the chips.

#include <cmath>

#include "sim/map/network.h"
#include "tests/system/command.h"
#include "tests/system/system_test.h"

namespace robosim::test {
namespace pony_test {

using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;

constexpr double kAtStation_mm = 80.0;  // the robot's front is 80 mm ahead of its axle

// Returns a script that scans, visits all stations one after another, and drives home.
std::string tour_script(std::size_t stations) {
  std::string script = "at 300ms press scan 100ms\nafter serial \"scan complete\" send radio 2\n";
  for (std::size_t at = 2; at <= stations; ++at)
    script += "after serial \"at station " + std::to_string(at) + "\\r\\n\" send radio " +
              std::to_string(at == stations ? 1 : at + 1) + "\n";
  return script;
}

// Observations from a run's events.
struct Watch {
  wire::Started started;
  wire::Sample last;
  std::vector<int> arrivals;
  std::int64_t arrived_us = 0;
  std::string text;
  double longest_beep_ms = 0.0;

  double reading(const std::string& name) const {
    for (std::size_t i = 0; i < started.readings.size(); ++i)
      if (started.readings[i] == name) return last.readings[i];
    return NAN;
  }
  int digits() const { return static_cast<int>(10 * std::max(0.0, reading("tens")) + reading("ones")); }
  double distance_to(const wire::Started::Station& station, const map::Map& map) const {
    const Vec2 centre = map.centre({station.x, station.y}) * 1e3;
    return std::hypot(last.x_mm - centre.x, last.y_mm - centre.y);
  }
};

// Observes all of the robot's output. A tour ends when the robot is home.
Watch watch(const Run& of) {
  client::Runner& runner = runner_of(of.target);
  const map::Map map = map::read_map(map::find_map(of.map));
  wire::RunRequest request = request_of(of);
  request.serial = true;
  request.samples_every_ns = 50'000'000;
  Watch watch;
  std::int64_t silent_since_us = 0;
  int arrived = 0;
  const auto look = [&](const wire::Sample& sample) {
    watch.last = sample;
    if (watch.reading("buzzer") == 0.0) silent_since_us = sample.t_us;
    const double beep_ms = static_cast<double>(sample.t_us - silent_since_us) * 1e-3;
    watch.longest_beep_ms = std::max(watch.longest_beep_ms, beep_ms);
    if (arrived == 0) return;
    EXPECT_EQ(watch.digits(), arrived);
    for (const auto& station : watch.started.stations) {
      if (station.id != arrived) continue;
      EXPECT_LT(watch.distance_to(station, map), kAtStation_mm) << "station " << arrived;
    }
    arrived = 0;
    if (watch.arrivals.size() > 1 && watch.arrivals.back() == 1) runner.interrupt();
  };
  const auto listen = [&](const std::string& line) {
    watch.text += line;
    watch.arrived_us = watch.last.t_us;
    if (std::sscanf(line.c_str(), "at station %d", &arrived) == 1) watch.arrivals.push_back(arrived);
  };
  runner.run(request, [&](const wire::Event& event) {
    if (const auto* started = std::get_if<wire::Started>(&event)) watch.started = *started;
    if (const auto* sample = std::get_if<wire::Sample>(&event)) look(*sample);
    if (const auto* serial = std::get_if<wire::SerialText>(&event)) listen(serial->text);
  });
  return watch;
}

class PonyNavigator : public testing::TestWithParam<Trial> {
 protected:
  void SetUp() override { needs_target(GetParam().target); }
};

INSTANTIATE_TEST_SUITE_P(On, PonyNavigator, testing::ValuesIn(trials({"a", "b", "c", "d", "e", "f"}, "b")),
                         name_of);

TEST_P(PonyNavigator, ScansTheMapAndThenVisitsEveryStation) {
  const auto [target, name] = GetParam();
  const map::Map map = map::read_map(map::find_map(name));
  const std::size_t stations = map::trace_network(map, map::default_start(map)).stations.size();
  std::vector<int> all;
  for (std::size_t at = 2; at <= stations; ++at) all.push_back(static_cast<int>(at));
  all.push_back(1);
  for (std::uint64_t seed = 1; seed <= seeds_of(GetParam()); ++seed) {
    const Watch seen = watch({.sketch = "PonyNavigator",
                              .map = name,
                              .robot = "pony",
                              .goal = "none",
                              .script = tour_script(stations),
                              .seed = seed,
                              .for_s = 3600.0,
                              .target = target});
    EXPECT_THAT(seen.text, HasSubstr("scan complete, stations: " + std::to_string(stations) + "\r\n"));
    EXPECT_EQ(seen.arrivals, all) << "map " << name << ", seed " << seed << "\n" << seen.text;
  }
}

// Runs the script on map c, which has 6 stations.
Watch play(const std::string& script, double for_s) {
  return watch({.sketch = "PonyNavigator",
                .map = "c",
                .robot = "pony",
                .goal = "none",
                .script = "at 300ms press scan 100ms\n" + script,
                .for_s = for_s});
}

TEST(PonyNavigatorSketch, RefusesWhatIsNoStationWithALongBeep) {
  const Watch seen = play(
      "after serial \"complete\" send radio 7\n"
      "after serial \"such station\" send radio 0b00000000\n"
      "at 130s send radio 0b0000010\n"
      "at 132s send radio 0b000000010\n"
      "at 134s send radio 255\n",
      140.0);
  EXPECT_THAT(seen.text,
              EndsWith("refused: no such station\r\nrefused: no such station\r\n"
                       "refused: not 8 bits\r\nrefused: not 8 bits\r\nrefused: no such station\r\n"));
  EXPECT_GT(seen.longest_beep_ms, 900);
}

TEST(PonyNavigatorSketch, RefusesADestinationBeforeItKnowsWhereItIs) {
  const Watch seen = watch({.sketch = "PonyNavigator",
                            .map = "c",
                            .robot = "pony",
                            .goal = "none",
                            .script = "at 1s send radio 2\nat 3s press station1 100ms\n",
                            .for_s = 5.0});
  EXPECT_EQ(seen.text, "ready\r\nrefused: where am I?\r\nno map: scan first\r\n");
}

TEST(PonyNavigatorSketch, FindsItsWayAfterAPowerCycleWhenToldThatThisIsStation1) {
  const Watch seen = play(
      "after serial \"complete, stations: 6\\r\\n\" power off 100ms\n"
      "after serial \"map in memory, stations: 6\" press station1 100ms\n"
      "after serial \"at station 1\" send radio 4\n",
      200.0);
  EXPECT_THAT(seen.arrivals, ElementsAre(1, 4)) << seen.text;
}

TEST(PonyNavigatorSketch, PausesWhileItsCollisionSensorIsPressed) {
  const std::string go = "after serial \"complete\" send radio 4\n";
  const Watch free = play(go, 200.0);
  const Watch held = play(go + "after serial \"to station 4\" press bumper 4s\n", 200.0);
  EXPECT_THAT(held.arrivals, ElementsAre(4)) << held.text;
  EXPECT_NEAR(static_cast<double>(held.arrived_us - free.arrived_us) * 1e-6, 4.0, 0.5);
}

TEST(PonyNavigatorSketch, TurnsBackBeforeWhatStaysInTheWayAndSaysSo) {
  const Watch seen = play(
      "after serial \"complete\" send radio 4\n"
      "at 115s press bumper 8s\n"
      "after serial \"no way\" send radio 2\n",
      300.0);
  EXPECT_THAT(seen.text, EndsWith("to station 4\r\nno way: there is an obstacle\r\nto station 2\r\n"
                                  "at station 2\r\n"));
}

TEST(PonyNavigatorSketch, TellsThatANetworkWithACircleIsNotForIt) {
  if (kSlow) GTEST_SKIP() << "too slow for this build: drives for many minutes";
  const Folder folder;
  const auto map = folder.write("circle.map",
                                "_____________\n"
                                "_____________\n"
                                "__S.......___\n"
                                "_____._._____\n"
                                "_____._._____\n"
                                "_____..._____\n"
                                "_____________\n");
  const Watch seen = watch({.sketch = "PonyNavigator",
                            .map = map.string(),
                            .robot = "pony",
                            .goal = "none",
                            .script = "at 300ms press scan 100ms\n",
                            .for_s = 3600.0});
  EXPECT_THAT(seen.text, EndsWith("too many nodes: is there a circle?\r\n"));
}

}  // namespace pony_test
}  // namespace robosim::test
