// Whole runs on the target stm32 are the same, whether loops that wait are left out or not: the chip at each
// tick, and the trace.
#include <gtest/gtest.h>

#include "sim/exec/stm32/machine.h"
#include "sim/exec/stm32/stm32_executor.h"
#include "tests/support/noted_run.h"
#include "tests/support/require_target.h"

namespace robosim::run {
namespace {

using exec::stm32::Machine;

std::uint64_t sum_of(const Machine& machine) {
  using namespace robosim::stm32;
  const auto& cpu = machine.cpu();
  Sum sum;
  for (int number = 0; number < 15; ++number) sum.add(cpu.reg(number));
  for (const std::uint32_t value : {cpu.status(), cpu.pc(), cpu.next_pc(), cpu.last_io_pc(), cpu.lowest_sp()})
    sum.add(value);
  for (const std::uint64_t value : {machine.bus().link().clock.now, cpu.last_io(), cpu.handler_cycles(),
                                    cpu.sleep_cycles(), machine.bus().ports().last_read_at()})
    sum.add(value);
  sum.add(cpu.rounds().count());
  sum.add(static_cast<std::uint64_t>(cpu.rounds().total()));
  sum.add(static_cast<std::uint64_t>(cpu.rounds().longest(0)));
  for (const std::uint32_t jump : cpu.last_jumps()) sum.add(jump);
  for (Address at = kRam; at < kRam + kRamBytes; at += 4) sum.add(cpu.word(at));
  return sum.value();
}

struct Case : StockRun {
  bool waits;  ///< in loops, not asleep as in delay()
};

class WaitingLoopsOfPills : public testing::TestWithParam<Case> {
 protected:
  void SetUp() override { ROBOSIM_NEEDS_TARGET("stm32"); }
};

TEST_P(WaitingLoopsOfPills, AreLeftOutWithoutATrace) {
  const Case& what = GetParam();
  const std::filesystem::path image = NotedRun::image_of(what, "stm32");
  const BoardSpec& board = *robot::load_description(what.robot).board;
  exec::Stm32Executor skips(board, image), runs(board, image);
  runs.run_waiting_loops();
  exec::stm32::Cycle skipped = 0, cycles = 0;
  const auto note_of = [](exec::Stm32Executor& executor) {
    return executor.machine() ? sum_of(*executor.machine()) : 0;
  };
  const NotedRun skipping(what, skips, [&] {
    if (const Machine* machine = skips.machine()) {
      skipped = machine->cpu().idle().skipped();
      cycles = machine->bus().link().clock.now;
    }
    return note_of(skips);
  });
  const NotedRun running(what, runs, [&] { return note_of(runs); });
  expect_same(skipping, running);
  EXPECT_TRUE(!what.waits || skipped > cycles / 4);
}

INSTANTIATE_TEST_SUITE_P(Stock, WaitingLoopsOfPills,
                         testing::Values(Case{{"PidFollower", "bluepill5", "oval", 2 * kSecond}, false},
                                         Case{{"LeftPath", "bluepill3", "d", 2 * kSecond}, false},
                                         Case{{"RightPath", "bluepill3", "a", 2 * kSecond}, false},
                                         Case{{"AiNavigator", "bluepill5", "b", kSecond}, true},
                                         Case{{"PonyNavigator", "bluepony", "city", 2 * kSecond}, false}),
                         [](const auto& parameter) { return std::string(parameter.param.sketch); });

}  // namespace
}  // namespace robosim::run
