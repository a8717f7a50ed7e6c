// Tests the detectors that observe the board (sim/detect/detectors.h), mostly in complete runs.

#include <gmock/gmock.h>

#include <fstream>
#include <string>

#include "sim/detect/slow_source.h"
#include "tests/support/built_in_driver.h"
#include "tests/support/fake_firmware.h"
#include "tests/support/one_robot.h"
#include "tests/support/temporary_folder.h"

namespace robosim::detect::board_detectors_test {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

/// Firmware that sets the LED pin every millisecond, and writes a byte of the EEPROM every 100 ms.
class Blinker final : public test::FakeFirmware {
 public:
  enum class Led { forgotten, high_first };

  explicit Blinker(Led led) : led_(led) {}

  void power_on(SimTime t) override { began_ = t; }
  void run_until(SimTime t) override {
    for (; next_ < t; next_ += kMillisecond) {
      const SimTime since = next_ - began_;
      const bool is_output = led_ == Led::high_first && since >= 50 * kMillisecond;
      board_.set_drive(
          kLed, {is_output ? PinMode::output : PinMode::input_pullup, is_output, false, is_output * 1.0},
          next_);
      if (since % (100 * kMillisecond) == 0) board_.write_eeprom(3, value_++, next_);
    }
  }
  exec::Activity activity() override { return {next_, "", kNoPin, kNoPin, {"loop", "A.ino", 9}, ""}; }
  SimTime last_call() const override { return next_; }

 private:
  static constexpr Pin kLed = 13;

  const Led led_;
  std::uint8_t value_ = 0;
  SimTime began_ = 0, next_ = 0;
};

std::vector<result::Detected> detected(Blinker::Led led, bool detect = true, const std::string& script = "") {
  Blinker firmware(led);
  test::OneRobot one(firmware, "none", script);
  one.setup.detect = detect;
  return one.run(7 * kSecond).detected;
}

TEST(BoardDetectors, TellOfAPinThatWasNeverSetToOutputAndOfWornEeprom) {
  const auto found = detected(Blinker::Led::forgotten);
  ASSERT_THAT(found, SizeIs(2));
  EXPECT_EQ(found[0].detector, "forgotten_output");
  EXPECT_EQ(found[0].where.line, 9);
  EXPECT_THAT(found[0].what, HasSubstr("pin 13 (LED) was never set to OUTPUT"));
  EXPECT_THAT(found[0].what, HasSubstr("(an Uno R3 has an amplifier before its own LED;"));
  EXPECT_THAT(found[0].mend, HasSubstr("pinMode(13, OUTPUT)"));
  EXPECT_EQ(found[1].detector, "eeprom_wear");
  EXPECT_EQ(found[1].where.file, "A.ino");
}

TEST(BoardDetectors, SayNothingOfAPinThatIsHighFirstAndAnOutputThen) {
  const auto found = detected(Blinker::Led::high_first);
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_EQ(found[0].detector, "eeprom_wear");
}

/// Firmware that reads pin 4 every millisecond.
class ButtonReader final : public test::FakeFirmware {
 public:
  explicit ButtonReader(PinMode mode) : mode_(mode) {}

  void power_on(SimTime t) override { board_.set_drive(kPin, {mode_, false, false, 0.0}, t); }
  void run_until(SimTime t) override {
    for (; now_ < t; now_ += kMillisecond) board_.read_level(kPin, now_);
  }

 private:
  static constexpr Pin kPin = 4;
  const PinMode mode_;
};

TEST(BoardDetectors, NameAButtonThatIsReadWithoutPullUp) {
  const test::TemporaryFolder folder;
  const std::string robot = folder.path() / "button_without_resistor.toml";
  std::ofstream(robot)
      << "base = \"uno5\"\n[[part]]\nname = \"start\"\ntype = \"button\"\nresistor = false\n";
  const auto found_with = [&](PinMode mode, const std::string& robot_name) {
    ButtonReader firmware(mode);
    test::OneRobot one(firmware, "none", "", robot_name.c_str());
    one.setup.detect = true;
    return one.run(kSecond).detected;
  };
  const auto found = found_with(PinMode::input, robot);
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_EQ(found[0].detector, "floating_input");
  EXPECT_THAT(found[0].what, HasSubstr("pin 4 (start) floats while start is not pressed"));
  EXPECT_THAT(found[0].mend, HasSubstr("pinMode(4, INPUT_PULLUP)"));
  EXPECT_THAT(found_with(PinMode::input_pullup, robot), IsEmpty());
  EXPECT_THAT(found_with(PinMode::input, "uno5"), IsEmpty()) << "this button has a resistor";
}

TEST(BoardDetectors, TellOfAPinThatIsReadBeforeItsWeakSourceHasChargedTheConverter) {
  const auto found_in = [&](const std::vector<std::pair<Pin, double>>& round) {
    SlowSource detector(*find_board("uno"));
    SimTime t = 0;
    for (int i = 0; i < 4; ++i)
      for (const auto& [pin, volts] : round)
        detector.converted(pin, volts, t += kMillisecond, [] { return result::SourceLine{"", "A.ino", 9}; });
    return detector.found();
  };
  const auto found = found_in({{14, 0.0}, {15, 0.3}});
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_EQ(found[0].detector, "slow_source");
  EXPECT_THAT(found[0].what, HasSubstr("A1 was read up to 0.30 V too high"));
  EXPECT_EQ(found[0].where.file, "A.ino");
  EXPECT_EQ(found[0].times, 3) << "the last reading is not yet known to be wrong";
  EXPECT_THAT(found_in({{14, 0.3}, {15, 0.0}})[0].what, HasSubstr("A0 was read up to 0.30 V too high"));
  EXPECT_THAT(found_in({{14, 0.0}, {15, -0.3}})[0].what, HasSubstr("A1 was read up to 0.30 V too low"));
  EXPECT_THAT(found_in({{14, 0.0}, {15, 0.3}, {15, 0.1}, {15, 0.03}}), IsEmpty())
      << "the sketch reads the pin again";
  EXPECT_THAT(found_in({{14, 0.0}, {15, 0.03}}), IsEmpty()) << "the error is less than 8 steps";
}

TEST(BoardDetectors, CountTheWritesOfEachPowerCycle) {
  const auto found =
      detected(Blinker::Led::high_first, true,
               "at 2s power off for 20ms\nat 4s power off for 20ms\nat 6s power off for 20ms\n");
  EXPECT_THAT(found, IsEmpty());
}

TEST(BoardDetectors, LookOnWhereTheyAreAskedTo) {
  EXPECT_THAT(detected(Blinker::Led::forgotten, false), IsEmpty());
}

}  // namespace robosim::detect::board_detectors_test
