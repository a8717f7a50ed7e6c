// Tests `robosim why`, which traces a verdict back to the lines of the sketch.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "sim/base/file.h"
#include "tests/system/command.h"
#include "tests/system/system_test.h"

namespace robosim::test {
namespace cli_why_test {

namespace fs = std::filesystem;

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

// Reads the line sensor once, and keeps driving with that value.
constexpr const char* kLooksOnce = R"(const int MIDDLE = A2;
const int FAST = 200;
int left, right;
void drive() {
  digitalWrite(7, HIGH);
  digitalWrite(9, HIGH);
  analogWrite(5, left);
  analogWrite(6, right);
}
void setup() {
  for (int pin = 5; pin <= 10; pin++) pinMode(pin, OUTPUT);
  int seen = analogRead(MIDDLE);
  left = FAST;
  right = FAST - seen / 32;
}
void loop() {
  drive();
  delay(5);
}
)";

// No sensor is ever as dark as the sketch requires, so the motors stay unchanged.
constexpr const char* kLeavesAsItWas = R"(const byte PINS[] = {A0, A1, A2};
void setup() {
  for (int pin = 5; pin <= 10; pin++) pinMode(pin, OUTPUT);
  digitalWrite(7, HIGH);
  digitalWrite(9, HIGH);
}
void loop() {
  byte seen = 0;
  for (byte i = 0; i < 3; i++) {
    int dark = analogRead(PINS[i]);
    if (dark > 1020)                                 // line 11
      seen = 1;
  }
  int other = analogRead(A4);
  float off = 0;
  if (other > 1020) off = 0.5;                       // line 16
  float turn = off * 80;
  analogWrite(5, seen ? 60 : 120);
  analogWrite(6, 100 + turn);
  delay(5);
}
)";

// Leaves the line, stops some time later, and never drives again.
constexpr const char* kStops = R"(bool done = false;
unsigned long began = 0;
void stop() {
  analogWrite(5, 0);
  analogWrite(6, 0);
}
void setup() {
  for (int pin = 5; pin <= 10; pin++) pinMode(pin, OUTPUT);
  digitalWrite(7, HIGH);
  digitalWrite(9, HIGH);
}
void loop() {
  if (done) return delay(2);                         // line 13
  analogRead(A2);
  if (began == 0) began = millis();
  if (millis() - began > 700) {
    done = true;                                     // line 17
    return stop();
  }
  analogWrite(5, 200);
  analogWrite(6, 150);
  delay(2);
}
)";

// Waits for a button that is not pressed.
constexpr const char* kWaitsForAButton = R"(bool started = false;
void setup() {
  for (int pin = 5; pin <= 10; pin++) pinMode(pin, OUTPUT);
  pinMode(4, INPUT_PULLUP);
}
void loop() {
  if (digitalRead(4) == LOW) started = true;         // line 7
  if (!started) return;                              // line 8
  digitalWrite(7, HIGH);
  analogWrite(5, 90);
}
)";

// Waits for a button, then turns on the spot.
constexpr const char* kTurnsLater = R"(void setup() {
  for (int pin = 5; pin <= 10; pin++) pinMode(pin, OUTPUT);
  pinMode(4, INPUT_PULLUP);
  while (digitalRead(4) == HIGH) delay(10);          // line 4
}
void loop() {
  int seen = analogRead(A2);
  digitalWrite(7, HIGH);
  digitalWrite(10, HIGH);                            // line 9: the pin should be 9
  analogWrite(5, 80);
  analogWrite(6, seen > 0 ? 80 : 81);
}
)";

// Waits for a handler that never runs.
constexpr const char* kSwitchesInterruptsOff = R"(volatile bool turning = false;
void onEdge() { turning = true; }
void setup() {
  for (int pin = 5; pin <= 10; pin++) pinMode(pin, OUTPUT);
  attachInterrupt(digitalPinToInterrupt(2), onEdge, CHANGE);
  noInterrupts();                                    // line 6
  turning = false;
  digitalWrite(7, HIGH);
  analogWrite(5, 90);
}
void loop() {
  while (!turning) {
  }
}
)";

