// Measures the AVR emulator: its speed as a multiple of real time, on one core of this machine's processor,
// and the cost of a snapshot.

#include <benchmark/benchmark.h>
#include <malloc.h>

#include "sim/build/sketch.h"
#include "sim/exec/avr/avr_executor.h"
#include "sim/mcu/avr/chip.h"
#include "sim/robot/description.h"
#include "sim/run/simulation.h"

namespace robosim {
namespace {

constexpr SimTime kSimulated = 10 * kSecond;
const std::filesystem::path kSketches = ROBOSIM_BENCH_SKETCHES;

std::filesystem::path image_of(const std::filesystem::path& sketch) {
  build::Request request{sketch, *find_board("uno")};
  request.target = "avr";
  return build::build(request).image;
}

void report(benchmark::State& state) {
  const double seconds = 1e-9 * static_cast<double>(kSimulated) * static_cast<double>(state.iterations());
  state.counters["times_real_time"] = benchmark::Counter(seconds, benchmark::Counter::kIsRate);
}

// Simulates a whole run: chip, robot, world and judge.
void whole(benchmark::State& state, const std::filesystem::path& sketch) {
  const map::Map map = map::read_map(map::find_map("oval"));
  const robot::Description robot = robot::load_description("uno5");
  const auto image = image_of(sketch);
  for (auto _ : state) {
    exec::AvrExecutor executor(*robot.board, image);
    run::Setup setup;
    setup.map = &map;
    setup.agents = {{.robot = &robot, .executor = &executor, .goal = judge::parse_goal("none")}};
    setup.limit = kSimulated;
    const judge::Outcome outcome = run::simulate(setup).front();
    if (outcome.verdict != judge::Verdict::reached) state.SkipWithError(outcome.why.c_str());
  }
  report(state);
}

// Runs the chip without a robot, with open pins, in steps of `range` milliseconds. A whole simulation runs
// the chip in steps of 1 ms. Steps of 1000 ms have almost no overhead.
void chip(benchmark::State& state, const std::filesystem::path& sketch) {
  const auto image = image_of(sketch);
  const SimTime step = state.range(0) * kMillisecond;
  for (auto _ : state) {
    exec::AvrExecutor executor(*find_board("uno"), image);
    executor.power_on(0);
    for (SimTime t = step; t <= kSimulated; t += step) executor.run_until(t);
    if (executor.crash()) state.SkipWithError(executor.crash()->reason.c_str());
  }
  report(state);
}

// A whole simulation that has run for one second.
class Midway {
 public:
  Midway() : executor_(*robot_.board, image_of(build::find_sketch("PidFollower"))), simulation_(setup_) {
    simulation_.run_until(kSecond);
  }
  run::Simulation& operator*() { return simulation_; }
  std::size_t chip_bytes() const { return executor_.chip()->save().bytes.size(); }

 private:
  run::Setup setup() {
    run::Setup setup;
    setup.map = &map_;
    setup.agents = {{.robot = &robot_, .executor = &executor_}};
    return setup;
  }

  map::Map map_ = map::read_map(map::find_map("oval"));
  robot::Description robot_ = robot::load_description("uno5");
  exec::AvrExecutor executor_;
  run::Setup setup_ = setup();
  run::Simulation simulation_;
};

void save(benchmark::State& state) {
  Midway midway;
  const auto before = ::mallinfo2().uordblks;
  const run::Simulation::Snapshot kept = (*midway).save();
  state.counters["bytes"] = static_cast<double>(::mallinfo2().uordblks - before);
  state.counters["chip_bytes"] = static_cast<double>(midway.chip_bytes());
  for (auto _ : state) benchmark::DoNotOptimize((*midway).save());
}

void restore(benchmark::State& state) {
  Midway midway;
  const run::Simulation::Snapshot snapshot = (*midway).save();
  for (auto _ : state) (*midway).restore(snapshot);
}

BENCHMARK(save)->Name("avr/save PidFollower on oval")->Unit(benchmark::kMicrosecond);
BENCHMARK(restore)->Name("avr/restore PidFollower on oval")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(whole, follower, build::find_sketch("PidFollower"))
    ->Name("avr/PidFollower on oval")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(chip, follower, build::find_sketch("PidFollower"))
    ->Name("avr/PidFollower, chip alone")
    ->ArgName("step_ms")
    ->Arg(1)
    ->Arg(1000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(chip, sleeps, kSketches / "SleepsIdle")
    ->Name("avr/sleeps")
    ->ArgName("step_ms")
    ->Arg(1)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace robosim
