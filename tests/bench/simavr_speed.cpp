// Measures Robosim's speed relative to libsimavr. A whole run, with robot and world, alternates with a bare
// loop of avr_run() over the same ELF file. From machine to machine and from hour to hour, both times vary by
// a factor of two, but their ratio varies less. This command prints the median of the ratio:
// `robosim_bench_avr --benchmark_filter=libsimavr`.
extern "C" {
#include <simavr/avr_uart.h>
#include <simavr/sim_avr.h>
#include <simavr/sim_elf.h>
}

#include <benchmark/benchmark.h>

#include <cstdlib>
#include <ctime>
#include <filesystem>

#include "sim/build/sketch.h"
#include "sim/exec/avr/avr_executor.h"
#include "sim/robot/description.h"
#include "sim/run/simulation.h"

namespace robosim {
namespace {

const std::filesystem::path kSketches = ROBOSIM_BENCH_SKETCHES;

/// Returns this process's processor time in seconds.
double processor_time() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Runs the program in Robosim. Returns why it did not run to its end, or "".
std::string run_ours(const std::filesystem::path& image, const map::Map& map, const robot::Description& robot,
                     SimTime length) {
  exec::AvrExecutor executor(*robot.board, image);
  run::Setup setup;
  setup.map = &map;
  setup.agents = {{.robot = &robot, .executor = &executor, .goal = judge::parse_goal("none")}};
  setup.limit = length;
  const judge::Outcome outcome = run::simulate(setup).front();
  return outcome.verdict == judge::Verdict::reached ? "" : outcome.why;
}

/// Runs libsimavr as its users do, but without its sleep callback. The callback waits in real time. With it,
/// libsimavr takes six times as much processor time for SleepsIdle.
std::string run_libsimavr(const std::filesystem::path& image, const BoardSpec& board, SimTime length) {
  elf_firmware_t firmware{};
  if (elf_read_firmware(image.c_str(), &firmware) != 0) return "libsimavr cannot read the ELF file";
  firmware.frequency = board.clock_hz;
  avr_t* const avr = avr_make_mcu_by_name(board.chip->compiler_name);
  avr_init(avr);
  avr_load_firmware(avr, &firmware);
  avr->log = LOG_NONE;
  avr->sleep = [](avr_t*, avr_cycle_count_t) {};
  std::uint32_t quiet = 0;
  avr_ioctl(avr, AVR_IOCTL_UART_SET_FLAGS('0'), &quiet);
  const auto end = static_cast<avr_cycle_count_t>(length / kSecond) * board.clock_hz;
  int state = cpu_Running;
  while (avr->cycle < end && state != cpu_Done && state != cpu_Crashed) state = avr_run(avr);
  const bool ended = avr->cycle >= end;
  avr_terminate(avr);
  std::free(avr);
  return ended ? "" : "libsimavr has stopped";
}

void against_libsimavr(benchmark::State& state, const std::filesystem::path& sketch, SimTime length) {
  const map::Map map = map::read_map(map::find_map("oval"));
  const robot::Description robot = robot::load_description("uno5");
  build::Request request{sketch, *robot.board};
  request.target = "avr";
  const auto image = build::build(request).image;
  double ours = 0, theirs = 0;
  for (auto _ : state) {
    const double begin = processor_time();
    std::string why = run_ours(image, map, robot, length);
    const double between = processor_time();
    if (why.empty()) why = run_libsimavr(image, *robot.board, length);
    if (!why.empty()) state.SkipWithError(why.c_str());
    ours += between - begin;
    theirs += processor_time() - between;
  }
  state.counters["times_libsimavr"] = theirs / ours;
}

void add(const char* name, const std::filesystem::path& sketch, SimTime length) {
  benchmark::RegisterBenchmark(name, against_libsimavr, sketch, length)
      ->Iterations(1)
      ->Repetitions(5)
      ->ReportAggregatesOnly()
      ->Unit(benchmark::kMillisecond);
}

[[maybe_unused]] const bool added = [] {
  add("avr/against libsimavr, Computes", kSketches / "Computes", 5 * kSecond);
  add("avr/against libsimavr, ReadsAndDrives", kSketches / "ReadsAndDrives", 5 * kSecond);
  add("avr/against libsimavr, PidFollower", build::find_sketch("PidFollower"), 5 * kSecond);
  add("avr/against libsimavr, SleepsIdle", kSketches / "SleepsIdle", 30 * kSecond);
  add("avr/against libsimavr, SleepsDeep", kSketches / "SleepsDeep", 30 * kSecond);
  return true;
}();

}  // namespace
}  // namespace robosim
