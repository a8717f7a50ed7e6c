// Tests two detectors: motors that were left on (sim/detect/motors_left_on.h), and slow Serial output
// (sim/detect/slow_serial.h). The tests implement the firmware that drives the robots.

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <functional>

#include "hal/board/board_spec.h"
#include "sim/exec/core/board_state.h"
#include "tests/support/fake_firmware.h"
#include "tests/support/one_robot.h"

namespace robosim::detect::steering_detectors_test {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

constexpr Pin kSensors[] = {14, 15, 16, 17, 18};  // from the left

/// Firmware that calls `step` once per millisecond.
class Driven : public test::FakeFirmware {
 public:
  using Step = std::function<void(Driven&, SimTime)>;
  explicit Driven(Step step) : step_(std::move(step)) {}

  void run_until(SimTime t) override {
    for (; next_ < t; next_ += kMillisecond) step_(*this, next_);
  }
  exec::Activity activity() override { return {0, call, kNoPin, kNoPin, {"loop", "A.ino", 9}, ""}; }
  SimTime last_call() const override { return next_; }

  void drive(double left, double right) { FakeFirmware::drive(left, right, next_); }
  /// Reads the sensors. Returns whether each sensor is dark, from left to right.
  std::array<bool, 5> look(SimTime t) {
    std::array<bool, 5> dark{};
    for (std::size_t i = 0; i < dark.size(); ++i) dark[i] = board_.read_volts(kSensors[i], t) > 2.5;
    return dark;
  }
  void send(std::uint8_t byte, SimTime t) { board_.send_byte(byte, t); }

  std::string call;
  SimTime now = 0;

 private:
  SimTime next_ = 0;
  Step step_;
};

std::vector<result::Detected> seen(Driven::Step step, SimTime limit = 10 * kSecond) {
  Driven firmware(std::move(step));
  test::OneRobot one(firmware, "");
  one.setup.detect = true;
  return one.run(limit).detected;
}

/// Returns a step that steers to the right until no sensor sees the line, and then calls `after`. The line is
/// then to the left of the sensors.
Driven::Step leaves_to_the_right(std::function<void(Driven&, SimTime since)> after) {
  SimTime lost_at = -1;
  return [after, lost_at](Driven& robot, SimTime t) mutable {
    if (lost_at < 0 || t - lost_at < 50 * kMillisecond) {
      const auto dark = robot.look(t);
      const bool sees = std::find(dark.begin(), dark.end(), true) != dark.end();
      if (lost_at < 0 && !sees && t > 20 * kMillisecond) lost_at = t;
      robot.drive(0.4, 0.25);
    }
    robot.now = t;
    if (lost_at >= 0) after(robot, t - lost_at);
  };
}

TEST(MotorsLeftOn, IsWhoStopsSteeringAndNotItsMotors) {
  const auto found = seen(leaves_to_the_right([](Driven& robot, SimTime) { robot.drive(0.3, 0.4); }));
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_EQ(found[0].detector, "motors_left_on");
  EXPECT_THAT(found[0].what, HasSubstr("no longer read any line sensor"));
}

TEST(MotorsLeftOn, IsNobodyWhoStopsItsMotors) {
  EXPECT_THAT(seen(leaves_to_the_right([](Driven& robot, SimTime) { robot.drive(0.0, 0.0); })), IsEmpty());
}

TEST(MotorsLeftOn, IsNobodyWhoStillLooksOrWaits) {
  EXPECT_THAT(seen(leaves_to_the_right([](Driven& robot, SimTime) {
                robot.look(robot.now);
                robot.drive(0.3, 0.4);
              })),
              IsEmpty());
  EXPECT_THAT(seen(leaves_to_the_right([](Driven& robot, SimTime) {
                robot.call = "delay()";
                robot.drive(0.3, 0.4);
              })),
              IsEmpty());
}

TEST(MotorsLeftOn, IsNobodyWhoSearchesByPlan) {
  EXPECT_THAT(seen(leaves_to_the_right([](Driven& robot, SimTime since) {
                const double more = 0.2 * static_cast<double>(since / (200 * kMillisecond) % 2);
                robot.drive(0.2 + more, 0.5);
              })),
              IsEmpty());
}

/// Returns a step that reads the sensors once per `every`. If `drives` is true, it roughly follows the line.
/// In each millisecond, the step sends a byte, and the firmware reports that it executes `call`.
Driven::Step sends(SimTime every, const char* call, bool drives = true) {
  return [=](Driven& robot, SimTime t) {
    robot.call = call;
    robot.send('x', t);
    if (t % every != 0) return;
    const auto dark = robot.look(t);
    const double turn = dark[0] || dark[1] ? -0.1 : dark[3] || dark[4] ? 0.1 : 0.0;
    if (drives) robot.drive(0.15 + turn, 0.15 - turn);
  };
}

TEST(SlowSerial, IsWhoLooksAsOftenAsSerialHasRoom) {
  const auto found = seen(sends(35 * kMillisecond, "println()"), 5 * kSecond);
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_EQ(found[0].detector, "slow_serial");
  EXPECT_EQ(found[0].where.line, 9);
  EXPECT_THAT(found[0].what, HasSubstr("println() waited for room: for up to 35 ms"));
}

TEST(SlowSerial, IsNobodyWhoLooksInTimeOrIsKeptBySomethingElse) {
  EXPECT_THAT(seen(sends(10 * kMillisecond, "println()"), 5 * kSecond), IsEmpty());
  EXPECT_THAT(seen(sends(35 * kMillisecond, "delay()"), 5 * kSecond), IsEmpty());
  EXPECT_THAT(seen(sends(35 * kMillisecond, "println()", false), 5 * kSecond), IsEmpty());
}

}  // namespace robosim::detect::steering_detectors_test
