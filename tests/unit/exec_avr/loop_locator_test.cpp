// Tests that the executor counts and times the rounds of loop() correctly. A round is one call of loop(), or
// one iteration of the endless loop in the sketch's main(). The sketches toggle pin 13 once per round. The
// tests compare the edges of pin 13 with the reported rounds.

#include <algorithm>

#include "tests/unit/exec_avr/fixture.h"

namespace robosim::exec::loop_locator_test {

class AvrLoopTest : public AvrTest {
 protected:
  Resources run_for(const std::string& text, SimTime duration) {
    start(text);
    run(duration);
    EXPECT_FALSE(avr_->crash()) << avr_->crash()->reason;
    return avr_->resources().value_or(Resources{});
  }

  /// Runs the sketch `text`, which toggles pin 13 once per round. Expects that the executor reports these
  /// rounds.
  void expect_true_rounds(const std::string& text, SimTime duration = 300 * kMillisecond) {
    const Resources r = run_for(text, duration);
    const std::vector<SimTime> times = changes(13);  // the first change makes the pin an output
    ASSERT_GT(times.size(), 20u) << text;
    const auto rounds = static_cast<double>(times.size() - 1);
    EXPECT_NEAR(static_cast<double>(r.loops), rounds, 1.0) << text;
    SimTime longest = 0;
    for (std::size_t i = 1; i < times.size(); ++i) longest = std::max(longest, times[i] - times[i - 1]);
    const double mean_us = 1e-3 * static_cast<double>(times.back() - times[1]) / (rounds - 1.0);
    EXPECT_NEAR(r.loop_us_mean, mean_us, 0.02 * mean_us) << text;
    // A handler may run between the toggle and the place where the executor detects a round. One reported
    // round is then longer, and another is shorter.
    EXPECT_NEAR(r.loop_us_max, 1e-3 * static_cast<double>(longest), 25.0) << text;
  }