class CliWhy : public ::testing::Test {
 protected:
  void SetUp() override {
    ROBOSIM_NEEDS_TARGET("avr");
    folder_.write("Once/Once.ino", kLooksOnce);
  }
  Folder folder_;
};

// The expected voltages are from a recording (--record run.vcd). The search for causes goes back to earlier
// readings, which must not be printed instead.
TEST_F(CliWhy, ShowsTheReadingsOfTheTimeThatItPrints) {
  ASSERT_EQ(robosim_command({"new", "Fast"}, folder_.path()).status, 0);
  std::string sketch = read_file(folder_.path() / "Fast/Fast.ino");
  const std::string slow = "BASE_SPEED = 110";
  sketch.replace(sketch.find(slow), slow.size(), "BASE_SPEED = 200");
  folder_.write("Fast/Fast.ino", sketch);
  const Ended why = robosim_command({"why", "Fast"}, folder_.path());
  EXPECT_THAT(why.out, HasSubstr("5.022 s  ← read S4 (A3) 0.40 V, S3 (A2) 0.34 V, S2 (A1) 0.33 V, "
                                 "S1 (A0) 0.36 V, S5 (A4) 0.79 V\n"))
      << why.err;
}

TEST_F(CliWhy, NamesTheLinesFromTheMotorsToTheReading) {
  const Ended why = robosim_command({"why", "./Once", "--map", "oval", "--all"}, folder_.path());
  EXPECT_EQ(why.status, 1) << why.err;
  EXPECT_THAT(why.out,
              AllOf(StartsWith("lost: The robot lost the line"),
                    HasSubstr("the robot left the line; motors: left 79 %, right 68 %"),
                    HasSubstr("Once.ino:7 "), HasSubstr("analogWrite(5, left);"), HasSubstr("Once.ino:14 "),
                    HasSubstr("read S3 (A2) "), HasSubstr("Once.ino:12 "),
                    HasSubstr("Once.ino:1,2                const int MIDDLE = A2 · const int FAST = 200\n")));

  const Ended json = robosim_command({"why", "./Once", "--map", "oval", "--json"}, folder_.path());
  const auto chain = nlohmann::json::parse(json.out);
  EXPECT_EQ(chain["verdict"], "lost");
  ASSERT_GE(chain["because"].size(), 3u);
  EXPECT_THAT(chain["because"][0]["text"].get<std::string>(), StartsWith("the robot left the line"));
  const Ended run =
      robosim_command({"run", "./Once", "--map", "oval", "--target", "avr", "--json"}, folder_.path());
  const auto plain = nlohmann::json::parse(run.out);
  EXPECT_EQ(plain["trace_hash"], chain["trace_hash"]) << "both commands simulate the same run";
  EXPECT_FALSE(plain.contains("because"));
}

TEST_F(CliWhy, PrintsTheTenMostDirectLinesAndHowManyMoreThereAre) {
  const Ended why = robosim_command({"why", "./Once", "--map", "oval", "--target", "avr"}, folder_.path());
  std::size_t lines = 0;
  for (std::size_t at = 0; (at = why.out.find("  Once.ino:", at)) != std::string::npos; ++at) ++lines;
  EXPECT_EQ(lines, 10u) << why.out;
  EXPECT_THAT(why.out, AllOf(HasSubstr("Once.ino:8 "), HasSubstr("Once.ino:12 "), HasSubstr("Once.ino:14 "),
                             HasSubstr(" more line: --all\n")));
  const Ended host = robosim_command({"why", "./Once", "--target", "host"}, folder_.path());
  EXPECT_EQ(host.status, 2);
  EXPECT_THAT(host.err, HasSubstr("--target"));
}

TEST_F(CliWhy, ShowsWhatADetectorHasFound) {
  std::filesystem::create_directories(folder_.path() / "Range");
  std::string text = kLooksOnce;
  text.replace(text.find("analogWrite(6, right);"), 22, "analogWrite(6, right - 300);");
  write_file(folder_.path() / "Range/Range.ino", text);
  const Ended why = robosim_command({"why", "./Range", "--map", "oval"}, folder_.path());
  EXPECT_THAT(why.out, HasSubstr("\ndetected: analogWrite(6, -"));
}

