// Tests digital pins, PWM and pulses, by functions and by registers.
#include "tests/unit/targets/fixture.h"

namespace robosim::exec::pins_test {

using testing::ElementsAre;

TEST_P(OnEveryTarget, ModesAndLevelsReachTheBoard) {
  after(
      "pinMode(7, OUTPUT); pinMode(8, OUTPUT); digitalWrite(8, HIGH); pinMode(9, INPUT_PULLUP); "
      "pinMode(10, INPUT_PULLUP); pinMode(10, INPUT); pinMode(A3, OUTPUT); digitalWrite(A3, HIGH);");
  EXPECT_EQ(drive("2").mode, PinMode::input);
  EXPECT_EQ(drive("7").mode, PinMode::output);
  EXPECT_FALSE(drive("7").level);
  EXPECT_TRUE(drive("8").level);
  EXPECT_EQ(drive("9").mode, PinMode::input_pullup);
  EXPECT_EQ(drive("10").mode, PinMode::input);
  EXPECT_TRUE(drive("A3").level);
}

TEST_P(OnAtmega, AHighLevelOfAnInputIsItsPullUp) {
  after("digitalWrite(7, HIGH);");
  EXPECT_EQ(drive("7").mode, PinMode::input_pullup);
}

TEST_P(OnEveryTarget, DigitalReadGivesSourcesPullUpsAndOwnOutputs) {
  start(R"(void setup() {
  Serial.begin(115200);
  pinMode(2, INPUT); pinMode(3, INPUT_PULLUP); pinMode(4, INPUT); pinMode(5, INPUT); pinMode(6, OUTPUT);
  digitalWrite(6, HIGH);
  pinMode(7, INPUT_PULLUP);
  for (int pin = 2; pin <= 7; ++pin) Serial.println(digitalRead(pin));
  Serial.println(digitalRead(A1));
}
void loop() {})");
  FixedSource high(supply()), low(0.0);
  board().connect(pin("4"), high);
  board().connect(pin("5"), low);
  board().connect(pin("7"), low);
  board().connect(pin("A1"), high);
  run(20 * kMillisecond);
  EXPECT_THAT(numbers(), ElementsAre(0, 1, 1, 0, 1, 0, 1));
}

TEST_P(OnEveryTarget, ADigitalReadSamplesOnlyItsPin) {
  start(
      "volatile byte n;\nvoid setup() { for (int i = 0; i < 10; ++i) n += digitalRead(4); }\nvoid loop() {}");
  FixedSource four(5.0), seven(5.0);
  board().connect(pin("4"), four);
  board().connect(pin("7"), seven);
  run(5 * kMillisecond);
  EXPECT_EQ(four.asked_at.size(), 10u);
  EXPECT_TRUE(seven.asked_at.empty());
}

TEST_P(OnAtmega, AWholePortIsReadAtOnce) {
  start(R"(void setup() {
  Serial.begin(115200);
  Serial.println(PINC & 0x3F);
  Serial.println(PIND & 0xF0);
  Serial.println(bit_is_set(PIND, 2) != 0);
}
void loop() {})");
  FixedSource high(5.0);
  for (const char* name : {"2", "4", "7", "A0", "A3"}) board().connect(pin(name), high);
  run(20 * kMillisecond);
  EXPECT_THAT(numbers(), ElementsAre(9, 0x90, 1));
}

TEST_P(OnAtmega, RegistersArePins) {
  after("DDRD |= _BV(7); PORTD |= _BV(7); DDRB = 0xFF; PORTB = 0xFF; PORTB &= ~_BV(5);");
  EXPECT_TRUE(drive("7").level);
  EXPECT_TRUE(drive("12").level);
  EXPECT_FALSE(drive("13").level);
}

TEST_P(OnAtmega, WritingAOneToAPinRegisterTogglesThatPinAlone) {
  after("DDRB = _BV(5); PINB = _BV(5); DDRD = 0xF0; PORTD = _BV(6) | _BV(4); PIND |= _BV(5);");
  for (const char* high : {"4", "5", "6", "13"}) EXPECT_TRUE(drive(high).level) << high;
  EXPECT_FALSE(drive("7").level);
}

TEST_P(OnAtmega, AnalogWriteGivesTheDutyOfThePinsTimer) {
  after(
      "analogWrite(5, 100); analogWrite(6, 1); analogWrite(9, 100); analogWrite(10, 254); "
      "analogWrite(3, 7); analogWrite(11, 128);");
  EXPECT_DOUBLE_EQ(drive("5").duty, 101.0 / 256);  // timer 0: fast PWM
  EXPECT_DOUBLE_EQ(drive("6").duty, 2.0 / 256);
  EXPECT_DOUBLE_EQ(drive("9").duty, 100.0 / 255);  // timers 1 and 2: phase correct
  EXPECT_DOUBLE_EQ(drive("10").duty, 254.0 / 255);
  EXPECT_DOUBLE_EQ(drive("3").duty, 7.0 / 255);
  EXPECT_DOUBLE_EQ(drive("11").duty, 128.0 / 255);
  EXPECT_TRUE(drive("11").pwm);
}

