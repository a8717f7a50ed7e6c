// Tests that skipping busy-wait loops on target avr changes neither the chip's state at any tick nor the
// trace.
#include <gtest/gtest.h>

#include <string_view>

#include "sim/exec/avr/avr_executor.h"
#include "sim/mcu/avr/chip.h"
#include "tests/support/noted_run.h"
#include "tests/support/require_target.h"

namespace robosim::run {
namespace waiting_test {

std::uint64_t sum_of(const avr::Chip& chip) {
  const avr::Cpu& cpu = chip.cpu();
  const avr::Cpu::State& state = cpu.state;
  Sum sum;
  for (const std::uint64_t value : {state.cycle, state.last_io, state.handler_cycles}) sum.add(value);
  for (const std::uint64_t value : {state.pc, state.last_io_pc, state.jump_count}) sum.add(value);
  sum.add(state.sp);
  sum.add(state.sreg);
  for (const std::uint32_t jump : state.jumps) sum.add(jump);
  for (const std::uint8_t byte : cpu.data) sum.add(byte);
  return sum.value();
}

class WaitingLoopsOfRuns : public testing::TestWithParam<StockRun> {
 protected:
  void SetUp() override { ROBOSIM_NEEDS_TARGET("avr"); }
};

TEST_P(WaitingLoopsOfRuns, AreLeftOutWithoutATrace) {
  const StockRun& what = GetParam();
  const std::filesystem::path image = NotedRun::image_of(what, "avr");
  const BoardSpec& board = *robot::load_description(what.robot).board;
  exec::AvrExecutor skips(board, image), runs(board, image);
  runs.run_waiting_loops();
  avr::Cycle skipped = 0, cycles = 0;
  const NotedRun skipping(what, skips, [&] {
    if (const avr::Chip* chip = skips.chip()) {
      skipped = chip->idle().skipped();
      cycles = chip->cycle();
    }
    return skips.chip() ? sum_of(*skips.chip()) : 0;
  });
  const NotedRun running(what, runs, [&] { return runs.chip() ? sum_of(*runs.chip()) : 0; });
  expect_same(skipping, running);
  // PonyNavigator waits only in the counting loops of delayMicroseconds(), so less may be skipped.
  const bool only_counts_down = std::string_view("PonyNavigator") == what.sketch;
  EXPECT_TRUE(only_counts_down || skipped > cycles / 4);
}

INSTANTIATE_TEST_SUITE_P(Stock, WaitingLoopsOfRuns,
                         testing::Values(StockRun{"PidFollower", "uno5", "oval", 3 * kSecond},
                                         StockRun{"LeftPath", "uno3", "d", 3 * kSecond},
                                         StockRun{"RightPath", "uno3", "a", 3 * kSecond},
                                         StockRun{"AiNavigator", "uno5", "b", 3 * kSecond},
                                         StockRun{"PonyNavigator", "pony", "city", 3 * kSecond}),
                         [](const auto& parameter) { return std::string(parameter.param.sketch); });

}  // namespace waiting_test
}  // namespace robosim::run