TEST_F(CliWhy, NamesWhatLeftAValueAsItWas) {
  folder_.write("Leaves/Leaves.ino", kLeavesAsItWas);
  const Ended why = robosim_command({"why", "./Leaves", "--map", "oval", "--all"}, folder_.path());
  EXPECT_THAT(why.out,
              AllOf(StartsWith("stuck: "), HasSubstr("Leaves.ino:11 "), HasSubstr("Leaves.ino:16 ")));
}

TEST_F(CliWhy, NamesWhatStoppedItAndWhyItDidNotDriveOn) {
  folder_.write("Stops/Stops.ino", kStops);
  const Ended why =
      robosim_command({"why", "./Stops", "--map", "oval", "--for", "4s", "--all"}, folder_.path());
  EXPECT_THAT(why.out, AllOf(StartsWith("timeout: "), HasSubstr("the robot left the line; "),
                             HasSubstr("← its motors stopped here and stayed off; "),
                             HasSubstr("Stops.ino:13 "), HasSubstr("Stops.ino:17 ")));
}

TEST_F(CliWhy, NamesWhyItHasNotMoved) {
  folder_.write("Button/Button.ino", kWaitsForAButton);
  const Ended why = robosim_command({"why", "./Button", "--map", "oval", "--for", "2s"}, folder_.path());
  EXPECT_THAT(
      why.out,
      AllOf(StartsWith("timeout: "), HasSubstr("the robot has not moved, and the sketch was here; "),
            HasSubstr("Button.ino:8 "), HasSubstr("Button.ino:7 "), HasSubstr("read start (D4) HIGH")));
}

TEST_F(CliWhy, BeginsWhereARobotThatWaitedBeganToTurnOnTheSpot) {
  folder_.write("Later/Later.ino", kTurnsLater);
  folder_.write("press.txt", "at 3s press start 200ms\n");
  const Ended why = robosim_command(
      {"why", "./Later", "--map", "oval", "--goal", "laps:1", "--for", "12s", "--script", "press.txt"},
      folder_.path());
  EXPECT_THAT(why.out,
              AllOf(HasSubstr("spinning clockwise near column 10, row 14 since 3.06 s"),
                    HasSubstr("the robot spins from here on; motors: left 32 %, right -32 % since 3.01 s"),
                    HasSubstr("Later.ino:9 ")));
}

TEST_F(CliWhy, SaysOfARobotThatDrivesLapsThatItsTimeWasUp) {
  const Ended why = robosim_command(
      {"why", "PidFollower", "--map", "oval", "--goal", "laps:50", "--for", "8s"}, folder_.path());
  EXPECT_THAT(why.out, AllOf(HasSubstr("the robot was still driving when its time was up; motors: "),
                             Not(HasSubstr("in one place"))));
}

TEST_F(CliWhy, NamesWhoSwitchedInterruptsOffAndWhatWaitsForOne) {
  folder_.write("Waits/Waits.ino", kSwitchesInterruptsOff);
  const Ended why =
      robosim_command({"why", "./Waits", "--map", "oval", "--goal", "none", "--for", "3s"}, folder_.path());
  EXPECT_THAT(why.out, AllOf(StartsWith("hung: "),
                             HasSubstr("interrupts were disabled here, and were off at all later checks\n    "
                                       "            Waits.ino:6 "),
                             HasSubstr("Waits.ino:12 "),
                             HasSubstr("an interrupt handler writes turning\n                Waits.ino:2 "),
                             HasSubstr("Waits.ino:5 ")));
}

TEST_F(CliWhy, HasNothingToTellOfASuccess) {
  const Ended why = robosim_command({"why", "./Once", "--goal", "none", "--for", "100ms"}, folder_.path());
  EXPECT_EQ(why.status, 0) << why.err;
  EXPECT_THAT(why.out, AllOf(StartsWith("reached: "), Not(HasSubstr("←"))));
}

