// Tests scripts that calibrate, place and start the robot, as users do before a run, on host and AVR.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/require_target.h"
#include "tests/system/command.h"

namespace robosim::test {
namespace rituals_test {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

// Calibrates while the robot is moved, and prints the number of sensors that saw both black and white.
constexpr const char* kCalibrates = R"(int low[5], high[5];
void wait() { while (digitalRead(4)) {} }
void setup() {
  pinMode(4, INPUT_PULLUP);
  Serial.begin(9600);
  for (int i = 0; i < 5; i++) { low[i] = 1023; high[i] = 0; }
  wait();
  while (millis() < 6000)
    for (int i = 0; i < 5; i++) {
      int v = analogRead(A0 + i);
      if (v < low[i]) low[i] = v;
      if (v > high[i]) high[i] = v;
    }
  int good = 0;
  for (int i = 0; i < 5; i++) if (high[i] - low[i] > 400) good++;
  Serial.print("good "); Serial.println(good);
}
void loop() { Serial.println(analogRead(A2) > 500 ? "line" : "floor"); delay(200); }
)";

class Rituals : public ::testing::TestWithParam<const char*> {
 protected:
  std::string serial(const std::string& script) const {
    folder_.write("Mine/Mine.ino", kCalibrates);
    folder_.write("s.txt", script);
    const Ended ended = robosim_command({"run", "./Mine", "--map", "oval", "--target", GetParam(), "--goal",
                                         "none", "--for", "8s", "--serial", "--script", "s.txt"},
                                        folder_.path());
    return ended.out + ended.err;
  }
  Folder folder_;
};

TEST_P(Rituals, AHandThatMovesTheRobotOverTheLineCalibratesItsSensors) {
  if (std::string(GetParam()) != "host") ROBOSIM_NEEDS_TARGET(GetParam());
  EXPECT_THAT(serial("at 1s press start 100ms\nat 1.5s sweep 50mm for 4s\n"),
              AllOf(HasSubstr("good 5"), HasSubstr("line"), Not(HasSubstr("floor")), Not(HasSubstr("lost"))));
  EXPECT_THAT(serial("at 1s press start 100ms\n"), HasSubstr("good 0"));
  EXPECT_THAT(serial("at 1s press start 100ms\nat 1.5s sweep 50mm for 4s\n"),
              HasSubstr("cross-track  0.0 mm RMS, 0.0 mm at most"));
}

TEST_P(Rituals, TheRobotCanBePutBesideTheLine) {
  if (std::string(GetParam()) != "host") ROBOSIM_NEEDS_TARGET(GetParam());
  EXPECT_THAT(serial("at 1s press start 100ms\nat 6.2s place 1000mm,700mm,NE\n"), HasSubstr("floor"));
}

// SoftwareSerial has one interrupt handler, and registers the handler for the pin changes of every port.
TEST_P(Rituals, AByteByBluetoothEndsAWaitOnSoftwareSerialOnPinsOfAnyPort) {
  if (std::string(GetParam()) != "host") ROBOSIM_NEEDS_TARGET(GetParam());
  folder_.write("Bt/Bt.ino",
                "#include <SoftwareSerial.h>\nSoftwareSerial bt(2, 3);\n"
                "void setup() { Serial.begin(9600); bt.begin(9600); while (bt.read() != 'g') {} "
                "Serial.println(\"going\"); }\nvoid loop() { delay(10); }\n");
  folder_.write(
      "Bt/robot.toml",
      "base = \"uno2\"\n[[part]]\nname = \"bt\"\ntype = \"bluetooth\"\npins = { txd = 2, rxd = 3 }\n");
  folder_.write("bt.txt", "at 4s send bt \"g\"\n");
  const Ended ended = robosim_command({"run", "./Bt", "--target", GetParam(), "--goal", "none", "--for", "5s",
                                       "--serial", "--script", "bt.txt"},
                                      folder_.path());
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_EQ(ended.out, "going\r\n");
}

INSTANTIATE_TEST_SUITE_P(On, Rituals, ::testing::Values("host", "avr"));

}  // namespace rituals_test
}  // namespace robosim::test
