// Tests random worlds. Generated worlds must be valid, and shrunk worlds must be valid and smaller. A search
// must end with the smallest world that fails.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/Random.h>
#include <rapidcheck/seq/Transform.h>  // the next header requires this one, but does not include it
#include <rapidcheck/shrinkable/Operations.h>
#include <robosim/random_worlds.h>

#include <algorithm>
#include <set>

#include "sim/base/error.h"
#include "sim/map/network.h"
#include "sim/map/true_graph.h"
#include "tests/support/caught_failures.h"
#include "tests/support/effort.h"

namespace robosim::testing {
namespace random_worlds_test {

using test::caught_failures;
using ::testing::HasSubstr;
using ::testing::MatchesRegex;

template <typename T>
rc::Shrinkable<T> draw(const rc::Gen<T>& any, std::uint64_t seed, int size = rc::kNominalSize) {
  return any(rc::Random(seed), size);
}

/// Checks random values. Shrinks each value step by step as far as possible, and checks it after each step.
template <typename T>
void for_all(const rc::Gen<T>& any, std::uint64_t count, const std::function<void(const T&)>& check) {
  for (std::uint64_t seed = 1; seed <= test::rounds(count); ++seed) {
    rc::Shrinkable<T> at = draw(any, seed);
    check(at.value());
    for (int steps = 0;; ++steps) {
      ASSERT_LT(steps, 1000) << "shrinking does not end";
      std::vector<rc::Shrinkable<T>> smaller;
      auto all = at.shrinks();
      while (auto one = all.next()) smaller.push_back(*one);
      if (smaller.empty()) break;
      at = smaller[seed * 7919 % smaller.size()];
      check(at.value());
    }
  }
}

struct Floor {
  explicit Floor(const std::string& text)
      : map(map::parse_map(text, "random")),
        start(map::default_start(map)),
        network(map::trace_network(map, start)),
        graph(map::true_graph(map, start)) {}
  map::Map map;
  map::Start start;
  map::Network network;
  map::TrueGraph graph;
};

template <typename Check>
std::string smallest(const rc::Gen<std::string>& any, const Check& fails) {
  for (std::uint64_t seed = 1;; ++seed) {
    const auto drawn = draw(any, seed);
    if (fails(drawn.value())) return rc::shrinkable::findLocalMin(drawn, fails).first;
  }
}

int area(const std::string& text) { return static_cast<int>(std::count(text.begin(), text.end(), '.')) + 1; }

TEST(RandomTrees, AreConnectedAndBeginAtAStation) {
  std::set<std::string> seen;
  for_all<std::string>(trees(12), 60, [&](const std::string& text) {
    const Floor floor(text);
    EXPECT_TRUE(floor.network.unreachable.empty()) << text;
    EXPECT_GE(floor.graph.stations.size(), 2u) << text;
    EXPECT_EQ(floor.graph.stations[0].cell, floor.start.cell) << text;
    EXPECT_EQ(map::cycle_count(floor.graph), 0u) << text;
    seen.insert(text);
  });
  EXPECT_GT(seen.size(), test::rounds(100u));
}

TEST(RandomTrees, KeepTheirLandmarksApart) {
  for_all<std::string>(networks({.lines = 12, .apart = 4, .most_ways = 3}), 30, [](const std::string& text) {
    const Floor floor(text);
    for (const auto& station : floor.graph.stations) EXPECT_GE(station.arm.length, 4) << text;
    for (const auto& junction : floor.graph.junctions) {
      EXPECT_EQ(junction.arms.size(), 3u) << text;
      for (const map::Arm& arm : junction.arms) EXPECT_GE(arm.length, 4) << text;
    }
  });
}

TEST(RandomNetworks, HaveCyclesAndCrossingsWhereTheyMay) {
  int cycles = 0, crossings = 0, obstacles = 0;
  for_all<std::string>(networks({.lines = 20, .cycles = 2, .obstacles = 1}), 60,
                       [&](const std::string& text) {
                         const Floor floor(text);
                         EXPECT_LE(map::cycle_count(floor.graph), 2u) << text;
                         cycles += map::cycle_count(floor.graph) > 0;
                         for (const auto& junction : floor.graph.junctions)
                           crossings += junction.arms.size() == 4;
                         obstacles += text.find('x') != std::string::npos;
                       });
  EXPECT_GT(cycles, 0);
  EXPECT_GT(crossings, 0);
  EXPECT_GT(obstacles, 0);
}

TEST(RandomNetworks, AreSmallWhereTheSizeIsSmall) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
    EXPECT_LE(area(draw(trees(20), seed, 10).value()), 2 * 4 + 1) << "two pieces of 4 cells";
}

TEST(RandomNetworks, ShrinkToTheShortestLineIfAnythingFails) {
  const auto any = [](const std::string&) { return true; };
  EXPECT_EQ(area(smallest(networks({.lines = 20, .cycles = 3, .obstacles = 2}), any)), 4);
}

TEST(RandomNetworks, ShrinkToTheSmallestTIfJunctionsFail) {
  const auto has_junction = [](const std::string& text) { return !Floor(text).graph.junctions.empty(); };
  const std::string text = smallest(networks({.lines = 20, .cycles = 3}), has_junction);
  EXPECT_EQ(area(text), 10) << "three arms of three cells\n" << text;
  EXPECT_EQ(Floor(text).graph.stations.size(), 3u) << text;
}

TEST(RandomNetworks, ShrinkToTheSmallestCycleIfCyclesFail) {
  const auto has_cycle = [](const std::string& text) { return map::cycle_count(Floor(text).graph) > 0; };
  const std::string text = smallest(networks({.lines = 20, .cycles = 3}), has_cycle);
  EXPECT_EQ(area(text), 12 + 3) << "a square with a tail\n" << text;
}

TEST(RandomNetworks, ShrinkToALineWithItsObstacleIfObstaclesFail) {
  const auto has_obstacle = [](const std::string& text) { return text.find('x') != std::string::npos; };
  EXPECT_EQ(area(smallest(networks({.lines = 20, .cycles = 3, .obstacles = 2}), has_obstacle)), 3);
}

TEST(RandomTracks, AreSingleLoopsWithTheGoalOfALap) {
  int bent = 0, broken = 0;
  for_all<std::string>(tracks({.squares = 8, .gaps = 2}), 60, [&](const std::string& text) {
    const Floor floor(text);
    EXPECT_FALSE(floor.network.loop.empty()) << text;
    EXPECT_EQ(floor.map.goal, "laps:1");
    EXPECT_EQ(floor.map.at(floor.start.cell), map::Cell::line) << "a gap is not a start\n" << text;
    bent += floor.network.loop.size() > 40;
    broken += text.find("3", text.find("+++", 3)) != std::string::npos;
  });
  EXPECT_GT(bent, 0);
  EXPECT_GT(broken, 0);
}

TEST(RandomTracks, ShrinkToOneSquare) {
  const std::string text =
      smallest(tracks({.squares = 8, .gaps = 2}), [](const std::string&) { return true; });
  EXPECT_EQ(Floor(text).network.loop.size(), 16u) << text;
  EXPECT_EQ(text.find("3", text.rfind("+++")), std::string::npos) << text;
}

TEST(RandomRobots, AreTakenAndShrinkToTheFile) {
  int runs = 0;
  for_all<std::string>(robots("uno5", 2.0), 2, [&](const std::string& robot) {
    if (runs++ % 5 != 0) return;
    Simulation simulation({.sketch = "PidFollower", .map = "oval", .robot = robot});
    simulation.run_for(1_ms);
  });
  EXPECT_EQ(smallest(robots("uno5"), [](const std::string&) { return true; }), "uno5");
}

TEST(RandomRobots, KeepTheFigureThatMatters) {
  const auto has_wheel = [](const std::string& robot) {
    return robot.find("\nwheel = ") != std::string::npos;
  };
  EXPECT_THAT(smallest(robots("uno5"), has_wheel),
              MatchesRegex("base = \"uno5\"\n\\[chassis\\]\nwheel = \"3[12]\\.[0-9]* mm\"\n"));
}

TEST(RandomRobots, StayWithinTheSpreads) {
  for_all<std::string>(robots("uno5", 2.0), 30, [&](const std::string& robot) {
    const std::size_t at = robot.find("\ntrack = \"");
    if (at == std::string::npos) return;
    EXPECT_NEAR(std::stod(robot.substr(at + 10)), 98.0, 1.0) << "98 mm, spread 1 mm";
    const std::size_t place = robot.find("\nat = [\"");
    if (place != std::string::npos) {
      EXPECT_NEAR(std::stod(robot.substr(place + 8)), 70.0, 2.0);
    }
  });
}

TEST(RandomFaults, AreTakenAndShrinkToNone) {
  const Faults limits{.at_most = 4, .covered = 20_ms};
  std::set<std::string> words;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const std::string script = draw(faults("uno5", limits), seed).value();
    for (const char* word : {"offset", "noisy", "weak", "drift", "cover"})
      if (script.find(word) != std::string::npos) words.insert(word);
  }
  EXPECT_EQ(words.size(), 5u);
  for (std::uint64_t seed = 1; seed <= 5; ++seed)
    EXPECT_NO_THROW(Simulation(
        {.sketch = "PidFollower", .map = "oval", .script = draw(faults("uno5", limits), seed).value()}));
  EXPECT_EQ(smallest(faults("uno5", limits), [](const std::string&) { return true; }), "");
}

