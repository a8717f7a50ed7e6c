// A test fixture that builds a sketch from a text, and runs it tick by tick on the executor of a target.
// Records the sketch's actions. tests/unit/targets/hello_world_test.cpp is an introduction.
#pragma once

#include <gmock/gmock.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "sim/base/file.h"
#include "sim/build/sketch.h"
#include "sim/exec/core/executor.h"
#include "tests/support/require_target.h"
#include "tests/support/temporary_folder.h"

namespace robosim::exec {

struct PinEvent {
  Pin pin;
  PinDrive drive;
  SimTime at;
};

class SketchTest : public testing::Test, protected PinWatcher, protected SerialWatcher {
 protected:
  SketchTest(const char* target, const char* board) : target_(target), board_name_(board) {}
  void SetUp() override {
    ROBOSIM_NEEDS_TARGET(target_);
    test::use_shared_cache();
  }

  virtual std::unique_ptr<Executor> make_executor(const BoardSpec& board,
                                                  const std::filesystem::path& image) = 0;
  virtual void before_power_on() {}

  /// Builds `text` as Test.ino.
  std::filesystem::path build(const std::string& text) {
    std::filesystem::create_directories(folder_ / "Test");
    write_file(folder_ / "Test/Test.ino", text);
    build::Request request{folder_ / "Test", *find_board(board_name_)};
    request.target = target_;
    request.sanitize = sanitize_;
    built_ = build::build(request);
    return built_.image;
  }

  /// Builds `text`, creates an executor for the image, and switches the board on at time `t`.
  void start(const std::string& text, SimTime t = 0) { start_image(build(text), t); }
  void start_image(const std::filesystem::path& image, SimTime t = 0) {
    executor_ = make_executor(*find_board(board_name_), image);
    for (Pin pin = 0; pin < board().spec().pin_count; ++pin) board().watch(pin, *this);
    board().watch_serial(*this);
    before_power_on();
    executor_->power_on(t);
    now_ = t;
    serial_.clear();
    byte_times_.clear();
    pins_.clear();
  }

  RobotPort& board() { return executor_->board(); }
  /// Returns the number of a pin of the board, such as "A3".
  Pin pin(const char* name) { return find_pin(board().spec(), name); }

  /// Runs the board tick by tick for `duration`.
  void run(SimTime duration) {
    for (const SimTime end = now_ + duration; now_ < end;) executor_->run_until(now_ += kTick);
  }
  /// Returns the text that the sketch prints in `duration`.
  std::string output(const std::string& text, SimTime duration = kSecond) {
    start(text);
    run(duration);
    EXPECT_FALSE(executor_->crash()) << executor_->crash()->reason;
    return serial_;
  }
  /// Returns the numbers that `statements` print in setup(), one in each line.
  std::vector<long long> printed(const std::string& statements) {
    output("void setup() {\nSerial.begin(115200);" + statements + "\n}\nvoid loop() {}\n");
    return numbers();
  }

  /// Returns the printed lines as numbers.
  std::vector<long long> numbers() const {
    std::vector<long long> result;
    for (std::size_t at = 0, end = 0; (end = serial_.find("\r\n", at)) != std::string::npos; at = end + 2)
      result.push_back(std::stoll(serial_.substr(at, end - at)));
    return result;
  }
  /// Returns the times at which `pin` changed. Usually, the first change makes the pin an output.
  std::vector<SimTime> changes(Pin pin) const {
    std::vector<SimTime> times;
    for (const PinEvent& event : pins_)
      if (event.pin == pin) times.push_back(event.at);
    return times;
  }

  void pin_changed(Pin pin, const PinDrive& drive, SimTime t) override { pins_.push_back({pin, drive, t}); }
  void byte_sent(std::uint8_t byte, SimTime t) override {
    serial_ += static_cast<char>(byte);
    byte_times_.push_back(t);
  }

  const char *target_, *board_name_;
  bool sanitize_ = false;
  const test::TemporaryFolder temporary_;
  const std::filesystem::path folder_ = temporary_.path();
  build::Image built_;
  std::unique_ptr<Executor> executor_;
  SimTime now_ = 0;
  std::string serial_;
  std::vector<SimTime> byte_times_;
  std::vector<PinEvent> pins_;
};

/// A constant voltage. Digital reads return high if it is at least 2.5 V. Records the times of all reads.
class FixedSource : public PinSource {
 public:
  explicit FixedSource(double volts, double ohms = 0.0) : volts_(volts), ohms_(ohms) {}
  Source output(SimTime t, double) override {
    asked_at.push_back(t);
    return {volts_, ohms_};
  }
  bool level(SimTime t) override {
    asked_at.push_back(t);
    return volts_ >= 2.5;
  }
  void set(double volts) { volts_ = volts; }

  std::vector<SimTime> asked_at;

 private:
  double volts_, ohms_;
};

/// A source that is high from `begin` up to, but not including, `end`.
class Pulse : public PinSource {
 public:
  Pulse(SimTime begin, SimTime end) : begin_(begin), end_(end) {}
  bool level(SimTime t) override { return t >= begin_ && t < end_; }

 private:
  SimTime begin_, end_;
};

}  // namespace robosim::exec
