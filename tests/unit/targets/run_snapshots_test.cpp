// Tests that a run which continues from a snapshot has the same trace, events and result as an uninterrupted
// run. For each example sketch, and for sketches for other chips, the tests restore 100 random moments of a
// run. The runs have noise, and a script with all possible actions on the robot. ROBOSIM_TEST_MOMENTS=1000
// tries more moments, in longer runs.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <stdlib.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <vector>

#include "sim/build/sketch.h"
#include "sim/robot/description.h"
#include "sim/run/simulation.h"
#include "sim/wire/json_writer.h"
#include "tests/support/effort.h"
#include "tests/support/require_target.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/targets/target.h"

namespace robosim::run::run_snapshots_test {

using testing::ElementsAreArray;
using testing::HasSubstr;

/// One of every kToTheEnd restored runs continues to the end of the simulation. The other runs end earlier.
constexpr std::size_t kToTheEnd = 10;

struct Case {
  const char* target;
  const char* sketch;
  const char* robot;
  const char* map;
  const char* ahead;  ///< a cell in front of the robot
  const char* script;
  bool is_driven = false;  ///< controlled step by step
};

/// The script's lines for all robots: a weak motor, a lift, power failures, clock drift and corrupted bytes.
const std::string kScript = R"(
at 230ms fault left weak 0.6 for 300ms
at 350ms lift for 80ms
at 900ms power off for 15ms
at 1100ms fault power sag 4V
at 1140ms fault power ok
at 1200ms fault clock drift 300ppm
at 1300ms fault serial corrupted 50%
after boot 2 wait 100ms send "x1\n2\n"
after boot 2 wait 400ms send "2\n"
)";

constexpr const char* kObstacles = R"(
at 160ms obstacle {} radius 20mm for 500ms
at 760ms obstacle {} radius 50mm
)";

const std::string kFiveSensors = R"(
at 100ms press start 60ms
at 260ms press start for 40ms
at 400ms fault S2 swapped S4
at 520ms cover S3 50ms
at 600ms fault S1 noisy 0.2 for 200ms
at 1000ms press start 70ms
at 1250ms fault encoder_left dead for 100ms
at 1400ms fault S5 stuck 300
)";

const std::string kThreeSensors = R"(
at 400ms fault left_sensor swapped right_sensor for 90ms
at 520ms cover middle_sensor 50ms
at 600ms fault left_sensor noisy 0.2 for 200ms
at 1400ms fault right_sensor stuck 1
)";

const std::string kPony = R"(
at 100ms press scan 60ms
at 130ms send radio 3
at 980ms press scan 60ms
at 1000ms send radio 0b1101
at 1150ms fault radio noisy 0.3
at 1160ms send radio 200
)" + kThreeSensors;

struct Told final : Listener {
  void byte_sent(std::uint8_t byte, SimTime t) override {
    lines.push_back(fmt::format("{} byte {}", t, byte));
  }
  void happened(const result::RunEvent& event) override {
    lines.push_back(fmt::format("{} {}", event.t_ns, result::text_of(event)));
  }
  std::vector<std::string> lines;
};

/// Chooses actions only by the robot's current state, so that a restored run repeats the actions.
struct Hands final : StepController {
  Leg next(Standstill& standstill) override {
    const State& now = standstill.state();
    const SimTime ms = now.t / kTick;
    constexpr const char* kActs[] = {"cover S3 20ms", "fault S2 noisy 0.2 for 60ms", "send \"1\\n\"",
                                     "press start 30ms", "lift for 20ms"};
    const auto chosen = static_cast<std::size_t>(ms + now.stop) + now.serial_bytes;
    if (now.t > 0)
      standstill.add(
          scenario::parse_scenario(fmt::format("at {}ms {}", ms, kActs[chosen % std::size(kActs)]), "hands"));
    return {.until = now.t + (20 + ms % 50) * kTick,
            .stops = {Stop::motors(!now.driven), Stop::serial("\n", now.serial_bytes),
                      Stop::event("collision_began"), Stop::reading("S1", ms % 2 == 0)}};
  }
};

std::string text_of(const judge::Outcome& o) {
  std::string text = fmt::format("{} {} {} ({}, {}, {}) {}\n{}\n{}\n", o.trace_hash, o.why, o.time,
                                 o.end.position.x, o.end.position.y, o.end.heading.y, o.eeprom_writes,
                                 wire::to_json(o.metrics).dump(), wire::to_json(*o.resources).dump());
  for (const result::RunEvent& event : o.events)
    text += fmt::format("{} {}\n", event.t_ns, result::text_of(event));
  return text + o.serial;
}

/// Returns the number of moments that the environment sets, or 0.
int wanted_moments() {
  const char* text = ::getenv("ROBOSIM_TEST_MOMENTS");
  return text ? std::stoi(text) : 0;
}

