// Tests `robosim build`, as a user runs it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/support/require_target.h"
#include "tests/system/command.h"

namespace robosim::test {
namespace cli_build_test {

using ::testing::AllOf;
using ::testing::AnyOf;
using ::testing::HasSubstr;
using ::testing::MatchesRegex;
using ::testing::StartsWith;

const std::string kBudget = "base = \"uno5\"\n[budget]\nflash = 1500\n";

TEST(CliBuild, SaysWhatASketchTakesOfTheChipAndPutsTheFilesWhereTheyAreWanted) {
  ROBOSIM_NEEDS_TARGET("avr");
  const Folder folder;
  const Ended ended =
      robosim_command({"build", "PidFollower", "--target", "avr", "--out", "made"}, folder.path());
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_THAT(ended.out,
              AllOf(HasSubstr("%) of program storage space. Maximum is 32256 bytes.\n"),
                    HasSubstr("image: made/PidFollower.elf\n"), HasSubstr("hex: made/PidFollower.hex\n")));
  EXPECT_THAT(read_file(folder / "made/PidFollower.hex"), StartsWith(":10"));
  EXPECT_THAT(read_file(folder / "made/PidFollower.elf"), StartsWith("\177ELF"));
}

TEST(CliBuild, FailsWithASentenceWhereTheRobotsBudgetIsExceeded) {
  ROBOSIM_NEEDS_TARGET("avr");
  const Folder folder;
  folder.write("My/My.ino",
               "void setup() { Serial.begin(9600); }\nvoid loop() { Serial.println(millis()); }\n");
  folder.write("My/robot.toml", kBudget);
  const Ended ended = robosim_command({"build", "My/", "--target", "avr"}, folder.path());
  EXPECT_EQ(ended.status, 1);
  EXPECT_THAT(ended.out, HasSubstr("Sketch uses "));
  EXPECT_THAT(ended.err,
              MatchesRegex("robosim: My is over the budget: it uses [0-9]+ bytes of flash, and the "
                           "robot robot allows 1500\n"));
  EXPECT_EQ(robosim_command({"build", "My/"}, folder.path()).status, 0) << "the host has no budget";
}

TEST(CliBuild, ACompileErrorForTheChipNamesFileAndLine) {
  ROBOSIM_NEEDS_TARGET("avr");
  const Folder folder;
  folder.write("My/My.ino", "void setup() {}\nvoid loop() { halt(); }\n");
  const Ended ended = robosim_command({"build", "My/", "--target", "avr"}, folder.path());
  EXPECT_EQ(ended.status, 2);
  // avr-gcc 5.4 reports the column of the call's end; avr-gcc 14 reports the column of the function's name.
  EXPECT_THAT(ended.err, AnyOf(StartsWith("My.ino:2:20: error: 'halt' was not declared"),
                               StartsWith("My.ino:2:15: error: 'halt' was not declared")));
}

TEST(CliBuild, AMissingLibraryIsNamedWithTheFlagThatAddsFoldersOfThem) {
  const Folder folder;
  folder.write("My/My.ino", "#include <NoSuchSensor.h>\nvoid setup() {}\nvoid loop() {}\n");
  for (const char* command : {"build", "run"}) {
    const Ended ended = robosim_command({command, "My/"}, folder.path());
    EXPECT_EQ(ended.status, 2);
    EXPECT_THAT(ended.err, AllOf(HasSubstr("no such header NoSuchSensor.h"), HasSubstr("--libraries DIR")));
  }
}

TEST(CliBuild, AMissingCrossCompilerIsStatus5AndItsPackageIsNamed) {
  const Folder folder;
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", folder.path().c_str(), 1);
  const Ended ended = robosim_command({"build", "PidFollower", "--target", "avr"});
  ::setenv("PATH", path.c_str(), 1);
  EXPECT_EQ(ended.status, 5);
  EXPECT_EQ(ended.err, "robosim: avr-g++ is missing: sudo apt install gcc-avr\n");
}

// Beginners' mistakes that the compiler reports only with extra flags.
TEST(CliBuild, AnAssignmentForAComparisonAndAnEmptyIfAreWarnedOf) {
  const Folder folder;
  folder.write(
      "Slip/Slip.ino",
      "int x;\nvoid setup() { pinMode(13, OUTPUT); }\n"
      "void loop() {\n  if (x = 1) digitalWrite(13, HIGH);\n  if (x);\n    digitalWrite(13, LOW);\n}\n");
  const Ended built = robosim_command({"build", "./Slip"}, folder.path());
  EXPECT_EQ(built.status, 0);
  EXPECT_THAT(built.err, AllOf(HasSubstr("Slip.ino:4:9: warning: '=' assigns a value in this condition"),
                               HasSubstr("Slip.ino:5:9: warning: suggest braces around empty body")));
}

}  // namespace cli_build_test
}  // namespace robosim::test
