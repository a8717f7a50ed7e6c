// Tests the detection of robots that drive too long without reading a sensor (sim/detect/blind_driving.h).

#include <gmock/gmock.h>

#include "tests/support/built_in_driver.h"
#include "tests/support/fake_firmware.h"
#include "tests/support/one_robot.h"

namespace robosim::detect::blind_driving_test {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
using testing::StartsWith;

/// Firmware that drives straight on, and reads a sensor once per `looks_every`. If `plans` is true, it drives
/// at half power in the second half of each interval.
class Distracted : public test::FakeFirmware {
 public:
  Distracted(SimTime looks_every, bool plans) : looks_every_(looks_every), plans_(plans) {}

  void power_on(SimTime t) override { drive(1.0, 1.0, t); }
  void run_until(SimTime t) override {
    for (; next_ < t; next_ += kMillisecond) {
      if (next_ % looks_every_ == 0) board_.read_volts(kMiddle, next_);
      const double power = next_ % looks_every_ < looks_every_ / 2 ? 1.0 : 0.5;
      if (plans_) drive(power, power, next_);
    }
  }
  exec::Activity activity() override { return {0, call, kNoPin, kNoPin, {"loop", "A.ino", 9}, ""}; }
  SimTime last_call() const override { return next_; }
  std::string call = "delay(700)";

 protected:
  static constexpr Pin kMiddle = 16;

  SimTime next_ = 0;

 private:
  SimTime looks_every_;
  bool plans_;
};

/// Firmware that starts to drive after two seconds. Before that, it reads a sensor every millisecond. Its
/// last read of the sensor is `later` nanoseconds before the drive begins.
class Starts final : public Distracted {
 public:
  explicit Starts(SimTime later) : Distracted(kSecond, false), later_(later) {}
  void power_on(SimTime t) override { drive(0.0, 0.0, t); }
  void run_until(SimTime t) override {
    constexpr SimTime kStart = 2 * kSecond;
    for (; next_ < t; next_ += kMillisecond) {
      if (next_ <= kStart - later_) board_.read_volts(kMiddle, next_);
      if (next_ == kStart) drive(1.0, 1.0, next_);
    }
  }

 private:
  SimTime later_;
};

std::vector<result::Detected> detected(exec::Executor& firmware, SimTime limit, bool detect = true) {
  test::OneRobot one(firmware, "");
  one.setup.detect = detect;
  return one.run(limit).detected;
}

TEST(BlindDriving, IsWhoLosesTheLineBetweenTwoLooks) {
  Distracted firmware(700 * kMillisecond, false);
  const auto found = detected(firmware, 10 * kSecond);
  ASSERT_THAT(found, SizeIs(1)) << "one finding for all occurrences at one line";
  EXPECT_EQ(found[0].detector, "blind");
  EXPECT_EQ(found[0].where.file, "A.ino");
  EXPECT_EQ(found[0].where.line, 9);
  EXPECT_THAT(found[0].what, HasSubstr("without reading a line sensor"));
  EXPECT_THAT(found[0].what, HasSubstr("the sketch was in delay(700)"));
  EXPECT_THAT(found[0].mend, HasSubstr("millis()"));
}

TEST(BlindDriving, IsMendedWhereTheSketchWasBusy) {
  const auto mend = [](const std::string& call) {
    Distracted firmware(700 * kMillisecond, false);
    firmware.call = call;
    const auto found = detected(firmware, 10 * kSecond);
    return found.empty() ? "" : found[0].mend;
  };
  EXPECT_THAT(mend("pulseIn(4, 1)"), StartsWith("Give pulseIn() a timeout"));
  EXPECT_THAT(mend("write()"), StartsWith("Print less, less often"));
  EXPECT_THAT(mend("delay(700)"), StartsWith("Return from loop() and check with millis()"));
  EXPECT_EQ(mend(""), "Read the sensors in this code as well, or return from loop() in between.");
}

TEST(BlindDriving, IsNobodyWhoLooksInTime) {
  Distracted loses_it_all_the_same(5 * kMillisecond, false);
  EXPECT_THAT(detected(loses_it_all_the_same, 10 * kSecond), IsEmpty());
  test::BuiltInDriver follows;
  EXPECT_THAT(detected(follows, 10 * kSecond), IsEmpty());
}

TEST(BlindDriving, IsWhoStartsByItsLastLook) {
  Starts at_once(0);
  const auto found = detected(at_once, 6 * kSecond);
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_EQ(found[0].detector, "blind");
  Starts by_plan(40 * kMillisecond);
  EXPECT_THAT(detected(by_plan, 6 * kSecond), IsEmpty());
}

TEST(BlindDriving, IsNobodyWhoMeansTo) {
  Distracted drives_by_plan(700 * kMillisecond, true);
  EXPECT_THAT(detected(drives_by_plan, 10 * kSecond), IsEmpty());
}

TEST(BlindDriving, IsLookedForWhereItIsAskedFor) {
  Distracted firmware(700 * kMillisecond, false);
  EXPECT_THAT(detected(firmware, 10 * kSecond, false), IsEmpty());
}

}  // namespace robosim::detect::blind_driving_test
