// Tests that skipping busy-wait loops on a chip changes neither the chip's state at any tick nor the trace.
#include <gtest/gtest.h>

#include "tests/support/noted_run.h"
#include "tests/support/require_target.h"
#include "tests/unit/targets/target.h"

namespace robosim::run::waiting_test {

struct Waiting {
  const char* target;
  StockRun run;
  bool waits;  ///< whether the sketch spends more than a quarter of the time in skippable wait loops
};

class WaitingLoopsOfRuns : public testing::TestWithParam<Waiting> {};

TEST_P(WaitingLoopsOfRuns, AreLeftOutWithoutATrace) {
  const exec::Target* const target = exec::find_target(GetParam().target);
  if (!target) GTEST_SKIP() << GetParam().target << " was left out";
  ROBOSIM_NEEDS_TARGET(target->name);
  const StockRun& what = GetParam().run;
  const std::filesystem::path image = NotedRun::image_of(what, target->name);
  const BoardSpec& board = *robot::load_description(what.robot).board;
  const auto skips = target->make_executor(board, image), runs = target->make_executor(board, image);
  target->run_waiting_loops(*runs);
  double skipped = 0.0;
  const NotedRun skipping(what, *skips, [&] {
    const std::uint64_t state = target->state_of(*skips);
    if (state != 0) skipped = target->skipped_share(*skips);
    return state;
  });
  const NotedRun running(what, *runs, [&] { return target->state_of(*runs); });
  expect_same(skipping, running);
  EXPECT_TRUE(!GetParam().waits || skipped > 0.25);
}

// On the AVR, PonyNavigator waits only in the counting loops of delayMicroseconds(). On the STM32, delay()
// sleeps, so that only AiNavigator waits.
INSTANTIATE_TEST_SUITE_P(
    Stock, WaitingLoopsOfRuns,
    testing::Values(Waiting{"avr", {"PidFollower", "uno5", "oval", 3 * kSecond}, true},
                    Waiting{"avr", {"LeftPath", "uno3", "d", 3 * kSecond}, true},
                    Waiting{"avr", {"RightPath", "uno3", "a", 3 * kSecond}, true},
                    Waiting{"avr", {"AiNavigator", "uno5", "b", 3 * kSecond}, true},
                    Waiting{"avr", {"PonyNavigator", "pony", "city", 3 * kSecond}, false},
                    Waiting{"stm32", {"PidFollower", "bluepill5", "oval", 2 * kSecond}, false},
                    Waiting{"stm32", {"LeftPath", "bluepill3", "d", 2 * kSecond}, false},
                    Waiting{"stm32", {"RightPath", "bluepill3", "a", 2 * kSecond}, false},
                    Waiting{"stm32", {"AiNavigator", "bluepill5", "b", kSecond}, true},
                    Waiting{"stm32", {"PonyNavigator", "bluepony", "city", 2 * kSecond}, false}),
    [](const auto& test) { return std::string(test.param.run.sketch) + "_" + test.param.target; });

}  // namespace robosim::run::waiting_test