class RunOnChip : public testing::Test {
 protected:
  void use(const exec::Target& target, const char* sketch, const char* robot, const char* map) {
    test::use_shared_cache();
    target_ = &target;
    map_ = map::read_map(map::find_map(map));
    robot_ = robot::load_description(robot);
    std::filesystem::path folder = std::filesystem::path(ROBOSIM_EXAMPLES) / sketch;
    if (!exists(folder)) folder = std::filesystem::path(ROBOSIM_TEST_SKETCHES) / sketch;
    build::Request request{folder, *robot_.board};
    request.target = target.name;
    image_ = build::build(request).image;
  }
  std::unique_ptr<exec::Executor> make_executor() { return target_->make_executor(*robot_.board, image_); }
  AgentSetup agent(exec::Executor& executor, const char* goal, const std::string& script,
                   Listener* listener = nullptr) {
    return {.robot = &robot_,
            .executor = &executor,
            .goal = judge::parse_goal(goal),
            .scenario = scenario::parse_scenario(script, "s.txt"),
            .listener = listener};
  }
  run::Setup setup(std::vector<AgentSetup> agents, SimTime limit) {
    run::Setup setup;
    setup.map = &map_;
    setup.agents = std::move(agents);
    setup.limit = limit;
    setup.seed = 5;
    return setup;
  }

  const exec::Target* target_ = nullptr;
  map::Map map_;
  robot::Description robot_;
  std::filesystem::path image_;
};

class Snapshots : public RunOnChip, public testing::WithParamInterface<Case> {
 protected:
  void SetUp() override {
    const Case& run = GetParam();
    const exec::Target* const target = exec::find_target(run.target);
    if (!target) GTEST_SKIP() << run.target << " was left out";
    ROBOSIM_NEEDS_TARGET(run.target);
    use(*target, run.sketch, run.robot, run.map);
  }
  static bool longer() { return wanted_moments() > 0; }
  static int moments() { return longer() ? wanted_moments() : test::rounds(100); }
  run::Setup setup(exec::Executor& executor, Listener* listener = nullptr) {
    const std::string script =
        kScript + GetParam().script + fmt::format(kObstacles, GetParam().ahead, GetParam().ahead);
    run::Setup setup = RunOnChip::setup({agent(executor, "none", script, listener)},
                                        longer() ? 10 * kSecond : 1600 * kMillisecond);
    if (GetParam().is_driven) setup.controller = &hands_;
    return setup;
  }

  Hands hands_;
};

TEST_P(Snapshots, GoOnAsTheRunThatWasNotInterrupted) {
  const auto untouched = make_executor(), executor = make_executor();
  Told told;
  const run::Setup setup = this->setup(*executor, &told);

  struct Moment {
    SimTime t;
    std::string result;  ///< result of a run that ends here
    std::size_t told = 0;
    Simulation::Snapshot snapshot;
  };
  std::mt19937 random(17);
  std::vector<SimTime> times;
  for (int i = 0; i < moments(); ++i)
    times.push_back(static_cast<SimTime>(random() % (setup.limit / kTick)) * kTick);
  times.push_back(setup.limit);
  std::sort(times.begin(), times.end());
  Simulation simulation(setup);
  std::vector<Moment> moments;
  for (const SimTime t : times) {
    simulation.run_until(t);
    ASSERT_EQ(simulation.now(), t);
    moments.push_back({t, "", told.lines.size(), simulation.save()});
    moments.back().result = text_of(simulation.end().front());
    simulation.restore(moments.back().snapshot);
  }
  ASSERT_EQ(moments.back().result, text_of(simulate(this->setup(*untouched)).front()));
  const std::vector<std::string> all = told.lines;

  std::vector<std::size_t> order(moments.size() - 1);
  std::iota(order.begin(), order.end(), 0u);
  const std::size_t a_while = std::max<std::size_t>(order.size() / 12, 1);
  std::shuffle(order.begin(), order.end(), random);
  for (const std::size_t i : order) {
    const Moment& from = moments[i];
    const Moment& to =
        i % kToTheEnd == 0 || longer() ? moments.back() : moments[std::min(i + a_while, moments.size() - 1)];
    simulation.restore(from.snapshot);
    told.lines.assign(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(from.told));
    simulation.run_until(to.t);
    ASSERT_EQ(text_of(simulation.end().front()), to.result) << "from " << from.t / kTick << " ms on";
    ASSERT_THAT(told.lines, ElementsAreArray(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(to.told)))
        << "from " << from.t / kTick << " ms on";
  }
}

