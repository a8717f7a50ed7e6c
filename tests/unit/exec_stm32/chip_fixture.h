// A test fixture that builds a sketch from a text, with Robosim's core for the Blue Pill. Runs the sketch
// tick by tick on an STM32 executor.
#pragma once

#include <gmock/gmock.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "sim/base/file.h"
#include "sim/build/sketch.h"
#include "sim/exec/stm32/stm32_executor.h"
#include "tests/support/require_target.h"
#include "tests/support/temporary_folder.h"

namespace robosim::exec {

class Stm32ChipTest : public testing::Test, protected SerialWatcher {
 protected:
  void SetUp() override {
    ROBOSIM_NEEDS_TARGET("stm32");
    test::use_shared_cache();
  }

  /// Builds `text` as Test.ino, and switches on a board with the image.
  void start(const std::string& text) {
    std::filesystem::create_directories(folder_ / "Test");
    write_file(folder_ / "Test/Test.ino", text);
    build::Request request{folder_ / "Test", *find_board(board_name_)};
    request.target = "stm32";
    chip_ = std::make_unique<Stm32Executor>(*find_board(board_name_), build::build(request).image);
    chip_->board().watch_serial(*this);
    before_power_on();
    if (clock_start_ > 0) chip_->set_clock_start(clock_start_);
    chip_->power_on(0);
    now_ = 0;
    serial_.clear();
  }
  virtual void before_power_on() {}
  void run(SimTime duration) {
    for (const SimTime end = now_ + duration; now_ < end;) chip_->run_until(now_ += kTick);
  }
  std::string output(const std::string& text, SimTime duration = 200 * kMillisecond) {
    start(text);
    run(duration);
    EXPECT_FALSE(chip_->crash()) << chip_->crash()->reason;
    return serial_;
  }
  /// Returns the crash of a sketch. The sketch executes `statement` on line 2, in a function that setup()
  /// calls.
  const std::optional<Crash>& crash_of(const std::string& statement, SimTime duration = kSecond) {
    start("volatile int n;\nvoid __attribute__((noinline)) work() { " + statement +
          " }\nvoid setup() { work(); }\nvoid loop() {}\n");
    run(duration);
    return chip_->crash();
  }
  void byte_sent(std::uint8_t byte, SimTime) override { serial_ += static_cast<char>(byte); }

  const char* board_name_ = "bluepill";
  SimTime clock_start_ = 0;
  const test::TemporaryFolder temporary_;
  const std::filesystem::path folder_ = temporary_.path();
  std::unique_ptr<Stm32Executor> chip_;
  SimTime now_ = 0;
  std::string serial_;
};

}  // namespace robosim::exec
