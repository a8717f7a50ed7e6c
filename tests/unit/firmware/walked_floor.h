// Simulates a floor with lines, and bodies that move on it. Robot is an ideal robot for LineWalker: its
// motors reach the commanded speed immediately, and its encoders never miss a count. x is the distance ahead
// of the start, and y the distance to the right, both in mm. Angles are clockwise, in radians.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <utility>
#include <vector>

#include "LineWalker.h"

namespace walked {

struct Line {
  double x1, y1, x2, y2;  ///< ends of the centre line
};

/// The pins to which Robot's parts are connected.
enum : std::uint8_t {
  kLeftPwm = 3,
  kLeft1,
  kLeft2,
  kRightPwm,
  kRight1,
  kRight2,
  kLeftCounts,
  kRightCounts,
  kBumper
};

/// A body that moves on the floor.
class Body {
 public:
  Body(std::vector<Line> lines, std::uint8_t bumper_pin) : lines_(std::move(lines)), bumper_pin_(bumper_pin) {
    fake::board = fake::Board{};
    fake::board.pins[bumper_pin_].reads = HIGH;
    fake::board.on_wait = [this] { move(); };
  }
  virtual ~Body() { fake::board = fake::Board{}; }

  double x = 0, y = 0, angle = 0;
  /// The x of a wall, in mm. The bumper is pressed while the robot's front is at this x or beyond, at most
  /// for `wall_ms`.
  double wall_x = 1e9;
  std::uint32_t wall_ms = 1000000;

  /// Returns the reading of a sensor, from 0 (floor) to 1000 (line). The sensor is `ahead` mm ahead of the
  /// axle, and `aside` mm to the right.
  int darkness(double ahead, double aside) const {
    const double at_x = x + ahead * std::cos(angle) - aside * std::sin(angle);
    const double at_y = y + ahead * std::sin(angle) + aside * std::cos(angle);
    double nearest = 1e9;  // square of the distance
    for (const Line& line : lines_) {
      const double dx = line.x2 - line.x1, dy = line.y2 - line.y1;
      double t = ((at_x - line.x1) * dx + (at_y - line.y1) * dy) / (dx * dx + dy * dy);
      t = t < 0 ? 0 : t > 1 ? 1 : t;
      const double off_x = at_x - line.x1 - t * dx, off_y = at_y - line.y1 - t * dy;
      nearest = std::min(nearest, off_x * off_x + off_y * off_y);
    }
    const double dark = (14 - std::sqrt(nearest)) / 8;  // 1 up to 6 mm from the centre line, 0 from 14 mm
    return static_cast<int>(1000 * (dark < 0 ? 0 : dark > 1 ? 1 : dark));
  }

 protected:
  static constexpr std::uint32_t kPieceUs = 1000;
  static constexpr double kPieceS = 1e-6 * kPieceUs;

  /// Calls go() with the speeds of the wheels, in mm/s. go() moves the body for the next kPieceUs
  /// microseconds.
  virtual void drive() = 0;
  void go(double left, double right) {
    const double ds = (left + right) / 2 * kPieceS;
    x += ds * std::cos(angle);
    y += ds * std::sin(angle);
    angle += (left - right) / 98 * kPieceS;
  }

 private:
  void move() {
    const std::uint32_t now = fake::board.now_us;
    if (now > 120'000'000) throw std::runtime_error("it drives for ever");
    for (; now_us_ + kPieceUs <= now; now_us_ += kPieceUs) {
      drive();
      if (x + 80 * std::cos(angle) < wall_x) free_us_ = now_us_;
      const bool pressed = now_us_ != free_us_ && now_us_ - free_us_ < std::uint64_t{1000} * wall_ms;
      fake::board.pins[bumper_pin_].reads = pressed ? LOW : HIGH;
    }
  }

  std::vector<Line> lines_;
  std::uint8_t bumper_pin_;
  std::uint32_t now_us_ = 0, free_us_ = 0;
};

class Robot : public Body {
 public:
  explicit Robot(std::vector<Line> lines) : Body(std::move(lines), kBumper) {}

  double left_wheel = 1, right_wheel = 1;  ///< actual speed as a share of the commanded speed
  std::uint32_t reading_us = 0;            ///< time for reading the sensors

 private:
  void drive() override {
    const double left = speed(kLeftPwm, kLeft1) * left_wheel, right = speed(kRightPwm, kRight1) * right_wheel;
    go(left, right);
    count(left_counts_, left, kLeftCounts);
    count(right_counts_, right, kRightCounts);
  }
  static double speed(std::uint8_t pwm, std::uint8_t in1) {
    const fake::Pin* pins = fake::board.pins;
    if (pins[in1].level == pins[in1 + 1].level || pins[pwm].duty <= 20) return 0;
    const double size = (pins[pwm].duty - 20) / 235.0 * 1275;
    return pins[in1].level == HIGH ? size : -size;
  }
  static void count(double& counts, double speed, std::uint8_t pin) {
    const double before = std::floor(counts);
    counts += std::fabs(speed) * kPieceS / (0.5 * 3.14159265 * 32 / 154.35);
    if (std::floor(counts) != before && fake::board.pins[pin].handler) fake::board.pins[pin].handler();
  }

  double left_counts_ = 0.5, right_counts_ = 0.5;
};

}  // namespace walked
