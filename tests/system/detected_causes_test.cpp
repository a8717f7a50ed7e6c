// Tests sketches with common mistakes: the detectors name each cause and its line. They stay silent for
// similar sketches without the mistake.
#include <algorithm>

#include "sim/base/file.h"
#include "tests/support/temporary_folder.h"
#include "tests/system/system_test.h"

namespace robosim::test {
namespace detected_causes_test {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

struct Case {
  const char* name;
  const char* detector;  ///< "" = no detector may report
  const char* says;      ///< a part of the finding
  const char* sketch;    ///< the comment //! marks the line that the finding names
  bool on_chip_only = false;
};

void PrintTo(const Case& one, std::ostream* out) { *out << one.name; }

/// Code that sets a timer for a servo, as the Servo library does.
constexpr const char* kServo =
    "static void attachServo() {\n  TCCR1A = 0;\n  TCCR1B = _BV(CS11);\n  OCR1A = 60;\n  TIMSK1 = "
    "_BV(OCIE1A);\n}\n"
    "ISR(TIMER1_COMPA_vect) { OCR1A += 4000; }\n";

/// The common part of followers for uno5. lineAt() returns the line's position, -2000 to 2000, and power()
/// sets the motors.
constexpr const char* kFollower =
    "static int lineAt() {\n  static int last = 0;\n  long sum = 0, moment = 0;\n"
    "  for (int i = 0; i < 5; i++) {\n    int v = analogRead(A0 + i) - 150;\n    if (v < 0) v = 0;\n"
    "    sum += v;\n    moment += (long)v * (i - 2) * 1000;\n  }\n"
    "  return sum < 100 ? last : (last = (int)(moment / sum));\n}\n"
    "void setup() {\n  for (byte p = 5; p <= 10; p++) pinMode(p, OUTPUT);\n"
    "  digitalWrite(7, HIGH);\n  digitalWrite(9, HIGH);\n}\n"
    "static void power(int left, int right) {\n  analogWrite(5, constrain(left, 0, 255));\n"
    "  analogWrite(6, constrain(right, 0, 255));\n}\n";

const Case kCases[] = {
    {"APidControllerThatComputesTenTimesASecond", "slow_control", "ms, or 6",
     "unsigned long last = 0;\n"
     "void loop() {\n  int at = lineAt();\n  if (millis() - last < 100) return;\n  last = millis();\n"
     "  power(140 + at * 0.06, 140 - at * 0.06);\n}\n"},
    {"ATaskThatSteersSixteenTimesASecond", "slow_control", "the power changed only every ",
     "unsigned long next = 0;\nint at = 0;\n"
     "void loop() {\n  at = lineAt();\n  if ((long)(millis() - next) >= 0) {\n    next += 60;\n"
     "    power(200 + at * 0.1, 200 - at * 0.1);\n  }\n}\n"},
    {"AnAverageThatIsUsedEachTwentyReadings", "slow_control", "the power changed only every 7",
     "long sum = 0;\nint n = 0;\n"
     "void loop() {\n  sum += lineAt();\n  delay(3);\n  if (++n < 20) return;\n"
     "  power(200 + sum / n * 0.1, 200 - sum / n * 0.1);\n  sum = n = 0;\n}\n"},
    {"APidControllerThatComputesEachFiveMilliseconds", "", "",
     "unsigned long last = 0;\n"
     "void loop() {\n  int at = lineAt();\n  if (millis() - last < 5) return;\n  last = millis();\n"
     "  power(140 + at * 0.06, 140 - at * 0.06);\n}\n"},
    {"ASwitchingFollowerThatIsTooFast", "", "",
     "void loop() {\n  int at = lineAt();\n"
     "  if (at > 600) power(250, 200); else if (at < -600) power(200, 250); else power(250, 250);\n}\n"},
    {"AServoThatTakesTheMotorsTimer", "lost_pwm", "pins 9 and 10 had no PWM, since their timer 1",
     "void setup() {\n  attachServo();\n}\n"
     "volatile int speed = 100;\n"
     "void loop() {\n  analogWrite(9, speed);  //!\n  delay(5);\n  analogWrite(10, speed + 1);\n}\n"},
    {"AServoThatTakesTheTimerOfARunningMotor", "lost_pwm", "pins 9 and 10 lost the PWM, since their timer 1",
     "volatile int speed = 100;\n"
     "void setup() {\n  analogWrite(9, speed);\n  delay(100);\n  attachServo();\n}\n"
     "void loop() { delay(5); }\n"},
    {"AServoBesideMotorsOfOtherTimers", "", "",
     "volatile int speed = 100;\n"
     "void setup() {\n  attachServo();\n}\n"
     "void loop() {\n  analogWrite(5, speed);\n  analogWrite(6, speed);\n  delay(5);\n}\n"},
    {"AToneDuringWhichTheMotorIsSet", "lost_pwm", "pins 3 and 11 had no PWM, since their timer 2",
     "volatile int speed = 100;\n"
     "void setup() {\n  tone(8, 440);\n}\n"
     "void loop() {\n  analogWrite(11, speed++ & 127 | 1);  //!\n  delay(20);\n}\n"},
    {"AToneWithMotorsOnOtherTimers", "", "",
     "volatile int speed = 100;\n"
     "void setup() {\n  tone(8, 440, 200);\n}\n"
     "void loop() {\n  analogWrite(5, speed++ & 127);\n  delay(20);\n}\n"},
    {"ATimerThatTheSketchItselfSetsUpForPwm", "", "",
     "void setup() {\n  pinMode(9, OUTPUT);\n  TCCR1A = _BV(COM1A1);\n  OCR1A = 100;\n  ICR1 = 400;\n"
     "  TCCR1B = _BV(WGM13) | _BV(CS10);\n}\n"
     "void loop() {\n  OCR1A = OCR1A > 300 ? 100 : OCR1A + 1;\n  delay(5);\n}\n"},
    {"AMotorInAnArrayOnAPinWithoutPwm", "lost_pwm", "pin 7 of the uno has no PWM",
     "const byte motors[] = {5, 7};\nvolatile int speed = 100;\nvoid setup() {}\n"
     "void loop() {\n  for (byte i = 0; i < 2; i++)\n    analogWrite(motors[i], speed);  //!\n  "
     "delay(10);\n}\n"},
    {"AButtonWhosePinIsAnOutput", "driven_input",
     "pin 4 (start) is an output, but the part on it outputs a level, too",
     "void setup() {\n  for (byte pin = 4; pin <= 10; pin++)\n    pinMode(pin, OUTPUT);  //!\n}\n"
     "void loop() { delay(5); }\n"},
    {"ASensorWhosePinIsAnOutput", "driven_input", "pin 15 (S2) is an output",
     "void setup() {\n  pinMode(A1, OUTPUT);  //!\n}\nvoid loop() { delay(5); }\n"},
    {"AnEncoderWhosePinIsWritten", "driven_input", "pin 2 (encoder_left) is an output",
     "void setup() {\n  DDRD |= 1 << 2;  //!\n  PORTD |= 1 << 2;\n}\nvoid loop() { delay(5); }\n"},
    {"ARobotFileOfAnotherRobot", "driven_input", "pins 15 (S2), 3 (encoder_right) and 4 (start) are outputs",
     "void setup() {\n  pinMode(3, OUTPUT);  //!\n  pinMode(4, OUTPUT);\n  pinMode(A1, OUTPUT);\n}\n"
     "void loop() { delay(5); }\n"},
    {"ASensorThatIsChargedThroughItsPin", "", "",
     "void setup() {}\n"
     "void loop() {\n  pinMode(A1, OUTPUT);\n  digitalWrite(A1, HIGH);\n  delayMicroseconds(10);\n"
     "  pinMode(A1, INPUT);\n  delay(5);\n}\n"},
    {"AnUnlimitedCorrection", "pwm_range", "analogWrite(6, -80) acted like analogWrite(6, 176)",
     "volatile int turn = 200;\nvoid setup() {}\n"
     "void loop() {\n  analogWrite(5, turn);\n  analogWrite(6, 120 - turn);  //!\n  delay(10);\n}\n"},
    {"AConstantOfWhichTheCompilerKeepsOneByte", "", "",
     "const int kSpeed = 150;\n"
     "static void start() {\n  analogWrite(5, kSpeed);\n  analogWrite(6, kSpeed);\n}\n"
     "void setup() { start(); }\nvoid loop() { delay(5); }\n"},
    {"ALimitedCorrection", "", "",
     "volatile int turn = 200;\nvoid setup() {}\n"
     "void loop() {\n  analogWrite(5, constrain(120 + turn, 0, 255));\n"
     "  analogWrite(6, constrain(120 - turn, 0, 255));\n  delay(10);\n}\n"},
    {"AnInterruptOnAPinFromAnArrayWithoutOne", "no_interrupt", "since it got the interrupt number 255",
     "volatile byte pins[] = {2, 4}, number, n;\nvoid count() { n++; }\n"
     "void setup() {\n  for (byte i = 0; i < 2; i++) {\n    number = digitalPinToInterrupt(pins[i]);\n"
     "    attachInterrupt(number, count, CHANGE);  //!\n  }\n  attachInterrupt(1, count, RISING);\n"
     "}\nvoid loop() { delay(5); }\n"},
    {"ANumberThatIsNoPin", "missing_pin", "digitalRead() got pin 30, which the uno does not have",
     "volatile byte eyes[] = {4, 30}, n;\nvoid setup() {}\n"
     "void loop() {\n  for (byte i = 0; i < 2; i++)\n    n += digitalRead(eyes[i]);  //!\n  delay(5);\n}\n"},
    {"InterruptsOnPinsThatHaveThem", "", "",
     "const byte pins[] = {2, 3};\nvolatile byte n;\nvoid count() { n++; }\n"
     "void setup() {\n  for (byte i = 0; i < 2; i++)\n"
     "    attachInterrupt(digitalPinToInterrupt(pins[i]), count, CHANGE);\n}\nvoid loop() { delay(5); }\n"},
    {"AWaitUntilATimeThatHasPassed", "long_delay", "its number may have been negative, -",
     "unsigned long next = 0;\nvoid setup() {}\n"
     "void loop() {\n  delay(2);\n  next = 10;\n  delay(30);\n"
     "  delay((long)(next - millis()));  //!\n}\n"},
    {"AHandlerThatIsEnteredAgainAndAgain", "busy_handlers", "% in one handler",
     "volatile byte n = 0;\n"
     "ISR(TIMER2_COMPA_vect) {  //!\n  n++;\n}\n"
     "void setup() {\n  TCCR2A = _BV(WGM21);\n  TCCR2B = _BV(CS21);\n  OCR2A = 2;\n  TIMSK2 = "
     "_BV(OCIE2A);\n}\n"
     "void loop() { delay(5); }\n",
     true},
    {"AHandlerEachFiftyMicroseconds", "", "",
     "volatile byte n = 0;\n"
     "ISR(TIMER2_COMPA_vect) {\n  n++;\n}\n"
     "void setup() {\n  TCCR2A = _BV(WGM21);\n  TCCR2B = _BV(CS21);\n  OCR2A = 99;\n  TIMSK2 = "
     "_BV(OCIE2A);\n}\n"
     "void loop() { delay(5); }\n",
     true},
    {"AWaitUntilATimeToCome", "", "",
     "unsigned long next = 0;\nvoid setup() {}\n"
     "void loop() {\n  delay(2);\n  next = millis() + 20;\n  delay((long)(next - millis()));\n}\n"},
};

class DetectedCauses : public testing::TestWithParam<std::tuple<Case, const char*>> {
 protected:
  void SetUp() override { needs_target(std::get<1>(GetParam())); }
};

TEST_P(DetectedCauses, HaveTheirDetectorAndLine) {
  const auto& [one, target] = GetParam();
  if (one.on_chip_only && std::string(target) == "host") return;
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "Trap");
  std::string text = one.sketch;
  const bool follows = text.find("lineAt") != text.npos;
  if (follows) text.insert(0, kFollower);
  if (text.find("attachServo") != text.npos) text.insert(0, kServo);
  write_file(folder / "Trap/Trap.ino", text);
  wire::RunRequest request = request_of({.sketch = folder / "Trap",
                                         .goal = follows ? "laps:1" : "none",
                                         .for_s = follows ? 10.0 : 1.0,
                                         .target = target});
  request.detect = true;
  const std::vector<result::Detected> found = runner_of(target).run(request).detected;
  if (*one.detector == '\0') {
    EXPECT_THAT(found, IsEmpty()) << result::text_of(found[0]);
    return;
  }
  ASSERT_THAT(found, SizeIs(1)) << (found.empty() ? "" : result::text_of(found[1]));
  EXPECT_EQ(found[0].detector, one.detector);
  EXPECT_THAT(found[0].what, HasSubstr(one.says));
  const std::size_t mark = text.find("//!");
  if (mark == std::string::npos) return;
  EXPECT_EQ(found[0].where.line,
            1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(mark), '\n'))
      << result::text_of(found[0]);
}

