// A test fixture that runs sketches on an STM32 executor. Robosim's Arduino core for the Blue Pill is linked
// into these sketches.
#pragma once

#include <optional>

#include "sim/exec/stm32/stm32_executor.h"
#include "tests/support/sketch_test.h"

namespace robosim::exec {

class Stm32ChipTest : public SketchTest {
 protected:
  Stm32ChipTest() : SketchTest("stm32", "bluepill") {}
  std::unique_ptr<Executor> make_executor(const BoardSpec& board,
                                          const std::filesystem::path& image) override {
    auto chip = std::make_unique<Stm32Executor>(board, image);
    chip_ = chip.get();
    return chip;
  }

  /// Returns the crash of a sketch. The sketch executes `statement` on line 2, in a function that setup()
  /// calls.
  const std::optional<Crash>& crash_of(const std::string& statement, SimTime duration = kSecond) {
    start("volatile int n;\nvoid __attribute__((noinline)) work() { " + statement +
          " }\nvoid setup() { work(); }\nvoid loop() {}\n");
    run(duration);
    return chip_->crash();
  }

  Stm32Executor* chip_ = nullptr;
};

}  // namespace robosim::exec