TEST_P(OnAtmega, AnalogWriteOf0And255IsADigitalWrite) {
  after("analogWrite(9, 100); analogWrite(9, 0); analogWrite(5, 9); analogWrite(5, 255);");
  for (const auto& [name, level] : {std::pair{"9", false}, std::pair{"5", true}}) {
    EXPECT_FALSE(drive(name).pwm) << name;
    EXPECT_EQ(drive(name).level, level) << name;
    EXPECT_EQ(drive(name).duty, level ? 1.0 : 0.0) << name;
  }
}

// In phase-correct mode with TOP = ICR1 = 400, the frequency is 16 MHz / 800 = 20 kHz.
TEST_P(OnAtmega, ATimerHasTheTopAndTheModeThatItsRegistersSay) {
  after(
      "pinMode(9, OUTPUT); pinMode(10, OUTPUT); TCCR1A = _BV(COM1A1) | _BV(COM1B1) | _BV(WGM11); "
      "TCCR1B = _BV(WGM13) | _BV(CS10); ICR1 = 400; OCR1A = 300; OCR1B = 100; "
      "pinMode(3, OUTPUT); OCR2B = 63; TCCR2A = _BV(COM2B1) | _BV(COM2B0) | _BV(WGM20);");
  EXPECT_DOUBLE_EQ(drive("9").duty, 0.75);
  EXPECT_DOUBLE_EQ(drive("10").duty, 0.25);
  EXPECT_DOUBLE_EQ(drive("3").duty, 1.0 - 63.0 / 255) << "inverted";
  after(
      "DDRB |= _BV(1); TCCR1A = _BV(COM1A1) | _BV(WGM11); TCCR1B = _BV(WGM13) | _BV(CS11); ICR1 = 20000; "
      "OCR1A = 1500;");
  EXPECT_DOUBLE_EQ(drive("9").duty, 1500.0 / 20000);
  after(
      "pinMode(9, OUTPUT); TCCR1A = _BV(COM1A1) | _BV(WGM11); TCCR1B = _BV(WGM13) | _BV(WGM12) | "
      "_BV(CS10); ICR1 = 799; OCR1A = 199;");
  EXPECT_DOUBLE_EQ(drive("9").duty, 0.25) << "fast PWM counts TOP as a step";
}

TEST_P(OnAtmega, ACompareInterruptMakesAServosPulse) {
  start(R"(ISR(TIMER1_COMPA_vect) { PORTB &= ~_BV(2); }
ISR(TIMER1_OVF_vect) { PORTB |= _BV(2); }
void setup() { pinMode(10, OUTPUT); TCCR1A = 0; TCCR1B = _BV(CS11); OCR1A = 3000; TIMSK1 = _BV(OCIE1A) | _BV(TOIE1); }
void loop() {})");
  run(200 * kMillisecond);
  std::vector<SimTime> high, low;
  for (const PinEvent& event : pins_)
    if (event.pin == pin("10") && event.at > 10 * kMillisecond)
      (event.drive.level ? high : low).push_back(event.at);
  ASSERT_GE(high.size(), 4u);
  EXPECT_NEAR(static_cast<double>(high[1] - high[0]), 32.768e6, 4e3);
  EXPECT_NEAR(static_cast<double>(low[low[0] > high[0] ? 0 : 1] - high[0]), 1500e3, 10e3);
}

TEST_P(OnEveryTarget, AToneSoundsForItsTime) {
  start("void setup() { tone(8, 440, 100); }\nvoid loop() {}");
  run(50 * kMillisecond);
  if (GetParam().names_tones) {
    EXPECT_EQ(drive("8").tone_hz, 440u);
  } else {
    const std::vector<SimTime> edges = changes(pin("8"));
    ASSERT_GT(edges.size(), 35u);
    EXPECT_NEAR(static_cast<double>(edges[30] - edges[10]) / 20, 1e9 / 880, 0.005e9 / 880);
  }
  run(100 * kMillisecond);
  EXPECT_EQ(drive("8").tone_hz, 0u);
  EXPECT_FALSE(drive("8").level) << "silent after 100 ms";
  EXPECT_NEAR(static_cast<double>(changes(pin("8")).back() - changes(pin("8")).front()), 100e6, 2e6);
}

TEST_P(OnAtmega, AToneTakesTimer2) {
  after("analogWrite(3, 50); tone(8, 440, 100);");
  EXPECT_FALSE(drive("3").pwm);
}

TEST_P(OnEveryTarget, PulsesAreMeasuredInMicroseconds) {
  start(R"(void setup() {
  Serial.begin(115200);
  Serial.println(pulseIn(7, HIGH));
  Serial.println(pulseIn(7, HIGH, 2000));
}
void loop() {})");
  Pulse pulse(3 * kMillisecond, 4500 * kMicrosecond);
  board().connect(pin("7"), pulse);
  run(20 * kMillisecond);
  ASSERT_EQ(numbers().size(), 2u);
  EXPECT_NEAR(static_cast<double>(numbers()[0]), 1500, 20);
  EXPECT_EQ(numbers()[1], 0) << "gives up after its timeout";
}

}  // namespace robosim::exec::pins_test
