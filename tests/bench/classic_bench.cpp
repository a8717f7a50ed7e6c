// Measures the cell engine, in which a robot moves from cell to cell. First measures moves per second on map
// d, in bulk and one by one. For comparison, measures a re-implementation of Robosim v1 (tests/support/v1.h).
// Moves in bulk must reach 8 times the speed of v1, and 1e8 moves per second. Then measures a full scan of a
// tree with a million stations. The scan must take at most 0.5 s, not counting the generation of the map.
#include <benchmark/benchmark.h>

#include "sim/map/cells/survey.h"
#include "sim/map/cells/walk.h"
#include "sim/map/generator.h"
#include "tests/support/v1.h"

namespace {

using namespace robosim;
using namespace robosim::cells;

constexpr int kMoves = 100'000;  // number of moves per iteration

void count_moves(benchmark::State& state) {
  state.SetItemsProcessed(state.iterations() * kMoves);
  state.counters["moves/s"] =
      benchmark::Counter(static_cast<double>(state.iterations()) * kMoves, benchmark::Counter::kIsRate);
}

void CellsWalkMapD(benchmark::State& state) {
  const map::Map map = map::read_map(map::find_map("d"));
  const map::Start start = map::default_start(map);
  const CellFloor floor(map);
  CellRobot robot(floor, {start.cell, start.facing});
  for (auto _ : state) {
    walk_on(robot, Side::left, kMoves);
    benchmark::DoNotOptimize(robot.pose());
  }
  count_moves(state);
}
BENCHMARK(CellsWalkMapD);

void CellsWalkMapDOneByOne(benchmark::State& state) {
  const map::Map map = map::read_map(map::find_map("d"));
  const map::Start start = map::default_start(map);
  const CellFloor floor(map);
  CellRobot robot(floor, {start.cell, start.facing});
  for (auto _ : state) {
    for (int i = 0; i < kMoves; ++i) walk_on(robot, Side::left);
    benchmark::DoNotOptimize(robot.pose());
  }
  count_moves(state);
}
BENCHMARK(CellsWalkMapDOneByOne);

void OriginalsSensingWalksMapD(benchmark::State& state) {
  const map::Map map = map::read_map(map::find_map("d"));
  const map::Start start = map::default_start(map);
  v1::Robot robot{&map, start.cell.x, start.cell.y, letter(start.facing)};
  for (auto _ : state) {
    for (int i = 0; i < kMoves; ++i) {
      switch (*robot.sense()) {  // the results of sense() differ in their first letter
        case 's':
          robot.step_forward();
          break;
        case 'r':
          robot.turn_right();
          break;
        case 'l':
          robot.turn_left();
          break;
        case 'j':
          robot.choose_left();
          break;
        default:
          robot.turn_around();
      }
    }
    benchmark::DoNotOptimize(robot.x);
  }
  count_moves(state);
}
BENCHMARK(OriginalsSensingWalksMapD);

// Converts the map to a CellFloor. Then a robot explores all lines and builds the graph of the network.
void CellsScanAMillionStations(benchmark::State& state) {
  const map::Map map = map::generate(map::Family::tree, 1'000'000, 1);
  const map::Start start = map::default_start(map);
  std::uint64_t moves = 0;
  for (auto _ : state) {
    const CellFloor floor(map);
    CellRobot robot(floor, {start.cell, start.facing});
    CellWalker walker(robot);
    GrowingNetwork network;
    nav::Explorer<CellWalker, GrowingNetwork> explorer(walker, network);
    while (explorer.step()) {
    }
    if (explorer.state() != nav::ScanState::complete) state.SkipWithError("the scan is not complete");
    moves = robot.moves();
  }
  state.counters["moves"] = static_cast<double>(moves);
}
BENCHMARK(CellsScanAMillionStations)->Unit(benchmark::kMillisecond);

}  // namespace
