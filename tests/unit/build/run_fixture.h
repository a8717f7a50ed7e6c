// A test fixture that compiles sketches, and runs them on a board without a robot. The analog pins have a
// constant voltage.
#pragma once

#include <memory>
#include <string>

#include "sim/exec/host/host_executor.h"
#include "tests/unit/build/fixture.h"

namespace robosim::build {

struct SerialText final : SerialWatcher {
  void byte_sent(uint8_t byte, SimTime) override {
    if (byte != '\r') text += static_cast<char>(byte);
  }
  std::string text;
};

struct ConstantVolts final : PinSource {
  explicit ConstantVolts(double v) : value(v) {}
  Source output(SimTime, double) override { return value; }
  bool level(SimTime) override { return value > 2.5; }
  double value;
};

class RunTest : public SketchTest {
 protected:
  /// Runs the sketch `name` of the folder `sketches`. Returns its serial output.
  std::string run_sketch(const std::string& name, SimTime duration = 200 * kMillisecond) {
    return run_image(build({std::filesystem::path(SKETCHES) / name, board_}).image, duration);
  }

  std::string run_code(const std::string& code, SimTime duration = 200 * kMillisecond) {
    write("Run/Run.ino", code);
    return run_image(build({folder_ / "Run", board_}).image, duration);
  }

  std::string run_image(const std::filesystem::path& image, SimTime duration) {
    serial_.text.clear();
    executor_ = std::make_unique<exec::HostExecutor>(board_, image);
    executor_->board().watch_serial(serial_);
    for (Pin pin = 14; pin < 20; ++pin) executor_->board().connect(pin, volts_);
    executor_->power_on(0);
    for (SimTime t = 0; t < duration; t += kTick) executor_->run_until(t + kTick);
    if (executor_->crash())
      ADD_FAILURE() << executor_->crash()->reason << " " << executor_->crash()->where.line;
    return serial_.text;
  }

  BoardSpec board_ = *find_board("uno");
  ConstantVolts volts_{2.5};
  SerialText serial_;
  std::unique_ptr<exec::HostExecutor> executor_;
};

}  // namespace robosim::build
