// robosim_workload NAME COUNT: repeats a piece of Robosim's work COUNT times, so that count.sh can count its
// instructions. The preparation is the same for every COUNT, so the difference between two counts is the cost
// of the work.
#include <fmt/format.h>

#include <charconv>
#include <cstdio>
#include <cstring>
#include <exception>
#include <functional>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "hal/board/board_spec.h"
#include "sim/base/file.h"
#include "sim/exec/core/board_state.h"
#include "sim/judge/goal.h"
#include "sim/map/cells/survey.h"
#include "sim/map/cells/walk.h"
#include "sim/map/generator.h"
#include "sim/robot/batch/robots.h"
#include "sim/robot/describe.h"
#include "sim/robot/description.h"
#include "sim/robot/robot.h"
#include "sim/run/simulation.h"
#include "sim/world/world.h"
#include "tests/support/built_in_driver.h"
#include "tests/support/temporary_folder.h"

namespace robosim {
namespace {

// Runs a robot with five sensors on `oval` for `count` ticks. BuiltInDriver replaces the firmware.
void ticks(SimTime looks_every, int count) {
  const map::Map map = map::read_map(map::find_map("oval"));
  const robot::Description robot = robot::load_description("uno5");
  test::BuiltInDriver driver(looks_every);
  run::Setup setup;
  setup.map = &map;
  setup.agents = {{.robot = &robot, .executor = &driver, .goal = judge::parse_goal("none")}};
  setup.limit = count * kTick;
  if (const judge::Outcome outcome = run::simulate(setup).front(); outcome.verdict != judge::Verdict::reached)
    throw std::runtime_error(outcome.why);
}

// 64 uno5s without firmware drive in circles on the oval's floor, one after another or as a batch. Their five
// sensors are read every `looks_every` ticks.
constexpr std::size_t kRobots = 64;
const Pose kStart{{1.2, 0.6}, {1.0, 0.0}};

void single_robots(int looks_every, int count) {
  const map::Map map = map::read_map(map::find_map("oval"));
  const robot::Description description = robot::load_description("uno5");
  struct Single {
    Single(const robot::Description& d, const map::Map& floor, std::uint64_t seed)
        : world(floor),
          robot(d, world, world.add_body(robot::body_params(d, seed, Profile::typical), kStart), board, seed,
                Profile::typical) {}
    world::World world;
    exec::BoardState board{*find_board("uno")};
    robot::Robot robot;
  };
  std::vector<std::unique_ptr<Single>> all;
  for (std::size_t i = 0; i < kRobots; ++i) {
    all.push_back(std::make_unique<Single>(description, map, i + 1));
    exec::BoardState& board = all.back()->board;
    for (const Pin pin : {7, 9}) board.set_drive(pin, {PinMode::output, true, false, 1.0, 0}, 0);
    for (const Pin pin : {8, 10}) board.set_drive(pin, {PinMode::output, false, false, 0.0, 0}, 0);
    board.set_drive(5, {PinMode::output, false, true, 0.3, 0}, 0);
    board.set_drive(6, {PinMode::output, false, true, 0.5, 0}, 0);
  }
  for (int tick = 0; tick < count; ++tick) {
    const SimTime t = tick * kTick;
    for (const auto& each : all) {
      each->robot.begin_tick(t);
      if (tick % looks_every == 0)
        for (Pin pin = 14; pin < 19; ++pin) each->board.read_volts(pin, t);
      each->robot.end_tick(t + kTick);
      each->world.step();
    }
  }
}

void batch_of_robots(int looks_every, int count) {
  const map::Map map = map::read_map(map::find_map("oval"));
  const robot::Description description = robot::load_description("uno5");
  const world::World world(map);
  batch::Robots robots(world);
  for (std::size_t i = 0; i < kRobots; ++i) {
    robots.add(description, i + 1, Profile::typical, kStart);
    robots.tell(i, world::left, {0.3, 0.7});
    robots.tell(i, world::right, {0.5, 0.5});
  }
  std::vector<double> volts(kRobots);
  for (int tick = 0; tick < count; ++tick) {
    if (tick % looks_every == 0)
      for (std::size_t sensor = 0; sensor < 5; ++sensor) robots.read(sensor, robots.now(), volts);
    robots.step();
  }
}

void moves(int count, bool one_by_one) {
  const map::Map map = map::read_map(map::find_map("d"));
  const map::Start start = map::default_start(map);
  const cells::CellFloor floor(map);
  cells::CellRobot robot(floor, {start.cell, start.facing});
  if (!one_by_one) return cells::walk_on(robot, cells::Side::left, static_cast<std::uint64_t>(count));
  for (int i = 0; i < count; ++i) cells::walk_on(robot, cells::Side::left);
}

void scans(int count) {
  const map::Map map = map::generate(map::Family::tree, 2000, 1);
  const map::Start start = map::default_start(map);
  for (int i = 0; i < count; ++i) {
    const cells::CellFloor floor(map);
    cells::CellRobot robot(floor, {start.cell, start.facing});
    cells::CellWalker walker(robot);
    cells::GrowingNetwork network;
    nav::Explorer<cells::CellWalker, cells::GrowingNetwork> explorer(walker, network);
    while (explorer.step()) {
    }
    if (explorer.state() != nav::ScanState::complete) throw std::runtime_error("the scan is not complete");
  }
}

// Reads a map with rows of 1000 cells inside walls, with a line in every fourth row.
void read_rows(int count) {
  std::string text;
  for (int y = 0; y < count; ++y) {
    const bool edge = y == 0 || y == count - 1;
    std::string row(1000, edge ? '2' : '0');
    row.front() = row.back() = '2';
    if (!edge && y % 4 == 3) std::memset(row.data() + 3, '1', row.size() - 6);
    text += row + '\n';
  }
  const test::TemporaryFolder folder;
  const std::filesystem::path file = folder / "rows.map";
  write_file(file, text);
  map::read_map(file);
}

const std::map<std::string, std::function<void(int)>> kWorkloads = {
    {"ticks-1ms", [](int count) { ticks(kMillisecond, count); }},
    {"ticks-5ms", [](int count) { ticks(5 * kMillisecond, count); }},
    {"robots-1ms", [](int count) { single_robots(1, count); }},
    {"robots-5ms", [](int count) { single_robots(5, count); }},
    {"batch-1ms", [](int count) { batch_of_robots(1, count); }},
    {"batch-5ms", [](int count) { batch_of_robots(5, count); }},
    {"moves", [](int count) { moves(count, true); }},
    {"many-moves", [](int count) { moves(count, false); }},
    {"scans", scans},
    {"map-rows", read_rows},
};

}  // namespace
}  // namespace robosim

int main(int argc, char** argv) try {
  const auto workload = robosim::kWorkloads.find(argc > 1 ? argv[1] : "");
  int count = 0;
  if (argc != 3 || workload == robosim::kWorkloads.end() ||
      std::from_chars(argv[2], argv[2] + std::strlen(argv[2]), count).ec != std::errc() || count < 1) {
    fmt::print(stderr, "robosim_workload NAME COUNT; names:");
    for (const auto& [name, work] : robosim::kWorkloads) fmt::print(stderr, " {}", name);
    fmt::print(stderr, "\n");
    return 2;
  }
  workload->second(count);
  return 0;
} catch (const std::exception& error) {
  fmt::print(stderr, "robosim_workload: {}\n", error.what());
  return 1;
}
