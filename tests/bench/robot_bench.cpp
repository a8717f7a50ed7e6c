// Measures one tick of a whole robot: parts, body and walls, with the noise of the profile `typical`.

#include <benchmark/benchmark.h>

#include <vector>

#include "hal/board/board_spec.h"
#include "sim/exec/core/board_state.h"
#include "sim/robot/batch/robots.h"
#include "sim/robot/describe.h"
#include "sim/robot/description.h"
#include "sim/robot/robot.h"
#include "sim/world/world.h"

namespace robosim {
namespace {

// Drives an uno5 in circles on the oval's floor. `state.range(0)` is the number of ticks between two reads of
// all five sensors.
void robot_tick(benchmark::State& state) {
  const map::Map map = map::read_map(map::find_map("oval"));
  const robot::Description description = robot::load_description("uno5");
  world::World world(map);
  const auto body =
      world.add_body(robot::body_params(description, 1, robot::Profile::typical), {{1.2, 0.6}, {1.0, 0.0}});
  exec::BoardState board(*description.board);
  robot::Robot robot(description, world, body, board, 1, robot::Profile::typical);
  for (const Pin pin : {7, 9}) board.set_drive(pin, {PinMode::output, true, false, 1.0, 0}, 0);
  for (const Pin pin : {8, 10}) board.set_drive(pin, {PinMode::output, false, false, 0.0, 0}, 0);
  board.set_drive(5, {PinMode::output, false, true, 0.3, 0}, 0);
  board.set_drive(6, {PinMode::output, false, true, 0.5, 0}, 0);
  SimTime t = 0;
  int until_read = 0;
  double seen = 0.0;
  for (auto _ : state) {
    robot.begin_tick(t);
    if (until_read-- == 0) {
      for (Pin pin = 14; pin < 19; ++pin) seen += board.read_volts(pin, t);
      until_read = static_cast<int>(state.range(0)) - 1;
    }
    t += kTick;
    robot.end_tick(t);
    world.step();
  }
  benchmark::DoNotOptimize(seen);
}

BENCHMARK(robot_tick)
    ->Name("robot/tick, five sensors read every")
    ->ArgName("ms")
    ->Arg(1)
    ->Arg(5)
    ->Arg(1000000000);

// Measures one tick of 64 robots in a batch, and reports the time per robot.
void batch_tick(benchmark::State& state) {
  constexpr std::size_t kRobots = 64;
  const map::Map map = map::read_map(map::find_map("oval"));
  const robot::Description description = robot::load_description("uno5");
  const world::World world(map);
  batch::Robots robots(world);
  for (std::size_t i = 0; i < kRobots; ++i) {
    robots.add(description, i + 1, robot::Profile::typical, {{1.2, 0.6}, {1.0, 0.0}});
    robots.tell(i, world::left, {0.3, 0.7});
    robots.tell(i, world::right, {0.5, 0.5});
  }
  std::vector<double> volts(kRobots);
  std::size_t robot = 0;
  int until_read = 0;
  for (auto _ : state) {
    if (++robot < kRobots) continue;
    robot = 0;
    if (until_read-- == 0) {
      for (std::size_t sensor = 0; sensor < 5; ++sensor) robots.read(sensor, robots.now(), volts);
      until_read = static_cast<int>(state.range(0)) - 1;
    }
    robots.step();
  }
  benchmark::DoNotOptimize(volts.data());
}

BENCHMARK(batch_tick)
    ->Name("batch/tick of one of 64, five sensors read every")
    ->ArgName("ms")
    ->Arg(1)
    ->Arg(5)
    ->Arg(1000000000);

}  // namespace
}  // namespace robosim