INSTANTIATE_TEST_SUITE_P(
    Stock, Snapshots,
    testing::Values(Case{"avr", "PidFollower", "uno5", "oval", "13,14", kFiveSensors.c_str()},
                    Case{"avr", "LeftPath", "uno3", "d", "6,10", kThreeSensors.c_str()},
                    Case{"avr", "RightPath", "uno3", "a", "6,4", kThreeSensors.c_str()},
                    Case{"avr", "AiNavigator", "uno5", "b", "6,10", kFiveSensors.c_str()},
                    Case{"avr", "PonyNavigator", "pony", "city", "7,24", kPony.c_str()},
                    Case{"avr", "MegaFollower", "mega5", "oval", "13,14", kFiveSensors.c_str()},
                    Case{"avr", "LeonardoFollower", "leonardo5", "oval", "13,14", kFiveSensors.c_str()},
                    Case{"stm32", "PidFollower", "bluepill5", "oval", "13,14", kFiveSensors.c_str()},
                    Case{"stm32", "LeftPath", "bluepill3", "d", "6,10", kThreeSensors.c_str()},
                    Case{"stm32", "RightPath", "bluepill3", "a", "6,4", kThreeSensors.c_str()},
                    Case{"stm32", "AiNavigator", "bluepill5", "b", "6,10", kFiveSensors.c_str()},
                    Case{"stm32", "PonyNavigator", "bluepony", "city", "7,24", kPony.c_str()}),
    [](const auto& test) { return std::string(test.param.sketch) + "_" + test.param.target; });

INSTANTIATE_TEST_SUITE_P(
    Driven, Snapshots,
    testing::Values(Case{"avr", "PidFollower", "uno5", "oval", "13,14", "", true},
                    Case{"avr", "MegaFollower", "mega5", "oval", "13,14", "", true},
                    Case{"stm32", "PidFollower", "bluepill5", "oval", "13,14", "", true}),
    [](const auto& test) { return std::string(test.param.sketch) + "_" + test.param.target; });

class ChipSnapshots : public RunOnChip, public testing::WithParamInterface<exec::Target> {
 protected:
  void SetUp() override { ROBOSIM_NEEDS_TARGET(GetParam().name); }
};
INSTANTIATE_TEST_SUITE_P(, ChipSnapshots, testing::ValuesIn(exec::targets({"avr", "stm32"})), exec::name_of);

TEST_P(ChipSnapshots, AreOfAllRobotsAlsoOfThoseThatHaveTheirVerdict) {
  use(GetParam(), "PidFollower", GetParam().robot_of_five, "oval");
  const auto first = make_executor(), second = make_executor();
  run::Setup setup =
      this->setup({agent(*first, "still", "at 200ms fault left dead\nat 200ms fault right dead"),
                   agent(*second, "none", "")},
                  2500 * kMillisecond);
  setup.agents[1].start = map::parse_start(map_, "20,2,W");
  Simulation simulation(setup);
  std::vector<Simulation::Snapshot> snapshots;
  for (const SimTime t : {100, 1000, 2000}) {
    simulation.run_until(t * kMillisecond);
    snapshots.push_back(simulation.save());
  }
  const auto the_end = [&] {
    simulation.run_until(setup.limit);
    std::string text;
    for (const judge::Outcome& outcome : simulation.end()) text += text_of(outcome) + '\n';
    return text;
  };
  const std::string due = the_end();
  EXPECT_THAT(due, HasSubstr("The goal still was reached"));
  for (const int i : {2, 0, 1}) {
    simulation.restore(snapshots[static_cast<std::size_t>(i)]);
    EXPECT_EQ(the_end(), due) << "from snapshot " << i;
  }
}

TEST_P(ChipSnapshots, LeadToTheSameVerdictWhateverHappenedSince) {
  struct Run {
    const char* script;
    SimTime first, second;  ///< times of snapshots
    const char* verdict;
  };
  use(GetParam(), "LeftPath", GetParam().robot_of_three, "a");
  for (const Run& run :
       {Run{"at 300ms place 18,5,N\nat 500ms place 4,4,E", 200, 400, "The goal tour was reached"},
        Run{"at 200ms fault left stuck\nat 200ms fault right stuck", 100, 2000, "The robot is stuck"}}) {
    const auto executor = make_executor();
    const run::Setup setup = this->setup({agent(*executor, "tour", run.script)}, 5 * kSecond);
    Simulation simulation(setup);
    std::vector<Simulation::Snapshot> snapshots;
    for (const SimTime t : {run.first, run.second}) {
      simulation.run_until(t * kMillisecond);
      snapshots.push_back(simulation.save());
    }
    simulation.run_until(setup.limit);
    const std::string due = text_of(simulation.end().front());
    EXPECT_THAT(due, HasSubstr(run.verdict));
    for (const std::size_t i : {0u, 1u}) {
      simulation.restore(snapshots[0]);
      simulation.run_until((run.first + 50) * kMillisecond);
      simulation.restore(snapshots[i]);
      simulation.run_until(setup.limit);
      EXPECT_EQ(text_of(simulation.end().front()), due) << "from snapshot " << i;
    }
  }
}

TEST_P(ChipSnapshots, AreNoOtherSimulations) {
  use(GetParam(), "PidFollower", GetParam().robot_of_five, "oval");
  const auto first = make_executor(), second = make_executor();
  const run::Setup one = setup({agent(*first, "none", "")}, kSecond);
  const run::Setup two = setup({agent(*second, "none", "")}, kSecond);
  Simulation simulation(one), other(two);
  EXPECT_THROW(other.restore(simulation.save()), std::logic_error);
}

}  // namespace robosim::run::run_snapshots_test
