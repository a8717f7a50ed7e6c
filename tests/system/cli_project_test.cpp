// Tests `robosim` in the folders of other tools: PlatformIO and arduino-cli.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "tests/support/require_target.h"
#include "tests/system/command.h"

namespace robosim::test {
namespace cli_project_test {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

/// Writes a follower in several files: sources in folders, a library with src/, a library with include/, and
/// a header of the project that both libraries include.
void write_platformio(const Folder& folder) {
  folder.write("platformio.ini",
               "[env:uno]\nplatform = atmelavr\nboard = uno\nframework = arduino\n"
               "build_flags = -D BASE_SPEED=90\n"
               "[env:mega]\nextends = env:uno\nboard = megaatmega2560\n");
  folder.write("robot.toml", "base = \"uno2\"\n");
  folder.write("include/config.h", "#pragma once\nconst int kGain = 6;\n");
  folder.write("lib/Drive/src/Drive.h", "#pragma once\nvoid drive(int left, int right);\n");
  folder.write("lib/Drive/src/Drive.cpp",
               "#include <Drive.h>\n#include <Arduino.h>\n#include \"config.h\"\n"
               "void drive(int left, int right) { Serial.print(left); Serial.print(' '); "
               "Serial.println(right + 0 * kGain); }\n");
  folder.write("lib/Bend/include/bend.h", "#pragma once\nint bent(int);\n");
  folder.write("lib/Bend/src/bend.cpp", "#include \"bend.h\"\nint bent(int x) { return x + 1; }\n");
  folder.write("src/parts/sense.h", "int sense();\n");
  folder.write("src/parts/sense.cpp",
               "#include \"sense.h\"\n#include <bend.h>\nint sense() { return bent(4); }\n");
  folder.write("src/main.cpp",
               "#include <Arduino.h>\n#include <Drive.h>\n#include \"config.h\"\n#include \"parts/sense.h\"\n"
               "void setup() { Serial.begin(9600); drive(BASE_SPEED, sense()); pinMode(NUM_DIGITAL_PINS - 1, "
               "INPUT); }\n"
               "void loop() { Serial.println(NUM_DIGITAL_PINS); delay(500); }\n");
}

TEST(CliProject, APlatformioProjectRunsAsItIsOnHostAndChip) {
  const Folder folder;
  write_platformio(folder);
  for (const char* target : {"host", "avr"}) {
    if (std::string(target) == "avr") ROBOSIM_NEEDS_TARGET("avr");
    const Ended ended =
        robosim_command({"run", "--goal", "none", "--for", "1s", "--target", target}, folder.path());
    EXPECT_EQ(ended.status, 0) << ended.err;
    EXPECT_THAT(ended.out, AllOf(HasSubstr("90 5"), HasSubstr("20"))) << target;
  }
}

TEST(CliProject, AnotherEnvironmentPutsTheRobotOnItsBoard) {
  const Folder folder;
  write_platformio(folder);
  const Ended ended =
      robosim_command({"run", "--goal", "none", "--for", "1s", "--env", "mega"}, folder.path());
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_THAT(ended.err,
              HasSubstr("the robot is robot.toml@mega: platformio.ini names the board megaatmega2560"));
  EXPECT_THAT(ended.out, HasSubstr("70"));
}

TEST(CliProject, AnErrorNamesTheFileAsItIsCalledInTheProject) {
  const Folder folder;
  write_platformio(folder);
  folder.write("src/parts/sense.cpp", "int sense() { return gone; }\n");
  const Ended ended = robosim_command({"build"}, folder.path());
  EXPECT_EQ(ended.status, 2);
  EXPECT_THAT(ended.err, HasSubstr("src/parts/sense.cpp:1:22: error: 'gone' was not declared"));
}

TEST(CliProject, ABoardThatRobosimLacksCanBeReplacedByOneThatItHas) {
  const Folder folder;
  write_platformio(folder);
  folder.write("platformio.ini",
               "[env:esp]\nboard = esp32dev\nframework = arduino\nbuild_flags = -DBASE_SPEED=1\n");
  const Ended refused = robosim_command({"run"}, folder.path());
  EXPECT_EQ(refused.status, 2);
  EXPECT_THAT(refused.err, HasSubstr("platformio.ini:2: unknown board esp32dev"));
  EXPECT_EQ(robosim_command({"build", "--robot", "uno2@nano"}, folder.path()).status, 0);
}

TEST(CliProject, ASketchsProfileChoosesTheBoardAndTellsOfLibrariesOfAnotherVersion) {
  const Folder folder;
  folder.write("My/My.pde",
               "#include <Blinker.h>\nvoid setup() { pinMode(50, OUTPUT); blinker(); }\nvoid loop() {}\n");
  folder.write("My/libraries/Blinker/library.properties", "name=Blinker\nversion=1.0.0\n");
  folder.write("My/libraries/Blinker/Blinker.h", "inline void blinker() {}\n");
  folder.write(
      "My/sketch.yaml",
      "profiles:\n  m:\n    fqbn: arduino:avr:mega\n    libraries:\n      - Blinker (1.2.0)\n      - Gone\n"
      "default_profile: m\n");
  const Ended ended = robosim_command({"build", "./My"}, folder.path());
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_THAT(ended.err, AllOf(HasSubstr("sketch.yaml requires Blinker 1.2.0; version 1.0.0 in "),
                               HasSubstr("sketch.yaml requires Gone, which is in no folder of libraries")));
  EXPECT_THAT(ended.out, HasSubstr("mega"));
}

TEST(CliProject, AFolderThatArduinoCliHasBuiltInRunsOnTheBoardThatItWasBuiltFor) {
  ROBOSIM_NEEDS_TARGET("avr");
  const Folder folder;
  folder.write("My/My.ino",
               "void setup() { Serial.begin(9600); }\nvoid loop() { Serial.println(F_CPU); delay(100); }\n");
  ASSERT_EQ(robosim_command({"build", "./My", "--target", "avr", "--robot", "uno5@mega", "--out", "made"},
                            folder.path())
                .status,
            0);
  folder.write("My/robot.toml", "base = \"uno2\"\n");
  folder.write("My/build/arduino.avr.mega/My.ino.elf", read_file(folder / "made/My.elf"));
  const Ended ended =
      robosim_command({"run", "My/build/arduino.avr.mega", "--goal", "none", "--for", "1s"}, folder.path());
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_THAT(ended.err, HasSubstr("the robot is robot.toml@mega"));
  EXPECT_THAT(ended.out, AllOf(HasSubstr("16000000"), Not(HasSubstr("crashed"))));
}

TEST(CliProject, AProgramForABoardOfAnotherCoreRunsOnOneWithItsChip) {
  ROBOSIM_NEEDS_TARGET("avr");
  const Folder folder;
  folder.write("My/My.ino",
               "void setup() { Serial.begin(9600); }\nvoid loop() { Serial.println(F_CPU); delay(100); }\n");
  for (const auto& [robot, says] : {std::pair{"uno5@promini8", "MiniCore:avr:328:clock=8MHz_external"},
                                    std::pair{"uno5@mega", "MegaCore:avr:2560"}}) {
    ASSERT_EQ(
        robosim_command({"build", "./My", "--target", "avr", "--robot", robot, "--out", "out"}, folder.path())
            .status,
        0);
    folder.write("out/build.options.json", std::string("{\"fqbn\": \"") + says + "\"}");
    const Ended ended =
        robosim_command({"run", "out/My.elf", "--goal", "none", "--for", "1s"}, folder.path());
    EXPECT_EQ(ended.status, 0) << ended.err;
    EXPECT_THAT(ended.err, HasSubstr(std::string("build.options.json names the board ") + says +
                                     ", which Robosim does not have: the program is for an ATmega"));
    EXPECT_THAT(ended.out, HasSubstr(robot == std::string("uno5@mega") ? "16000000" : "8000000"));
  }
}

/// Returns the fields that the problem matcher of tasks.json finds: file, line, column, severity, message.
std::vector<std::string> matched(const Folder& folder, const std::string& line) {
  const auto tasks =
      nlohmann::json::parse(read_file(folder / "Mine/.vscode/tasks.json"), nullptr, true, true)["tasks"];
  const std::regex pattern(tasks[0]["problemMatcher"]["pattern"]["regexp"].get<std::string>());
  std::smatch parts;
  if (!std::regex_match(line, parts, pattern)) return {};
  return {parts[1], parts[2], parts[3], parts[4], parts[5]};
}

std::vector<std::string> first_match(const Folder& folder, const std::string& text) {
  std::vector<std::string> found;
  std::istringstream lines(text);
  for (std::string line; found.empty() && std::getline(lines, line);) found = matched(folder, line);
  return found;
}

TEST(CliProject, ANewProjectsTaskMarksWhatRobosimSaysOfItsFiles) {
  const Folder folder;
  ASSERT_EQ(robosim_command({"new", "Mine"}, folder.path()).status, 0);
  folder.write("Mine/Mine.ino", "void setup() {\n  halt();\n}\nvoid loop() {}\n");
  const Ended error = robosim_command({"run"}, folder / "Mine");
  EXPECT_THAT(first_match(folder, error.err),
              ElementsAre("Mine.ino", "2", "3", "error", HasSubstr("'halt' was not declared")))
      << error.err;
  folder.write("Mine/Mine.ino", "void setup() {}\nvoid loop() {}\n");
  folder.write("Mine/robot.toml", "base = \"uno5\"\nbord = \"uno\"\n");
  const Ended key = robosim_command({"run"}, folder / "Mine");
  EXPECT_THAT(first_match(folder, key.err),
              ElementsAre(EndsWith("robot.toml"), "2", "8", "", HasSubstr("bord")))
      << key.err;
  EXPECT_THAT(matched(folder, "lost: The robot left the line at 0.78 s near column 12, row 14"), IsEmpty());
}

TEST(CliProject, WithSerialTheStandardOutputIsWhatTheSketchSends) {
  const Folder folder;
  folder.write("Tests/Tests.ino",
               "void setup() { Serial.begin(9600); Serial.println(\"t.cpp:3:adds:PASS\"); "
               "Serial.println(\"1 Tests 0 Failures 0 Ignored\"); }\nvoid loop() {}\n");
  const Ended ended =
      robosim_command({"run", "./Tests", "--goal", "none", "--for", "60s", "--serial"}, folder.path());
  EXPECT_EQ(ended.out, "t.cpp:3:adds:PASS\r\n1 Tests 0 Failures 0 Ignored\r\n");
  EXPECT_EQ(ended.status, 0);
  EXPECT_THAT(ended.err, HasSubstr("ended: The sketch ended"));
}

}  // namespace cli_project_test
}  // namespace robosim::test