TEST(RandomFaults, KeepTheOneThatMattersAsMildAsItMayBe) {
  const auto has_drift = [](const std::string& script) { return script.find("drift") != std::string::npos; };
  EXPECT_THAT(smallest(faults("uno5", {.at_most = 4}), has_drift),
              MatchesRegex("at 0ms fault clock drift -?500ppm\n"));
}

TEST(Trials, TakeMapRobotScriptAndSeedByChance) {
  const Worlds worlds{.trial = {.sketch = "PidFollower", .goal = "tour", .script = "at 1s press start"},
                      .maps = trees(),
                      .robots = robots("uno5"),
                      .scripts = faults("uno5", {.at_most = 3}),
                      .seeds = 50};
  std::set<std::string> maps, robots, scripts;
  std::set<std::uint64_t> seeds;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    const Trial trial = draw(trials(worlds), seed).value();
    EXPECT_EQ(trial.goal, "tour");
    EXPECT_THAT(trial.script, ::testing::StartsWith("at 1s press start\n"));
    EXPECT_TRUE(trial.seed >= 1 && trial.seed <= 50) << trial.seed;
    maps.insert(trial.map);
    robots.insert(trial.robot);
    scripts.insert(trial.script);
    seeds.insert(trial.seed);
  }
  for (const std::size_t different : {maps.size(), robots.size(), scripts.size(), seeds.size()})
    EXPECT_GT(different, 8u);
  const Trial same = draw(trials({.trial = worlds.trial, .seeds = 1}), 1).value();
  EXPECT_EQ(same.seed, worlds.trial.seed);
  EXPECT_EQ(same.map + same.robot, "");
}

