// Tests the time that a robot drives without reading a sensor (sim/detect/blind_driving.h).

#include <gmock/gmock.h>

#include "sim/robot/description.h"
#include "sim/run/simulation.h"
#include "tests/support/built_in_driver.h"

namespace robosim::detect {
namespace blind_driving_test {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
using testing::StartsWith;

/// Firmware that drives straight on, and reads a sensor once per `looks_every`. If `plans` is true, it drives
/// at half power in the second half of each interval.
class Distracted : public exec::Executor {
 public:
  Distracted(SimTime looks_every, bool plans) : looks_every_(looks_every), plans_(plans) {}

  RobotPort& board() override { return board_; }
  exec::BoardProbe& probe() override { return board_; }
  void power_on(SimTime t) override { drive(1.0, t); }
  void power_off(SimTime t) override { board_.reset(t); }
  void run_until(SimTime t) override {
    for (; next_ < t; next_ += kMillisecond) {
      if (next_ % looks_every_ == 0) board_.read_volts(kMiddle, next_);
      if (plans_) drive(next_ % looks_every_ < looks_every_ / 2 ? 1.0 : 0.5, next_);
    }
  }
  const std::optional<exec::Crash>& crash() const override { return crash_; }
  exec::Activity activity() override { return {0, call, kNoPin, kNoPin, {"loop", "A.ino", 9}, ""}; }
  SimTime last_call() const override { return next_; }
  std::string call = "delay(700)";

 protected:
  static constexpr Pin kMiddle = 16;

  void drive(double power, SimTime t) {
    for (const Pin en : {5, 6}) board_.set_drive(en, {PinMode::output, false, true, power, 0}, t);
    for (const Pin pin : {7, 8, 9, 10}) {
      const bool ahead = pin % 2 == 1;
      board_.set_drive(pin, {PinMode::output, ahead, false, ahead ? 1.0 : 0.0, 0}, t);
    }
  }

  exec::BoardState board_{*find_board("uno")};
  SimTime next_ = 0;

 private:
  SimTime looks_every_;
  bool plans_;
  std::optional<exec::Crash> crash_;
};

/// Firmware that reads a sensor every millisecond, and starts to drive after two seconds. Its last read of
/// the sensor is `later` nanoseconds before the drive begins.
class Starts final : public Distracted {
 public:
  explicit Starts(SimTime later) : Distracted(kSecond, false), later_(later) {}
  void power_on(SimTime t) override { drive(0.0, t); }
  void run_until(SimTime t) override {
    constexpr SimTime kStart = 2 * kSecond;
    for (; next_ < t; next_ += kMillisecond) {
      if (next_ <= kStart - later_) board_.read_volts(kMiddle, next_);
      if (next_ == kStart) drive(1.0, next_);
    }
  }

 private:
  SimTime later_;
};

std::vector<result::Detected> detected(exec::Executor& firmware, SimTime limit, bool detect = true) {
  static const map::Map oval = map::read_map(map::find_map("oval"));
  static const robot::Description uno5 = robot::load_description("uno5");
  run::Setup setup;
  setup.map = &oval;
  setup.agents.emplace_back();
  setup.agents[0].robot = &uno5;
  setup.agents[0].executor = &firmware;
  setup.limit = limit;
  setup.detect = detect;
  return run::simulate(setup).front().detected;
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

}  // namespace blind_driving_test
}  // namespace robosim::detect