  void expect_nothing_said(const std::string& text) {
    EXPECT_EQ(run_for(text, 100 * kMillisecond).loops, 0u) << text;
  }
};

constexpr const char* kSetup = "volatile byte n;\nvoid setup() { DDRB = _BV(5); }\n";

std::string sketch(const std::string& loop) { return kSetup + ("void loop() {\n" + loop + "\n}"); }

TEST_F(AvrLoopTest, ALoopThatBeginsWithALoopWithinIsNotCountedByThat) {
  for (const char* loop : {
           "while (n < 50) { n = n + 1; PIND = 1; }\nn = 0;\nPINB = _BV(5);",
           "do { n = n + 1; PIND = 1; } while (n < 50);\nn = 0;\nPINB = _BV(5);",
           "while (!(TIFR1 & 1)) {}\nTIFR1 = 1;\ndelayMicroseconds(100);\nPINB = _BV(5);",
           "for (int i = 0; i < 5; i++) {\n"
           "  for (int j = 0; j < 3; j++) {\n"
           "    n = n + j;\n"
           "    while (GPIOR0 < 2) { GPIOR0 = GPIOR0 + 1; if (GPIOR0 == 7) return; }\n"
           "  }\n"
           "  GPIOR0 = 0;\n"
           "}\nPINB = _BV(5);",
       }) {
    expect_true_rounds(sketch(loop));
  }
  expect_true_rounds("#pragma GCC optimize \"O2\"\n" +
                     sketch("while (n < 50) { n = n + 1; PIND = 1; }\nn = 0;\nPINB = _BV(5);"));
}

TEST_F(AvrLoopTest, AWaitForTheSerialLineOrForTimeIsAPartOfTheRound) {
  expect_true_rounds(
      "void setup() { DDRB = _BV(5); Serial.begin(115200); }\n"
      "void loop() {\n"
      "  while (Serial.available() == 0) { if (millis() % 10 == 5) break; }\n"
      "  Serial.read();\n  delay(1);\n  PINB = _BV(5);\n}",
      kSecond);
}

TEST_F(AvrLoopTest, EachReturnEndsARound) {
  expect_true_rounds(
      sketch("PINB = _BV(5);\nif (n < 50) { n = n + 1; PIND = 1; return; }\nn = 0;\nPIND = 4;\n"
             "if (n == 3) return;\nPIND = 8;\ndelayMicroseconds(20);"));
  expect_true_rounds(
      sketch("PINB = _BV(5);\nswitch (n) {\n case 0: n = 1; break;\n case 1: n = 2; return;\n"
             " case 2: while (TCNT0 & 8) {} n = 3; break;\n case 3: delay(1); n = 4; return;\n"
             " case 4: PIND = 1; n = 5; break;\n default: n = 0; }"));
}

TEST_F(AvrLoopTest, ALoopThatNeverEndsIsAPartOfTheLastRound) {
  for (const std::string setup : {kSetup, "byte n;\nvoid setup() { DDRB = _BV(5); Serial.begin(9600); }\n"})
    for (const char* end : {"for (;;) {}", "for (;;) { PIND = 1; n = 0; }"}) {
      const std::string text = setup +
                               "void loop() {\nfor (byte i = 0; i < 9; i++) PIND = i;\nPINB = _BV(5);\n" +
                               "if (++n == 200) { " + end + " }\n}";
      const Resources r = run_for(text, 100 * kMillisecond);
      EXPECT_EQ(changes(13).size(), 201u) << text;
      EXPECT_NEAR(static_cast<double>(r.loops), 200.0, 1.0) << text;
    }
}

TEST_F(AvrLoopTest, ALoopThatIsCalledOrCallsOnIsCounted) {
  const std::string within = "while (n < 50) { n = n + 1; PIND = 1; }\nn = 0;\nPINB = _BV(5);";
  expect_true_rounds("void __attribute__((noinline)) loop();\n" + sketch(within));
  expect_true_rounds("void __attribute__((noinline)) work();\nvoid __attribute__((noinline)) loop();\n" +
                     sketch("work();") + "\nvoid work() {\n" + within + "\n}");
}

TEST_F(AvrLoopTest, AMethodThatIsCalledLoopIsNotIt) {
  expect_true_rounds("struct Client { void loop() { for (int i = 0; i < 9; i++) PIND = i; } } client;\n" +
                     sketch("client.loop();\nPINB = _BV(5);"));
}

TEST_F(AvrLoopTest, TheRoundsOfAMainOfItsOwnAreThoseOfItsEndlessLoop) {
  const std::string begin = "volatile byte n;\nint main() {\n  DDRB = _BV(5);\n  for (;;) {\n";
  expect_true_rounds(begin + "    PINB = _BV(5);\n    n = n + 1;\n  }\n}", 10 * kMillisecond);
  expect_true_rounds(
      begin + "    PINB = _BV(5);\n    for (byte i = 0; i < 9; i++)\n      PIND = i;\n    n = 0;\n  }\n}");
}

TEST_F(AvrLoopTest, WhatCannotBeToldIsNotSaid) {
  // The inner loop compiles to the same machine code as `if (n < 50) { …; continue; }` in the outer loop.
  expect_nothing_said(
      "volatile byte n;\nint main() {\n  DDRB = _BV(5);\n  for (;;) {\n"
      "    while (n < 50) {\n      n = n + 1;\n      PIND = 1;\n    }\n    n = 0;\n    PINB = _BV(5);\n  "
      "}\n}");
  expect_nothing_said("int main() {\n  DDRB = _BV(5);\n  for (;;) {\n  }\n}");
  expect_nothing_said("void setup() {\n  for (;;) {\n    delay(5);\n  }\n}\nvoid loop() {\n}");
}

TEST_F(AvrLoopTest, TheShareOfHandlersIsWhatTheLoopLoses) {
  // Timer 1 counts the delay loop's cycles, whose number is constant, plus the cycles of interrupt handlers.
  const std::string text = R"(#include <util/delay_basic.h>
volatile byte table[8];
ISR(TIMER2_COMPA_vect) { for (byte i = 0; i < 8; ++i) table[i] = i; }
int main() {
  Serial.begin(115200);
  TCCR2A = _BV(WGM21); OCR2A = 49; TCCR2B = _BV(CS21);
  TCCR1A = 0; TCCR1B = _BV(CS10);
  unsigned took[2];
  for (byte with = 0; with < 2; ++with) {
    TIMSK2 = with ? _BV(OCIE2A) : 0;
    sei();
    TCNT1 = 0;
    _delay_loop_2(8000);
    took[with] = TCNT1;
  }
  Serial.println(took[0]);
  Serial.println(took[1]);
  for (;;) {}
})";
  const Resources r = run_for(text, kSecond);
  ASSERT_EQ(numbers().size(), 2u);
  const auto alone = static_cast<double>(numbers()[0]), with = static_cast<double>(numbers()[1]);
  EXPECT_NEAR(r.interrupt_share, 1.0 - alone / with, 0.01);
}

}  // namespace robosim::exec::loop_locator_test
