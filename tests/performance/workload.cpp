// robosim_workload NAME COUNT: does a piece of Robosim's work so many times, for count.sh to count. What is
// done before the first time is the same for every COUNT, so that the difference of two says what one takes.
#include <fmt/format.h>

#include <charconv>
#include <cstdio>
#include <cstring>
#include <exception>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>

#include "sim/base/file.h"
#include "sim/cells/survey.h"
#include "sim/cells/walk.h"
#include "sim/grid/generator.h"
#include "sim/judge/goal.h"
#include "sim/robot/description.h"
#include "sim/run/simulation.h"
#include "tests/support/built_in_driver.h"

namespace robosim {
namespace {

// A robot with five sensors on `oval`, without firmware, for `count` ticks.
void ticks(SimTime looks_every, int count) {
  const grid::Map map = grid::read_map(grid::find_map("oval"));
  const robot::Description robot = robot::load_description("uno5");
  test::BuiltInDriver driver(looks_every);
  run::Setup setup;
  setup.map = &map;
  setup.agents = {{.robot = &robot, .executor = &driver, .goal = judge::parse_goal("none")}};
  setup.limit = count * kTick;
  if (const judge::Outcome outcome = run::simulate(setup).front(); outcome.verdict != judge::Verdict::reached)
    throw std::runtime_error(outcome.why);
}

void moves(int count) {
  const grid::Map map = grid::read_map(grid::find_map("d"));
  const grid::Start start = grid::default_start(map);
  const cells::CellFloor floor(map);
  cells::CellRobot robot(floor, {start.cell, start.facing});
  for (int i = 0; i < count; ++i) cells::walk_on(robot, cells::Side::left);
}

void scans(int count) {
  const grid::Map map = grid::generate(grid::Family::tree, 2000, 1);
  const grid::Start start = grid::default_start(map);
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

// Rows of 1000 cells, within walls, a line in each fourth.
void read_rows(int count) {
  std::string text;
  for (int y = 0; y < count; ++y) {
    const bool edge = y == 0 || y == count - 1;
    std::string row(1000, edge ? '2' : '0');
    row.front() = row.back() = '2';
    if (!edge && y % 4 == 3) std::memset(row.data() + 3, '1', row.size() - 6);
    text += row + '\n';
  }
  const std::filesystem::path file = std::filesystem::temp_directory_path() / "robosim_workload.map";
  write_file(file, text);
  grid::read_map(file);
  std::filesystem::remove(file);
}

const std::map<std::string, std::function<void(int)>> kWorkloads = {
    {"ticks-1ms", [](int count) { ticks(kMillisecond, count); }},
    {"ticks-5ms", [](int count) { ticks(5 * kMillisecond, count); }},
    {"moves", moves},
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
