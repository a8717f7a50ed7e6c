// Measures the speed of the emulated Blue Pill, at 8 and at 72 MHz, as a multiple of real time. Uses one core
// of this machine. This benchmark is a separate executable, because a program with libunicorn
// (GPL-2) must not link another emulator.

#include <benchmark/benchmark.h>
#include <malloc.h>

#include <filesystem>
#include <string>

#include "sim/build/sketch.h"
#include "sim/exec/stm32/stm32_executor.h"
#include "sim/robot/description.h"
#include "sim/run/simulation.h"

namespace robosim {
namespace {

constexpr SimTime kSimulated = 10 * kSecond;

// Simulates a whole run: chip, robot, world and judge.
void whole(benchmark::State& state, const char* board, const std::filesystem::path& sketch) {
  const map::Map map = map::read_map(map::find_map("oval"));
  const robot::Description robot = robot::parse_description(
      std::string("base = \"bluepill5\"\nboard = \"") + board + "\"\n", "bench.toml");
  build::Request request{sketch, *robot.board};
  request.target = "stm32";
  const auto image = build::build(request).image;
  for (auto _ : state) {
    exec::Stm32Executor executor(*robot.board, image);
    run::Setup setup;
    setup.map = &map;
    setup.agents = {{.robot = &robot, .executor = &executor, .goal = judge::parse_goal("none")}};
    setup.limit = kSimulated;
    const judge::Outcome outcome = run::simulate(setup).front();
    if (outcome.verdict != judge::Verdict::reached) state.SkipWithError(outcome.why.c_str());
  }
  const double seconds = 1e-9 * static_cast<double>(kSimulated) * static_cast<double>(state.iterations());
  state.counters["times_real_time"] = benchmark::Counter(seconds, benchmark::Counter::kIsRate);
}

// A whole simulation that has run for one second.
class Midway {
 public:
  Midway() : executor_(*robot_.board, image()), simulation_(setup_) { simulation_.run_until(kSecond); }
  run::Simulation& operator*() { return simulation_; }

 private:
  std::filesystem::path image() const {
    build::Request request{build::find_sketch("PidFollower"), *robot_.board};
    request.target = "stm32";
    return build::build(request).image;
  }
  run::Setup setup() {
    run::Setup setup;
    setup.map = &map_;
    setup.agents = {{.robot = &robot_, .executor = &executor_}};
    return setup;
  }

  map::Map map_ = map::read_map(map::find_map("oval"));
  robot::Description robot_ = robot::load_description("bluepill5");
  exec::Stm32Executor executor_;
  run::Setup setup_ = setup();
  run::Simulation simulation_;
};

void save(benchmark::State& state) {
  Midway midway;
  const auto before = ::mallinfo2().uordblks;
  const run::Simulation::Snapshot kept = (*midway).save();
  state.counters["bytes"] = static_cast<double>(::mallinfo2().uordblks - before);
  for (auto _ : state) benchmark::DoNotOptimize((*midway).save());
}

void restore(benchmark::State& state) {
  Midway midway;
  const run::Simulation::Snapshot snapshot = (*midway).save();
  for (auto _ : state) (*midway).restore(snapshot);
}

BENCHMARK(save)->Name("stm32/save PidFollower on oval")->Unit(benchmark::kMicrosecond);
BENCHMARK(restore)->Name("stm32/restore PidFollower on oval")->Unit(benchmark::kMicrosecond);

void add(const char* name, const std::filesystem::path& sketch) {
  for (const char* const board : {"bluepill8", "bluepill"}) {
    const std::string clock = find_board(board)->clock_hz > 8'000'000 ? ", 72 MHz" : ", 8 MHz";
    benchmark::RegisterBenchmark(("stm32/" + (name + clock)).c_str(), whole, board, sketch)
        ->Unit(benchmark::kMillisecond);
  }
}

[[maybe_unused]] const bool added = [] {
  const std::filesystem::path sketches = ROBOSIM_BENCH_SKETCHES;
  add("PidFollower on oval", build::find_sketch("PidFollower"));
  add("computes", sketches / "Computes");
  add("reads and drives", sketches / "ReadsAndDrives");
  return true;
}();

}  // namespace
}  // namespace robosim
