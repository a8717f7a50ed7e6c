// A test fixture that builds a sketch from a text, with the original Arduino core. Runs the sketch tick by
// tick on an AVR executor, and records the sketch's actions.
#pragma once

#include <gmock/gmock.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "sim/base/file.h"
#include "sim/build/sketch.h"
#include "sim/exec/avr/avr_executor.h"
#include "tests/support/require_target.h"
#include "tests/support/temporary_folder.h"

namespace robosim::exec {

struct PinEvent {
  Pin pin;
  PinDrive drive;
  SimTime at;
};

class AvrTest : public testing::Test, protected PinWatcher, protected SerialWatcher {
 protected:
  void SetUp() override {
    ROBOSIM_NEEDS_TARGET("avr");
    test::use_shared_cache();
  }

  /// Builds `text` as Test.ino.
  std::filesystem::path build(const std::string& text) {
    std::filesystem::create_directories(folder_ / "Test");
    write_file(folder_ / "Test/Test.ino", text);
    build::Request request{folder_ / "Test", *find_board(board_name_)};
    request.target = "avr";
    request.sanitize = sanitize_;
    built_ = build::build(request);
    return built_.image;
  }

  /// Builds `text`, creates an executor for the image, and switches the board on at time 0.
  void start(const std::string& text) {
    avr_ = std::make_unique<AvrExecutor>(*find_board(board_name_), build(text), make_detectors_);
    for (Pin pin = 0; pin < board().spec().pin_count; ++pin) board().watch(pin, *this);
    board().watch_serial(*this);
    before_power_on();
    avr_->power_on(0);
    now_ = 0;
    serial_.clear();
    byte_times_.clear();
    pins_.clear();
  }

  virtual void before_power_on() {}

  RobotPort& board() { return avr_->board(); }

  void run(SimTime duration) {
    for (const SimTime end = now_ + duration; now_ < end;) avr_->run_until(now_ += kTick);
  }
  /// Returns the text that the sketch prints in `duration`.
  std::string output(const std::string& text, SimTime duration = 200 * kMillisecond) {
    start(text);
    run(duration);
    EXPECT_FALSE(avr_->crash()) << avr_->crash()->reason;
    return serial_;
  }
  /// Returns the printed lines as numbers.
  std::vector<long long> numbers() const {
    std::vector<long long> result;
    for (std::size_t at = 0, end = 0; (end = serial_.find("\r\n", at)) != std::string::npos; at = end + 2)
      result.push_back(std::stoll(serial_.substr(at, end - at)));
    return result;
  }
  /// Returns the times at which `pin` changed, including the time at which it became an output.
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

  const char* board_name_ = "uno";
  bool sanitize_ = false;
  MakeChipDetectors make_detectors_;  ///< creates the detectors that detect() turns on
  const test::TemporaryFolder temporary_;
  const std::filesystem::path folder_ = temporary_.path();
  build::Image built_;
  std::unique_ptr<AvrExecutor> avr_;
  SimTime now_ = 0;
  std::string serial_;
  std::vector<SimTime> byte_times_;
  std::vector<PinEvent> pins_;
};

/// A constant voltage, which reads as high from 2.5 V. Records the times of all reads.
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
