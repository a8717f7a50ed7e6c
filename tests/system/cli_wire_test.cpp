// Tests `robosim wire`, which makes a robot file that fits a sketch.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/base/file.h"
#include "tests/system/command.h"
#include "tests/system/system_test.h"

namespace robosim::test {
namespace cli_wire_test {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

// Uses an L298N with jumpered EN pins. Two digital sensors next to the line are LOW over black.
constexpr const char* kTwoEyes = R"(#define LS 2
#define RS 3
#define LM1 5
#define LM2 4
#define RM1 7
#define RM2 8
int button = 12;
void motors(int l, int r) {
  digitalWrite(LM1, l > 0); digitalWrite(LM2, l < 0);
  digitalWrite(RM1, r > 0); digitalWrite(RM2, r < 0);
}
void setup() {
  pinMode(LS, INPUT); pinMode(RS, INPUT); pinMode(button, INPUT_PULLUP);
  pinMode(LM1, OUTPUT); pinMode(LM2, OUTPUT); pinMode(RM1, OUTPUT); pinMode(RM2, OUTPUT);
  while (digitalRead(button) == HIGH) {}
}
void loop() {
  bool l = digitalRead(LS) == LOW, r = digitalRead(RS) == LOW;
  if (l && !r) motors(-1, 1);
  else if (r && !l) motors(1, -1);
  else motors(1, 1);
  delay(2);
}
)";

TEST(CliWire, DraftsARobotOnWhichTheSketchDrivesALap) {
  const Folder folder;
  folder.write("Eyes/Eyes.ino", kTwoEyes);
  const Ended wired = robosim_command({"wire", "./Eyes", "--out", "Eyes/robot.toml"}, folder.path());
  ASSERT_EQ(wired.status, 0) << wired.err;
  const std::string text = read_file(folder.path() / "Eyes/robot.toml");
  EXPECT_THAT(
      text, AllOf(HasSubstr("# With this robot the sketch drives a lap"), HasSubstr("{ in1 = 5, in2 = 4 }"),
                  HasSubstr("{ in1 = 7, in2 = 8 }"), HasSubstr("pins = [2, 3]"), HasSubstr("black = \"low\""),
                  HasSubstr("type = \"button\"\npin = 12")));
  EXPECT_EQ(robosim_command({"robot", "check", "Eyes/robot.toml"}, folder.path()).status, 0);
  folder.write("press.txt", "at 300ms press button 200ms\n");
  const Ended run = robosim_command({"run", "./Eyes", "--script", "press.txt"}, folder.path());
  EXPECT_EQ(run.status, 0) << run.out;

  const Ended again = robosim_command({"wire", "./Eyes", "--out", "Eyes/robot.toml"}, folder.path());
  EXPECT_EQ(again.status, 2);
  EXPECT_EQ(
      again.err,
      "robosim: Eyes/robot.toml: exists already; nothing was written; remove it, or name another --out\n");
  EXPECT_EQ(read_file(folder.path() / "Eyes/robot.toml"), text);
}

TEST(CliWire, FindsTheStockRobotsPinsFromTheStockSketchAlone) {
  const Ended wired = robosim_command({"wire", "PidFollower"});
  ASSERT_EQ(wired.status, 0) << wired.err;
  EXPECT_THAT(wired.out, AllOf(HasSubstr("base = \"uno5\""), HasSubstr("{ en = 5, in1 = 7, in2 = 8 }"),
                               HasSubstr("{ en = 6, in1 = 9, in2 = 10 }"),
                               HasSubstr("pins = [\"A0\", \"A1\", \"A2\", \"A3\", \"A4\"]"),
                               HasSubstr("drives a lap of the map oval")));
}

// The sketch names its motors A and B, but A is on the right. No comment in the sketch says so.
TEST(CliWire, TriesTheSidesThatNamesLeaveOpenAndSaysWhatCameOfIt) {
  const Folder folder;
  folder.write("Sides/Sides.ino", R"(const int ENA = 10, IN1 = 7, IN2 = 6, ENB = 9, IN3 = 5, IN4 = 4;
void setup() {
  pinMode(ENA, OUTPUT); pinMode(IN1, OUTPUT); pinMode(IN2, OUTPUT);
  pinMode(ENB, OUTPUT); pinMode(IN3, OUTPUT); pinMode(IN4, OUTPUT);
  digitalWrite(IN1, HIGH); digitalWrite(IN2, LOW); digitalWrite(IN3, HIGH); digitalWrite(IN4, LOW);
}
void loop() {
  bool left = digitalRead(13), right = digitalRead(11);
  analogWrite(ENA, right && !left ? 0 : 120);
  analogWrite(ENB, left && !right ? 0 : 120);
}
)");
  const Ended wired = robosim_command({"wire", "./Sides"}, folder.path());
  ASSERT_EQ(wired.status, 0) << wired.err;
  EXPECT_THAT(wired.out,
              AllOf(HasSubstr("drives a lap of the map oval"),
                    HasSubstr("wirings were tried on the map oval"), HasSubstr("; a whole lap (this draft)"),
                    HasSubstr("# ? Decided by trials alone, so check:"), HasSubstr("motors swapped")));
}

TEST(CliWire, ChoosesABoardThatHasThePins) {
  const Folder folder;
  folder.write("Seven/Seven.ino", "void setup() {}\nvoid loop() { analogRead(A7); delay(5); }\n");
  folder.write("Many/Many.ino", "void setup() { pinMode(40, OUTPUT); }\nvoid loop() { delay(5); }\n");
  folder.write("Lines/Lines.ino", "void setup() { Serial3.begin(9600); }\nvoid loop() { delay(5); }\n");
  EXPECT_THAT(robosim_command({"wire", "./Lines"}, folder.path()).out, HasSubstr("board = \"mega\""));
  folder.write("Soft/Soft.ino",
               "#include <SoftwareSerial.h>\nSoftwareSerial Serial3(6, 7);\n"
               "void setup() { Serial3.begin(9600); }\nvoid loop() { delay(5); }\n");
  EXPECT_THAT(robosim_command({"wire", "./Soft"}, folder.path()).out, HasSubstr("board = \"uno\""));
  EXPECT_THAT(robosim_command({"wire", "./Seven"}, folder.path()).out, HasSubstr("board = \"nano\""));
  EXPECT_THAT(robosim_command({"wire", "./Many"}, folder.path()).out, HasSubstr("board = \"mega\""));
}

TEST(CliWire, UsesTheChipIfTheSketchCompilesOnlyThere) {
  const Folder folder;
  folder.write("Asm/Asm.ino",
               "void setup() { asm(\"sbi 4, 1\"); }\nvoid loop() { digitalRead(2); delay(5); }\n");
  EXPECT_THAT(robosim_command({"wire", "./Asm"}, folder.path()).out, HasSubstr("pin = 2"));
}

TEST(CliWire, ReadsOnlyFilesOfTheSketchAndOfALimitedSize) {
  const Folder folder;
  folder.write("other/secret.h", "#define LEFT_EN_HUNTER2 5\n");
  folder.write("My/lib/Motor.h", "#define LEFT_EN_MOTOR 5\n");
  const std::string sketch =
      "#include \"lib/Motor.h\"\nvoid setup() { pinMode(LEFT_EN_MOTOR, OUTPUT); }\n"
      "void loop() { analogWrite(LEFT_EN_MOTOR, 100); delay(5); }\n";
  const auto includes = [](const std::string& name) { return "#if 0\n#include \"" + name + "\"\n#endif\n"; };
  std::filesystem::create_symlink(folder.path() / "other/secret.h", folder.path() / "My/link.h");
  folder.write("My/My.ino", includes((folder.path() / "other/secret.h").string()) + includes("link.h") +
                                includes("../other/secret.h") + sketch);
  const Ended draft = robosim_command({"wire", "./My"}, folder.path());
  EXPECT_EQ(draft.status, 0) << draft.err;
  EXPECT_THAT(draft.out, AllOf(HasSubstr("LEFT_EN_MOTOR"), Not(HasSubstr("HUNTER2"))));
  for (const char* name : {"My/large.h", "My/larger.h"})
    folder.write(name, "// " + std::string(300'000, 'x') + "\n");
  const Ended large = robosim_command({"wire", "./My"}, folder.path());
  EXPECT_EQ(large.status, 2);
  EXPECT_THAT(large.err,
              HasSubstr("the sketch is too large to draft a robot: expected sources of at most 512 KB"));
}

TEST(CliWire, WhatItCannotDoIsSaidInASentence) {
  const Folder folder;
  folder.write("Bad/Bad.ino", "void setup() { pinMod(3, OUTPUT); }\nvoid loop() {}\n");
  const Ended broken = robosim_command({"wire", "./Bad"}, folder.path());
  EXPECT_EQ(broken.status, 2);
  EXPECT_THAT(broken.err, HasSubstr("Bad.ino:1"));
  const Ended board = robosim_command({"wire", "PidFollower", "--board", "esp32"});
  EXPECT_EQ(board.status, 2);
  EXPECT_THAT(board.err, HasSubstr("--board"));
  folder.write("Idle/Idle.ino", "void setup() {}\nvoid loop() { delay(1000); }\n");
  const Ended idle = robosim_command({"wire", "./Idle"}, folder.path());
  EXPECT_EQ(idle.status, 0) << idle.err;
  EXPECT_THAT(idle.out, HasSubstr("remove = \"all\""));
}

}  // namespace cli_wire_test
}  // namespace robosim::test
