// Tests which actions of an Uno's firmware are findings (sim/detect/doubtful_actions.h).
#include "sim/detect/doubtful_actions.h"

#include <gmock/gmock.h>

namespace robosim::detect::doubtful_actions_test {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
using Kind = FirmwareAction::Kind;

constexpr SimTime kMs = kMillisecond;
constexpr int64_t kTimer1 = 1;

class Actions : public testing::Test {
 protected:
  /// Increments `line_`, and reports an action in this line.
  void act(Kind kind, int64_t first, int64_t second = 0, int64_t third = 0) {
    ++line_;
    actions_.acted({kind, {first, second, third}}, now_, [&] {
      return exec::SourceLine{"loop", "A.ino", line_};
    });
  }
  std::vector<exec::Detected> found() const { return actions_.found(now_); }

  DoubtfulActions actions_{*find_board("uno")};
  SimTime now_ = 0;
  int line_ = 0;
};

TEST_F(Actions, OnePinWithoutPwmIsOneFindingWithTheNumberOfItsCalls) {
  act(Kind::analog_write, 7, 150);
  act(Kind::analog_write, 7, 151);
  ASSERT_THAT(found(), SizeIs(1));
  EXPECT_EQ(found()[0].detector, "lost_pwm");
  EXPECT_EQ(found()[0].times, 2);
  EXPECT_EQ(found()[0].where.line, 1);
  EXPECT_THAT(found()[0].what, HasSubstr("analogWrite(7, 150)"));
}

TEST_F(Actions, FullPowerAndNoneNeedNoPwm) {
  act(Kind::analog_write, 7, 255);
  act(Kind::analog_write, 7, 0);
  act(Kind::analog_write, 5, 150);
  act(Kind::analog_write, 200, 150);
  EXPECT_THAT(found(), IsEmpty());
}

TEST_F(Actions, ANumberThatIsNoPinIsOneFinding) {
  act(Kind::missing_pin, 90, 1);
  act(Kind::missing_pin, 90, 0);
  act(Kind::missing_pin, 19, 1);
  ASSERT_THAT(found(), SizeIs(1));
  EXPECT_EQ(found()[0].detector, "missing_pin");
  EXPECT_EQ(found()[0].what, "digitalWrite() got pin 90, which the uno does not have; it was called");
  DoubtfulActions nano(*find_board("nano"));
  nano.acted({Kind::missing_pin, {20, 2, 0}}, 0, [] { return exec::SourceLine{}; });
  ASSERT_THAT(nano.found(0), SizeIs(1));
  EXPECT_EQ(nano.found(0)[0].what,
            "digitalRead() got pin A6, which can only be read with analogRead(); it was called");
}

TEST_F(Actions, AValueOutOfRangeHasTheEffectOfItsLowByteOrOfFullPowerOnAWideTimer) {
  act(Kind::analog_write, 6, -30);
  act(Kind::analog_write, 9, 300);
  act(Kind::analog_write, 7, -30);
  ASSERT_THAT(found(), SizeIs(3));
  EXPECT_EQ(found()[0].detector, "pwm_range");
  EXPECT_THAT(found()[0].what, HasSubstr("analogWrite(6, -30) acted like analogWrite(6, 226)"));
  EXPECT_THAT(found()[1].what, HasSubstr("analogWrite(9, 300) acted like analogWrite(9, 255)"));
  EXPECT_THAT(found()[2].what, HasSubstr("analogWrite(7, -30) acted like analogWrite(7, 0)"));
}

TEST_F(Actions, AnInterruptNumberThatIsAPinIsNamedAsThat) {
  act(Kind::attach_interrupt, 255);
  act(Kind::attach_interrupt, 3);
  act(Kind::attach_interrupt, 1);
  ASSERT_THAT(found(), SizeIs(2));
  EXPECT_EQ(found()[0].detector, "no_interrupt");
  EXPECT_THAT(
      found()[0].what,
      HasSubstr("255, which digitalPinToInterrupt() returns for a pin without an external interrupt"));
  EXPECT_THAT(found()[0].mend, HasSubstr("2 or 3"));
  EXPECT_THAT(found()[1].what, HasSubstr("3, which is a pin: its interrupt is 1"));
}

TEST_F(Actions, ANegativeDelayIsNamedWithItsDays) {
  act(Kind::delay, 4294941760);
  act(Kind::delay, 2'000'000'000);
  ASSERT_THAT(found(), SizeIs(1));
  EXPECT_EQ(found()[0].what,
            "delay(4294941760) lasts 50 days; its number may have been negative, -25536; it was called");
}

TEST_F(Actions, ATakenTimerIsNamedWithTheLineThatTookItAndTheFirstCallWithoutPwm) {
  act(Kind::timer_mode, kTimer1, 0, 0);
  now_ = 100 * kMs;
  act(Kind::compare_write, kTimer1, 0);
  act(Kind::compare_write, kTimer1, 1);
  EXPECT_THAT(found(), IsEmpty()) << "the sketch may still be setting up the timer";
  now_ = 200 * kMs;
  ASSERT_THAT(found(), SizeIs(1));
  EXPECT_EQ(found()[0].detector, "lost_pwm");
  EXPECT_THAT(found()[0].what,
              HasSubstr("pins 9 and 10 had no PWM, since their timer 1 had left its PWM mode"));
  EXPECT_THAT(found()[0].what, HasSubstr("A.ino:1 (0.00 s)"));
  EXPECT_EQ(found()[0].where.line, 2);
  EXPECT_THAT(found()[0].mend, HasSubstr("(3, 5, 6 or 11)"));
}

TEST_F(Actions, AnOutputThatLosesItsPwmIsAFindingWithoutAnotherCall) {
  act(Kind::timer_mode, kTimer1, 0, 1);
  now_ = 20 * kMs;
  ASSERT_THAT(found(), SizeIs(1));
  EXPECT_THAT(found()[0].what,
              HasSubstr("pins 9 and 10 lost the PWM, since their timer 1 left its PWM mode"));
}

TEST_F(Actions, ATimeWithoutPwmIsRememberedButReportedOnce) {
  for (int i = 0; i < 3; ++i) {
    act(Kind::timer_mode, kTimer1, 0, 1);
    now_ += 20 * kMs;
    act(Kind::timer_mode, kTimer1, 1, 0);
    now_ += 20 * kMs;
  }
  ASSERT_THAT(found(), SizeIs(1));
  EXPECT_EQ(found()[0].where.line, 1);
}

TEST_F(Actions, ATimerThatIsSetUpByRegistersOrThatMakesNoPwmIsNone) {
  act(Kind::timer_mode, kTimer1, 0, 0);
  act(Kind::compare_write, kTimer1, 0);
  now_ = kMs;
  act(Kind::timer_mode, kTimer1, 1, 0);
  now_ = 100 * kMs;
  act(Kind::timer_mode, kTimer1, 0, 0);
  now_ = 200 * kMs;
  EXPECT_THAT(found(), IsEmpty());
}

TEST_F(Actions, ATimerIsKnownByItsNumberOnEachBoard) {
  const auto pins_without_pwm = [](const char* board, int64_t timer) {
    DoubtfulActions actions(*find_board(board));
    actions.acted({Kind::timer_mode, {timer, 0, 1}}, 0, [] { return exec::SourceLine{}; });
    const auto found = actions.found(20 * kMs);
    return found.empty() ? "" : found[0].what.substr(0, found[0].what.find(" lost"));
  };
  EXPECT_EQ(pins_without_pwm("uno", 2), "pins 3 and 11");
  EXPECT_EQ(pins_without_pwm("mega", 5), "pins 44, 45 and 46");
  EXPECT_EQ(pins_without_pwm("leonardo", 3), "pin 5") << "timer 3 makes this pin's PWM";
  EXPECT_EQ(pins_without_pwm("leonardo", 2), "") << "a Leonardo has no timer 2";
  EXPECT_EQ(pins_without_pwm("bluepill", 2), "") << "the chip has no timers of an AVR";
}

TEST_F(Actions, AStartOfTheFirmwareForgetsWhichTimersWereTaken) {
  act(Kind::timer_mode, kTimer1, 0, 1);
  actions_.powered_on();
  now_ = 100 * kMs;
  EXPECT_THAT(found(), IsEmpty());
}

}  // namespace robosim::detect::doubtful_actions_test
