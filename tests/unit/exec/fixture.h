// A test fixture that builds a sketch from a text, and runs it tick by tick on a host executor. Records the
// sketch's actions.
#pragma once

#include <gmock/gmock.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "sim/base/file.h"
#include "sim/build/sketch.h"
#include "sim/exec/host/host_executor.h"
#include "tests/support/temporary_folder.h"

namespace robosim::exec {

struct PinEvent {
  Pin pin;
  PinDrive drive;
  SimTime at;
};

class HostTest : public testing::Test, protected PinWatcher, protected SerialWatcher {
 protected:
  HostTest() { test::use_shared_cache(); }

  /// Builds `text` as Test.ino.
  std::filesystem::path build(const std::string& text) {
    std::filesystem::create_directories(folder_ / "Test");
    write_file(folder_ / "Test/Test.ino", text);
    build::Request request{folder_ / "Test", *find_board(board_name_)};
    request.sanitize = sanitize_;
    return build::build(request).image;
  }

  /// Builds `text`, creates an executor for the image, and switches the board on at time `t`.
  void start(const std::string& text, SimTime t = 0) {
    host_ = std::make_unique<HostExecutor>(*find_board(board_name_), build(text));
    host_->set_lateness(lateness_);
    for (Pin pin = 0; pin < 20; ++pin) board().watch(pin, *this);
    board().watch_serial(*this);
    host_->power_on(t);
    now_ = t;
  }

  RobotPort& board() { return host_->board(); }

  /// Runs the board tick by tick for `duration`.
  void run(SimTime duration) {
    for (const SimTime end = now_ + duration; now_ < end;) host_->run_until(now_ += kTick);
  }
  /// Returns the text that the sketch prints in `duration`.
  std::string output(const std::string& text, SimTime duration = kSecond) {
    start(text);
    run(duration);
    EXPECT_FALSE(host_->crash()) << host_->crash()->reason;
    return serial_;
  }

  /// Returns the printed lines as numbers.
  std::vector<long long> numbers() const {
    std::vector<long long> result;
    for (std::size_t at = 0, end = 0; (end = serial_.find("\r\n", at)) != std::string::npos; at = end + 2)
      result.push_back(std::stoll(serial_.substr(at, end - at)));
    return result;
  }

  /// Returns the times at which `pin` changed, beginning when it became an output.
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
  std::vector<Lateness> lateness_;
  bool sanitize_ = false;
  const test::TemporaryFolder temporary_;
  const std::filesystem::path folder_ = temporary_.path();
  std::unique_ptr<HostExecutor> host_;
  SimTime now_ = 0;
  std::string serial_;
  std::vector<SimTime> byte_times_;
  std::vector<PinEvent> pins_;
};

/// A constant voltage. Digital reads return high if it is at least 2.5 V.
class FixedSource : public PinSource {
 public:
  explicit FixedSource(double volts, double ohms = 0.0) : volts_(volts), ohms_(ohms) {}
  Source output(SimTime t, double) override {
    asked_at = t;
    return {volts_, ohms_};
  }
  bool level(SimTime t) override {
    asked_at = t;
    return volts_ >= 2.5;
  }
  void set(double volts) { volts_ = volts; }

  SimTime asked_at = -1;

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