Worlds pid_in_trees() { return {.trial = {.sketch = "PidFollower"}, .maps = trees(8)}; }

TEST(InRandomWorlds, TriesSoManyWorldsAndNoTwoAlike) {
  std::set<std::string> maps;
  InRandomWorlds(pid_in_trees(), {8}, [&](Simulation& robot) { maps.insert(robot.trial().map); });
  EXPECT_GE(maps.size(), 5u);
}

TEST(InRandomWorlds, FailsOnceAndTellsTheSmallestWorld) {
  const auto search = [] {
    InRandomWorlds({.trial = {.sketch = "PidFollower"}, .maps = trees(8), .scripts = faults()}, {20},
                   [](Simulation& robot) { EXPECT_EQ(robot.true_graph().junctions(), 0) << "planted"; });
  };
  const std::vector<std::string> messages = caught_failures(search);
  ASSERT_EQ(messages.size(), 1u);
  EXPECT_THAT(messages[0], HasSubstr("planted"));
  EXPECT_THAT(messages[0], HasSubstr(" of 20 failed"));
  EXPECT_EQ(area(messages[0].substr(messages[0].find("map:"))), 10) << messages[0];
  EXPECT_THAT(messages[0], HasSubstr("seed: 1\n"));
  EXPECT_EQ(messages[0].find("script:"), std::string::npos) << "no fault is needed";
  const std::string again = caught_failures(search).at(0);
  EXPECT_EQ(again.substr(again.find("world ")), messages[0].substr(messages[0].find("world ")));
}

TEST(InRandomWorlds, FailsWhereTheBodyThrows) {
  const auto messages = caught_failures(
      [] { InRandomWorlds(pid_in_trees(), {3}, [](Simulation& robot) { robot.press("nose"); }); });
  ASSERT_EQ(messages.size(), 1u);
  EXPECT_THAT(messages[0], HasSubstr("nose"));
  EXPECT_THAT(messages[0], HasSubstr("world 1 of 3 failed"));
}

TEST(InRandomWorlds, DoesNotTakeASketchThatCannotBeBuiltForOneThatFails) {
  Worlds worlds = pid_in_trees();
  worlds.trial.sketch = "NoSuchSketch";
  EXPECT_THROW(InRandomWorlds(worlds, {3}, [](Simulation&) {}), InputError);
}

}  // namespace random_worlds_test
}  // namespace robosim::testing
