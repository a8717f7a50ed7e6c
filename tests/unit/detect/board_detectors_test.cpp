// Tests the detectors of a board (sim/detect/detectors.h) in complete runs.

#include <gmock/gmock.h>

#include "sim/detect/slow_source.h"
#include "sim/robot/description.h"
#include "sim/run/simulation.h"
#include "tests/support/built_in_driver.h"

namespace robosim::detect {
namespace board_detectors_test {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

/// Firmware that writes to the LED pin and to a byte of the EEPROM every tenth of a second.
class Blinker final : public exec::Executor {
 public:
  enum class Led { forgotten, high_first };

  explicit Blinker(Led led) : led_(led) {}

  RobotPort& board() override { return board_; }
  exec::BoardProbe& probe() override { return board_; }
  void power_on(SimTime t) override { began_ = t; }
  void power_off(SimTime t) override { board_.reset(t); }
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
  const std::optional<exec::Crash>& crash() const override { return crash_; }
  exec::Activity activity() override { return {next_, "", kNoPin, kNoPin, {"loop", "A.ino", 9}, ""}; }
  SimTime last_call() const override { return next_; }

 private:
  static constexpr Pin kLed = 13;

  exec::BoardState board_{*find_board("uno")};
  const Led led_;
  std::uint8_t value_ = 0;
  SimTime began_ = 0, next_ = 0;
  std::optional<exec::Crash> crash_;
};

std::vector<result::Detected> detected(Blinker::Led led, bool detect = true, const std::string& script = "") {
  static const map::Map oval = map::read_map(map::find_map("oval"));
  static const robot::Description uno5 = robot::load_description("uno5");
  Blinker firmware(led);
  run::Setup setup;
  setup.map = &oval;
  setup.agents.emplace_back();
  setup.agents[0].robot = &uno5;
  setup.agents[0].executor = &firmware;
  setup.agents[0].goal = judge::parse_goal("none");
  setup.agents[0].scenario = scenario::parse_scenario(script, "script");
  setup.limit = 7 * kSecond;
  setup.detect = detect;
  return run::simulate(setup).front().detected;
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

}  // namespace board_detectors_test
}  // namespace robosim::detect
