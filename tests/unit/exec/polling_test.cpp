// Tests that skipping busy-wait loops of firmware is not observable. The later actions of the firmware and
// all reports stay the same.
#include <fmt/format.h>

#include "tests/unit/exec/fixture.h"

namespace robosim::exec::polling_test {

/// A source whose level changes every 7.3 ms, and which reports the time of its next change. Each sample of
/// its voltage differs from the sample before.
class Changing final : public PinSource {
 public:
  Source output(SimTime t, double) override { return (level(t) ? 4.0 : 0.0) + 0.01 * (++measured % 99); }
  bool level(SimTime t) override {
    ++asked;
    return t / kHalf % 2 != 0;
  }
  SimTime same_until(SimTime t) override { return (t / kHalf + 1) * kHalf; }

  static constexpr SimTime kHalf = 7'300'001;
  int asked = 0, measured = 0;
};

class Polling : public HostTest {
 protected:
  struct Run {
    std::vector<SimTime> pins, bytes;
    std::string serial, activities;
    int asked = 0;
    bool operator==(const Run&) const = default;
  };

  Polling() { lateness_ = {{50'200'000, 3'300'000}, {110'100'000, -2'000'000}, {250'700'000, 700'000}}; }
  void before_power_on() override {
    host_->skip_waiting(skips_);
    for (const Pin pin : {4, 18}) board().connect(pin, changing_);
  }

  Run run_once(const std::string& text, bool skips) {
    skips_ = skips;
    changing_ = {};
    start(text);
    Run run;
    for (int tick = 0; tick < 400; ++tick) {
      const SimTime t = tick * kTick;
      if (tick == 300) host_->set_clock_drift(700, t);
      if (tick % 53 == 17) board().receive_byte('x', t + 123'457);
      if (tick % 41 == 5) board().schedule_edge(2, tick % 2 != 0, t + 345'678);
      host_->run_until(t + kTick);
      if (tick % 37 != 0) continue;
      const Activity now = host_->activity();
      run.activities +=
          fmt::format("{} {} {} {} {}\n", tick, now.call, now.last_call, now.polled, host_->hangs());
    }
    EXPECT_FALSE(host_->crash());
    for (const PinEvent& event : pins_) run.pins.push_back(event.at);
    run.bytes = byte_times_;
    run.serial = serial_;
    run.asked = changing_.asked;
    return run;
  }

  /// Runs a sketch with and without skipping, expects equal results, and returns the result.
  Run same(const std::string& text) {
    Run all = run_once(text, false), skipped = run_once(text, true);
    asked_ = {all.asked, skipped.asked};
    all.asked = skipped.asked = 0;
    EXPECT_EQ(all.pins, skipped.pins);
    EXPECT_EQ(all.bytes, skipped.bytes);
    EXPECT_EQ(all.serial, skipped.serial);
    EXPECT_EQ(all.activities, skipped.activities);
    return skipped;
  }

  bool skips_ = true;
  Changing changing_;
  std::pair<int, int> asked_;
};

TEST_F(Polling, OfMillis) {
  EXPECT_EQ(same("unsigned long last; bool on;\n"
                 "void setup() { pinMode(13, OUTPUT); }\n"
                 "void loop() { if (millis() - last >= 10) { last += 10; digitalWrite(13, on = !on); } }\n")
                .pins.size(),
            40u);
}

TEST_F(Polling, OfAPinAsksItSeldom) {
  same(
      "void setup() { pinMode(13, OUTPUT); }\n"
      "void loop() { while (digitalRead(4)); digitalWrite(13, HIGH); while (!digitalRead(4)); "
      "digitalWrite(13, LOW); "
      "}\n");
  EXPECT_GT(asked_.first, 30'000);
  EXPECT_LT(asked_.second, 10'000);
}

TEST_F(Polling, OfAFlagThatAnInterruptSets) {
  same(
      "volatile bool flag; volatile int edges;\n"
      "void edge() { flag = true; ++edges; }\n"
      "void setup() { Serial.begin(115200); attachInterrupt(digitalPinToInterrupt(2), edge, CHANGE); }\n"
      "void loop() { while (!flag); flag = false; Serial.println(edges); }\n");
}

TEST_F(Polling, OfItsOwnOutputs) {
  same(
      "volatile unsigned edges; unsigned long last; int changes; bool was;\n"
      "ISR(PCINT2_vect) { ++edges; }\n"
      "void setup() {\n"
      "  Serial.begin(115200); tone(8, 31); analogWrite(5, 77); PCMSK2 = _BV(5); PCICR = _BV(PCIE2);\n"
      "}\n"
      "void loop() {\n"
      "  const unsigned before = edges;\n"
      "  while (edges == before);\n"
      "  while (digitalRead(8) == was);\n"
      "  was = !was; ++changes;\n"
      "  if (millis() - last >= 100) { last = millis(); Serial.println(edges); Serial.println(changes); }\n"
      "}\n");
  EXPECT_THAT(numbers(), testing::SizeIs(6));
}

TEST_F(Polling, OfAFlagThatATimerSets) {
  same(
      "volatile uint8_t ticks;\n"
      "ISR(TIMER1_COMPA_vect) { ++ticks; }\n"
      "void setup() { pinMode(13, OUTPUT); TCCR1A = 0; TCCR1B = _BV(WGM12) | _BV(CS11); OCR1A = 7777; TIMSK1 "
      "= "
      "_BV(OCIE1A); }\n"
      "void loop() { uint8_t before = ticks; while (ticks == before); digitalWrite(13, ticks & 1); }\n");
}

// While the loop waits, timer 0 overflows repeatedly. Each time, its handler delays the loop at another point
// of an iteration.
TEST_F(Polling, OfAFlagThatIsSeldomSet) {
  const std::string begin =
      "volatile bool flag, other; volatile uint8_t rounds; bool on;\n"
      "ISR(TIMER1_COMPA_vect) { flag = true; }\n"
      "__attribute__((noinline)) bool is_set() { return flag; }\n"
      "void setup() {\n"
      "  Serial.begin(115200); TCCR1A = 0; TCCR1B = _BV(WGM12) | _BV(CS12); OCR1A = 4321; TIMSK1 = "
      "_BV(OCIE1A);\n"
      "}\n";
  const std::string end = "  flag = false; Serial.println(micros()); Serial.println(millis());\n}\n";
  for (const char* const wait :
       {"while (!flag);", "while (!is_set()) { if (other) rounds = 3; else rounds = 5; }",
        "if (!flag) return;", "while (!flag) rounds ^= 1;",
        "while (!flag) for (rounds = 0; rounds < 4; ++rounds);",
        "while (!flag) for (rounds = 0; rounds < 9; ++rounds);"}) {
    same(begin + "void loop() {\n" + wait + end);
    EXPECT_THAT(numbers(), testing::SizeIs(testing::Gt(8))) << wait;
  }
}

// The ADC is free-running. The host computes its conversions only when the firmware accesses the ADC.
TEST_F(Polling, WhileTheConverterRunsFreely) {
  same(
      "unsigned long last, sum;\n"
      "void setup() { Serial.begin(9600); ADMUX = _BV(REFS0); ADCSRA = _BV(ADEN) | _BV(ADSC) | _BV(ADATE) | "
      "5; }\n"
      "void loop() {\n"
      "  if (millis() - last < 26) return;\n"
      "  last = millis(); sum += analogRead(4); Serial.println(sum); Serial.println(micros());\n"
      "}\n");
}

TEST_F(Polling, OfSerial) {
  same(
      "void setup() { Serial.begin(9600); }\n"
      "void loop() { if (Serial.available()) { Serial.write(Serial.read()); Serial.println(millis()); } }\n");
}

TEST_F(Polling, OfManyThingsAtOnce) {
  same(
      "unsigned long a, b; String text;\n"
      "void setup() { Serial.begin(115200); pinMode(13, OUTPUT); pinMode(7, INPUT_PULLUP); }\n"
      "void loop() {\n"
      "  int pressed = 0;\n"
      "  for (int i = 0; i < 4; ++i) pressed += digitalRead(i + 4);\n"
      "  if (millis() - a >= 7) { a = millis(); text += pressed; if (text.length() > 9) text = \"\"; }\n"
      "  if (millis() - b >= 31) { b = millis(); Serial.println(text); }\n"
      "  while (Serial.available()) digitalWrite(13, Serial.read() & 1);\n"
      "}\n");
}

TEST_F(Polling, IsNotWhatCountsItsRounds) {
  const Run run = same(
      "unsigned long n, last;\n"
      "void setup() { Serial.begin(115200); }\n"
      "void loop() { ++n; if (millis() - last >= 50) { last = millis(); Serial.println(n); n = 0; } }\n");
  EXPECT_EQ(numbers().size(), 7u);
  EXPECT_GT(numbers().back(), 5'000);
}

TEST_F(Polling, MayCountWithinARound) {
  same(
      "unsigned long last;\n"
      "void setup() { pinMode(13, OUTPUT); }\n"
      "void loop() {\n"
      "  for (volatile int i = 0; i < 9; ++i) digitalRead(4);\n"
      "  if (digitalRead(4)) return;\n"
      "  if (millis() - last > 3) { last = millis(); digitalWrite(13, !digitalRead(13)); }\n"
      "}\n");
}

TEST_F(Polling, WithInterruptsOffGoesOnForEver) {
  same(
      "void setup() { Serial.begin(115200); Serial.println(1); noInterrupts(); unsigned long t = millis(); "
      "while "
      "(millis() == t); }\n"
      "void loop() {}\n");
}

TEST_F(Polling, OfNothingHangs) {
  same("volatile bool never; void setup() { while (!never); } void loop() {}\n");
  now_ = 400 * kTick;
  run(2 * kSecond);
  EXPECT_TRUE(host_->hangs());
}

}  // namespace robosim::exec::polling_test
