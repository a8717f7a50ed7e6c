// Whole runs on the target avr are the same, whether loops that wait are left out or not: the chip at each
// tick, and the trace.
#include <gtest/gtest.h>
#include <stdlib.h>

#include <string_view>
#include <vector>

#include "sim/avr/chip.h"
#include "sim/build/sketch.h"
#include "sim/exec/avr/avr_executor.h"
#include "sim/robot/description.h"
#include "sim/run/simulation.h"
#include "tests/support/require_target.h"

namespace robosim::run {
namespace {

struct Case {
  const char* sketch;
  const char* robot;
  const char* map;
  SimTime limit;
};

/// Notes at each tick what the chip holds.
class Notes final : public Listener {
 public:
  explicit Notes(const exec::AvrExecutor& executor) : executor_(executor) {}

  void sampled(const Sample&) override {
    const avr::Chip* chip = executor_.chip();
    if (!chip) return;
    const avr::Cpu& cpu = chip->cpu();
    const avr::Cpu::State& state = cpu.state;
    std::uint64_t sum = 1469598103934665603u;
    const auto add = [&](std::uint64_t value) { sum = (sum ^ value) * 1099511628211u; };
    for (const std::uint64_t value : {state.cycle, state.last_io, state.handler_cycles}) add(value);
    for (const std::uint64_t value : {state.pc, state.last_io_pc, state.jump_count}) add(value);
    add(state.sp);
    add(state.sreg);
    for (const std::uint32_t jump : state.jumps) add(jump);
    for (const std::uint8_t byte : cpu.data) add(byte);
    ticks.push_back(sum);
    skipped = chip->idle().skipped();
    cycles = chip->cycle();
  }

  std::vector<std::uint64_t> ticks;  ///< what the chip held, in a number
  avr::Cycle skipped = 0, cycles = 0;

 private:
  const exec::AvrExecutor& executor_;
};

class WaitingLoopsOfRuns : public testing::TestWithParam<Case> {
 protected:
  void SetUp() override {
    ROBOSIM_NEEDS_TARGET("avr");
    ::setenv("XDG_CACHE_HOME", (testing::TempDir() + "robosim-test-cache").c_str(), 1);
  }
};

TEST_P(WaitingLoopsOfRuns, AreLeftOutWithoutATrace) {
  const Case& what = GetParam();
  const grid::Map map = grid::read_map(grid::find_map(what.map));
  const robot::Description robot = robot::load_description(what.robot);
  build::Request request{std::filesystem::path(ROBOSIM_EXAMPLES) / what.sketch, *robot.board};
  request.target = "avr";
  const std::filesystem::path image = build::build(request).image;
  const auto run = [&](exec::AvrExecutor& executor, Notes& notes) {
    run::Setup setup;
    setup.map = &map;
    setup.agents = {{.robot = &robot, .executor = &executor, .listener = &notes}};
    setup.limit = what.limit;
    setup.samples_every = kTick;
    return simulate(setup).front().trace_hash;
  };
  exec::AvrExecutor skips(*robot.board, image), runs(*robot.board, image);
  runs.run_waiting_loops();
  Notes notes_of_skips(skips), notes_of_runs(runs);
  EXPECT_EQ(run(skips, notes_of_skips), run(runs, notes_of_runs));
  ASSERT_EQ(notes_of_skips.ticks.size(), notes_of_runs.ticks.size());
  for (std::size_t tick = 0; tick < notes_of_skips.ticks.size(); ++tick)
    ASSERT_EQ(notes_of_skips.ticks[tick], notes_of_runs.ticks[tick]) << "after " << tick << " ms";
  // Pony paces itself by delayMicroseconds() alone.
  const bool only_counts_down = std::string_view("PonyNavigator") == what.sketch;
  EXPECT_TRUE(only_counts_down || notes_of_skips.skipped > notes_of_skips.cycles / 4);
  EXPECT_EQ(notes_of_runs.skipped, 0u);
}

INSTANTIATE_TEST_SUITE_P(Stock, WaitingLoopsOfRuns,
                         testing::Values(Case{"PidFollower", "uno5", "oval", 3 * kSecond},
                                         Case{"LeftPath", "uno3", "d", 3 * kSecond},
                                         Case{"RightPath", "uno3", "a", 3 * kSecond},
                                         Case{"AiNavigator", "uno5", "b", 3 * kSecond},
                                         Case{"PonyNavigator", "pony", "city", 3 * kSecond}),
                         [](const auto& parameter) { return std::string(parameter.param.sketch); });

}  // namespace
}  // namespace robosim::run