// The left sensor is at a timer's capture pin. After a read of the timer's flags, the timer waits for edges
// of this pin. The detectors must not count these edges as reads of the sensor.
TEST(DetectedCauses, TakeNoEdgeThatATimerAwaitsForAReadOfASensor) {
  needs_target("avr");
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "Waits");
  write_file(folder / "robot.toml",
             "base = \"uno3\"\n[[part]]\nname = \"left\"\npins = { en = 5, in1 = 7, in2 = 2 }\n"
             "[[part]]\nname = \"left_sensor\"\npin = 8\n");
  write_file(folder / "Waits/Waits.ino",
             "void setup() {\n  for (byte p = 5; p <= 10; p++) if (p != 8) pinMode(p, OUTPUT);\n"
             "  digitalWrite(7, HIGH);\n  digitalWrite(9, HIGH);\n  volatile byte flags = TIFR1;\n}\n"
             "void loop() {\n  static bool odd;\n  odd = !odd;\n"
             "  const bool left = digitalRead(8), right = digitalRead(A2);\n"
             "  analogWrite(5, (left ? 100 : 200) + 20 * odd);\n"
             "  analogWrite(6, (right ? 100 : 200) + 20 * odd);\n  delay(150);\n}\n");
  wire::RunRequest request = request_of({.sketch = folder / "Waits",
                                         .robot = folder / "robot.toml",
                                         .goal = "laps:1",
                                         .for_s = 10.0,
                                         .target = "avr"});
  request.detect = true;
  const result::RunResult result = runner_of("avr").run(request);
  EXPECT_NE(result.verdict, "reached");
  for (const result::Detected& seen : result.detected) EXPECT_NE(seen.detector, "slow_control") << seen.what;
}

INSTANTIATE_TEST_SUITE_P(Of, DetectedCauses,
                         testing::Combine(testing::ValuesIn(kCases), testing::Values("host", "avr")),
                         [](const auto& tested) {
                           return std::string(std::get<0>(tested.param).name) + "_" +
                                  std::get<1>(tested.param);
                         });

}  // namespace detected_causes_test
}  // namespace robosim::test