TEST_F(CliWhy, FollowsFirstTheMotorThatNeverGotPower) {
  std::string text = kLooksOnce;
  text.replace(text.find("digitalWrite(7"), 14, "digitalWrite(4");
  folder_.write("Side/Side.ino", text);
  const Ended why = robosim_command({"why", "./Side", "--map", "oval", "--all"}, folder_.path());
  // Lines 5 and 7 drive the left motor, lines 6 and 8 the right one.
  const std::size_t left = why.out.find("Side.ino:7 "), right = why.out.find("Side.ino:8 ");
  EXPECT_LT(left, right) << why.out;
  const Ended both = robosim_command({"why", "./Once", "--map", "oval", "--all"}, folder_.path());
  EXPECT_GT(both.out.find("Once.ino:7 "), both.out.find("Once.ino:8 ")) << both.out;
}

// The motors' commands go to the shield in bytes.
TEST_F(CliWhy, FollowsTheBytesThatWereSentToAMotorShield) {
  const fs::path shield = folder_.path() / "MotorShieldV2";
  fs::copy(fs::path(ROBOSIM_SAMPLES) / "MotorShieldV2", shield);
  std::string sketch = read_file(shield / "MotorShieldV2.ino");
  const std::size_t at = sketch.find("right.run(constrain(");
  const auto line = 1 + std::count(sketch.begin(), sketch.begin() + static_cast<std::ptrdiff_t>(at), '\n');
  sketch.replace(at, 5, "left");
  write_file(shield / "MotorShieldV2.ino", sketch);
  const Ended why = robosim_command({"why", ".", "--map", "oval", "--goal", "laps:1"}, shield);
  EXPECT_THAT(why.out, HasSubstr(fmt::format("MotorShieldV2.ino:{} ", line))) << why.err;
}

TEST_F(CliWhy, FollowsTheServoThatSteers) {
  const fs::path car = folder_.path() / "ServoSteering";
  fs::copy(fs::path(ROBOSIM_SAMPLES) / "ServoSteering", car);
  std::string sketch = read_file(car / "ServoSteering.ino");
  sketch.replace(sketch.find("steer(constrain(error"), 21, "steer(constrain(-error");
  write_file(car / "ServoSteering.ino", sketch);
  const Ended why = robosim_command({"why", ".", "--map", "oval", "--goal", "laps:1"}, car);
  EXPECT_THAT(why.out, HasSubstr("steer(constrain(-error")) << why.err;
}

// Before a power cut, the chip has no state from which a cause could come.
TEST_F(CliWhy, EndsAtAPowerCut) {
  folder_.write("cut.txt", "at 50ms power off for 40ms\n");
  const Ended why =
      robosim_command({"why", "./Once", "--map", "oval", "--script", "cut.txt", "--all"}, folder_.path());
  EXPECT_THAT(why.out, AllOf(StartsWith("lost: "), HasSubstr("Once.ino:8 "), HasSubstr("Once.ino:12 "),
                             HasSubstr("Once.ino:14 ")))
      << why.err;
  folder_.write("cut.txt", "at 50ms power off for 300ms\n");
  const Ended longer =
      robosim_command({"why", "./Once", "--map", "oval", "--script", "cut.txt", "--all"}, folder_.path());
  EXPECT_THAT(longer.out, AllOf(StartsWith("lost: "), HasSubstr("Once.ino:12 ")));
}

TEST_F(CliWhy, ShowsLinesOfItsOwnLibraryAfterThoseOfTheSketch) {
  const Ended why = robosim_command(
      {"why", "PidFollower", "--map", "oval", "--goal", "laps:50", "--for", "8s"}, folder_.path());
  EXPECT_THAT(why.out, Not(HasSubstr("libraries/")));
  const Ended all = robosim_command(
      {"why", "PidFollower", "--map", "oval", "--goal", "laps:50", "--for", "8s", "--all"}, folder_.path());
  EXPECT_THAT(all.out, testing::ContainsRegex("libraries/LineKit/src/PidController.cpp:[0-9]+ +[a-z]"));
}

TEST_F(CliWhy, IsOfTheAvrOnly) {
  wire::RunRequest request = request_of({.sketch = "PidFollower", .for_s = 0.01});
  request.why = true;
  try {
    runner_of("host").run(request);
    FAIL() << "the host accepted a request with `why`";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("requires a sketch on the target avr"));
  }
}

}  // namespace cli_why_test
}  // namespace robosim::test
