// Measures the speed of whole simulations as a multiple of real time, on one processor core, with noise.

#include <benchmark/benchmark.h>

#include "sim/build/sketch.h"
#include "sim/exec/host/host_executor.h"
#include "sim/robot/description.h"
#include "sim/run/simulation.h"
#include "tests/support/built_in_driver.h"

namespace robosim {
namespace {

constexpr SimTime kSimulated = 20 * kSecond;

// Runs for kSimulated without a goal. An earlier end is an error.
void simulate(benchmark::State& state, exec::Executor& executor) {
  const map::Map map = map::read_map(map::find_map("oval"));
  const robot::Description robot = robot::load_description("uno5");
  run::Setup setup;
  setup.map = &map;
  setup.agents = {{.robot = &robot, .executor = &executor, .goal = judge::parse_goal("none")}};
  setup.limit = kSimulated;
  const judge::Outcome outcome = run::simulate(setup).front();
  if (outcome.verdict != judge::Verdict::reached) state.SkipWithError(outcome.why.c_str());
}

void report(benchmark::State& state) {
  const auto ticks = static_cast<double>(state.iterations()) * static_cast<double>(kSimulated / kTick);
  state.counters["per_tick"] =
      benchmark::Counter(ticks, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  state.counters["times_real_time"] = benchmark::Counter(ticks * 1e-3, benchmark::Counter::kIsRate);
}

void run_sketch(benchmark::State& state, const std::filesystem::path& sketch) {
  const BoardSpec& board = *find_board("uno");
  const build::Image image = build::build({sketch, board});
  for (auto _ : state) {
    exec::HostExecutor executor(board, image.image);
    simulate(state, executor);
  }
  report(state);
}

void built_in(benchmark::State& state) {
  for (auto _ : state) {
    test::BuiltInDriver driver(state.range(0) * kMillisecond);
    simulate(state, driver);
  }
  report(state);
}

const std::filesystem::path kSketches = ROBOSIM_BENCH_SKETCHES;

BENCHMARK(built_in)
    ->Name("run/built-in driver, sensors every ms")
    ->ArgName("ms")
    ->Arg(1)
    ->Arg(5)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(run_sketch, follower, build::find_sketch("PidFollower"))
    ->Name("run/PidFollower (delay)")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(run_sketch, reads, kSketches / "ReadsAndDrives")
    ->Name("run/reads sensors and drives")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(run_sketch, millis, kSketches / "PollsMillis")
    ->Name("run/polls millis()")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(run_sketch, pin, kSketches / "PollsPin")
    ->Name("run/polls digitalRead()")
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace robosim
