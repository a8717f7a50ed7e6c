// Runs the line follower LineWalker on a simulated floor, and records the landmarks that LineWalker reports.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "LineWalker.h"
#include "walked_floor.h"

namespace walked {

inline constexpr std::uint8_t kLineSensorPins[] = {14, 15, 16, 17, 18};

class FloorSensors : public LineSensors {
 public:
  explicit FloorSensors(const Robot& robot) : LineSensors(kLineSensorPins, 5, 0, 1000), robot_(robot) {}

 protected:
  void beginPin(std::uint8_t pin) override { pinMode(pin, INPUT); }
  void readRaw(std::uint16_t* raw) override {
    delayMicroseconds(robot_.reading_us);
    for (int i = 0; i < 5; ++i) raw[i] = static_cast<std::uint16_t>(robot_.darkness(70, (i - 2) * 9.525));
  }

 private:
  const Robot& robot_;
};

/// A LineWalker on a floor. Records the pauses of LineWalker, and each landmark with the time and the axle's
/// position.
struct Walk {
  explicit Walk(std::vector<Line> lines) : robot(std::move(lines)) {
    said.clear();
    walker.setOnPause([](bool stands) { said += stands ? "stands; " : "goes on; "; });
    encoders.setDirections(1, 1);
    walker.setup();
    encoders.takeLeft();
    encoders.takeRight();
  }

  void tell(const nav::Landmark& met) {
    static const char* const kinds[] = {"line", "junction", "end", "blocked", "loop", "lost"};
    std::string arms;
    for (int i = 0; i < 4; ++i) arms += met.arms >> i & 1 ? '1' : '0';
    char text[160];
    std::snprintf(
        text, sizeof text, "%s %s, heading %d at %d,%d, cost %d; axle at %.1f,%.1f, %.2f rad, %u ms\n",
        kinds[static_cast<int>(met.kind)], arms.c_str(), met.heading, static_cast<int>(met.at.x),
        static_cast<int>(met.at.y), static_cast<int>(met.cost), std::lround(10 * robot.x) / 10.0,
        std::lround(10 * robot.y) / 10.0, robot.angle, static_cast<unsigned>(fake::board.now_us / 1000));
    said += text;
  }
  /// Finds the line and follows it to a landmark. At each landmark, makes the next of `turns`, and follows
  /// the line to the next landmark.
  void go(const std::vector<nav::Turn>& turns) {
    tell(walker.begin());
    tell(walker.follow());
    for (const nav::Turn turn : turns) {
      walker.leave(turn);
      tell(walker.follow());
    }
  }

  Robot robot;
  FloorSensors sensors{robot};
  DriveMotors motors{DriveMotor(kLeftPwm, kLeft1, kLeft2), DriveMotor(kRightPwm, kRight1, kRight2)};
  WheelEncoders encoders{kLeftCounts, kRightCounts};
  LineWalker walker{sensors, motors, encoders, kBumper};
  inline static std::string said;
};

inline constexpr nav::Turn kOn = nav::Turn::straight, kRight = nav::Turn::right, kBack = nav::Turn::back,
                           kLeft = nav::Turn::left;
inline const Line kTrunk{-300, 0, 600, 0};

}  // namespace walked
