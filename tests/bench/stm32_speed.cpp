// How many times faster than real time the emulated Blue Pill runs, on one core, at 8 and at 72 MHz. An
// executable of its own: what links libunicorn (GPL-2) shall link no other emulator.

#include <benchmark/benchmark.h>

#include <filesystem>
#include <string>

#include "sim/build/sketch.h"
#include "sim/exec/stm32/stm32_executor.h"
#include "sim/robot/description.h"
#include "sim/run/simulation.h"

namespace robosim {
namespace {

constexpr SimTime kSimulated = 10 * kSecond;

// The whole simulation: robot, world and judge too.
void whole(benchmark::State& state, const char* board, const std::filesystem::path& sketch) {
  const grid::Map map = grid::read_map(grid::find_map("oval"));
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
