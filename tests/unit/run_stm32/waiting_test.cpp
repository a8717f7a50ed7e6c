// Tests that skipping busy-wait loops on target stm32 changes neither the chip's state at any tick nor the
// trace.
#include <gtest/gtest.h>

#include "sim/exec/stm32/stm32_executor.h"
#include "tests/support/noted_run.h"
#include "tests/support/require_target.h"
#include "tests/support/stm32_sum.h"

namespace robosim::run {
namespace waiting_test {

using exec::stm32::Machine;

struct PillRun : StockRun {
  bool waits;  ///< whether the sketch waits in loops, instead of sleeping as delay() does
};

class WaitingLoopsOfPills : public testing::TestWithParam<PillRun> {
 protected:
  void SetUp() override { ROBOSIM_NEEDS_TARGET("stm32"); }
};

TEST_P(WaitingLoopsOfPills, AreLeftOutWithoutATrace) {
  const PillRun& what = GetParam();
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
                         testing::Values(PillRun{{"PidFollower", "bluepill5", "oval", 2 * kSecond}, false},
                                         PillRun{{"LeftPath", "bluepill3", "d", 2 * kSecond}, false},
                                         PillRun{{"RightPath", "bluepill3", "a", 2 * kSecond}, false},
                                         PillRun{{"AiNavigator", "bluepill5", "b", kSecond}, true},
                                         PillRun{{"PonyNavigator", "bluepony", "city", 2 * kSecond}, false}),
                         [](const auto& parameter) { return std::string(parameter.param.sketch); });

}  // namespace waiting_test
}  // namespace robosim::run
