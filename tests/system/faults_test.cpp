// Tests how faults of EEPROM, power, serial port and clock affect a sketch.
#include "tests/support/require_target.h"
#include "tests/system/system_test.h"

namespace robosim::test {
namespace faults_test {

using testing::AllOf;
using testing::Ge;
using testing::HasSubstr;
using testing::Le;

class Faults : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    if (std::string(GetParam()) != "host") ROBOSIM_NEEDS_TARGET(GetParam());
  }
  /// Returns the output of the sketch Diary, without CR.
  std::string diary(const std::string& script, double seconds = 0.5) {
    wire::RunRequest request = request_of({.sketch = "Diary",
                                           .robot = "uno2",
                                           .goal = "none",
                                           .script = script,
                                           .for_s = seconds,
                                           .target = GetParam()});
    request.notes = true;
    notes_.clear();
    result_ = runner_of(GetParam()).run(request, [&](const wire::Event& event) {
      if (const auto* note = std::get_if<wire::Note>(&event)) notes_.push_back(*note);
    });
    std::string text = result_.serial;
    std::erase(text, '\r');
    return text;
  }
  /// Returns the first event of this kind, or null.
  template <class What>
  const What* first() const {
    for (const wire::Note& note : notes_)
      if (const What* what = note.is<What>()) return what;
    return nullptr;
  }

  result::RunResult result_;
  std::vector<wire::Note> notes_;
};

INSTANTIATE_TEST_SUITE_P(On, Faults, testing::Values("host", "avr"),
                         [](const auto& target) { return std::string(target.param); });

TEST_P(Faults, LeaveAByteOfTheEepromHalfWritten) {
  EXPECT_EQ(diary("after eeprom 2 power off for 20ms byte 0x42\n"), "was 255 255\nwas 0 66\n");
  EXPECT_EQ(diary("after eeprom 2 power off for 20ms byte old\n"), "was 255 255\nwas 0 255\n");
  EXPECT_EQ(diary("after eeprom 1 power off for 20ms byte erased\n"), "was 255 255\nwas 255 255\n");
  const auto* lost = first<result::PowerLost>();
  ASSERT_TRUE(lost && lost->byte);
  EXPECT_EQ(lost->byte->address, 0);
  EXPECT_EQ(lost->byte->value, 0xff);
  EXPECT_EQ(diary("after eeprom 1 power off for 20ms\n"), "was 255 255\nwas 0 255\n");
  EXPECT_EQ(diary("at 100ms power off for 20ms byte 0x42\n"), "was 255 255\nwas 0 0\n") << "no byte written";
  EXPECT_EQ(result_.eeprom_writes, 4u);
}

TEST_P(Faults, FlipABitOfTheEeprom) {
  EXPECT_EQ(diary("at 100ms fault eeprom flip 0 7\nat 110ms power off for 20ms\n"),
            "was 255 255\nwas 128 0\n");
}

TEST_P(Faults, ResetTheChipWhenTheBatterySagsBelowItsBrownOut) {
  EXPECT_EQ(diary("at 100ms fault power sag 5V for 50ms\n"), "was 255 255\n");
  ASSERT_TRUE(first<result::FaultBegan>());
  EXPECT_FALSE(first<result::FaultBegan>()->resets_chip);
  EXPECT_EQ(diary("at 100ms fault power sag 4.2V for 50ms\n"), "was 255 255\nwas 0 0\n");
  const auto* fault = first<result::FaultBegan>();
  ASSERT_TRUE(fault && first<result::FaultEnded>());
  EXPECT_EQ(fault->part, "power");
  EXPECT_THAT(fault->arguments, testing::ElementsAre("sag", "4.2V"));
  EXPECT_TRUE(fault->resets_chip);
}

TEST_P(Faults, DisturbBytesOnTheirWayToTheSketch) {
  EXPECT_THAT(diary("at 100ms fault serial lost 2nd\nat 200ms send \"abc\"\n"), HasSubstr("<a><c>"));
  EXPECT_THAT(diary("at 100ms fault serial doubled 1\nat 200ms send \"ab\"\n"), HasSubstr("<a><a><b><b>"));
}

TEST_P(Faults, AreTheSameInEveryRun) {
  const std::string script =
      "at 50ms fault clock drift -3%\nat 100ms fault serial corrupted 40%\nat 200ms send \"abcdefgh\"\n"
      "at 300ms fault power brown-out for 10ms\n";
  const std::string text = diary(script);
  const std::string hash = result_.trace_hash;
  EXPECT_EQ(diary(script), text);
  EXPECT_EQ(result_.trace_hash, hash);
  EXPECT_THAT(text, testing::Not(HasSubstr("<a><b><c><d><e><f><g><h>")));
}

/// Tests that a drifting clock makes millis() run fast or slow, on every target.
class ClockFaults : public Faults {
 protected:
  /// Returns the value of millis() 1.1 s after power-on. For 1 s the clock runs too fast by `drift`.
  int millis_after(const char* drift) {
    const std::string text =
        diary(std::string("at 100ms fault clock drift ") + drift + "\nat 1.1s send \"t\"\n", 1.2);
    return std::stoi(text.substr(text.find('\n') + 1));
  }
};

INSTANTIATE_TEST_SUITE_P(On, ClockFaults, testing::Values("host", "avr", "stm32"),
                         [](const auto& target) { return std::string(target.param); });

TEST_P(ClockFaults, LetTheClockRunFastOrSlow) {
  const int right = millis_after("0%");  // the STM32 starts counting about 60 ms after power-on
  EXPECT_NEAR(millis_after("10%"), right + 100, 5);
  EXPECT_NEAR(millis_after("-10%"), right - 100, 5);
}

}  // namespace faults_test
}  // namespace robosim::test
