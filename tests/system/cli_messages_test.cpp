// Tests the messages for mistakes that are common in a newcomer's first hour.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/system/command.h"
#include "tests/system/system_test.h"

namespace robosim::test {
namespace cli_messages_test {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

constexpr const char* kMap = "111\n1_1\n111\n";

class Newcomers : public testing::Test {
 protected:
  /// Returns the text of a rejected command on standard error.
  std::string refusal(const std::vector<std::string>& words) const {
    const Ended ended = robosim_command(words, folder_.path());
    EXPECT_EQ(ended.status, 2) << ended.out;
    EXPECT_THAT(ended.out, IsEmpty());
    return ended.err;
  }

  const Folder folder_;
};

TEST_F(Newcomers, AreToldThatAFileIsOfAnotherKind) {
  folder_.write("some.map", kMap);
  folder_.write("robot.toml", "base = \"uno5\"\n");
  folder_.write("checks.toml", "[[check]]\nname = \"x\"\n");
  folder_.write("script.txt", "at 1s lift\n");
  folder_.write("log.csv", "# robosim calibration log 1\nt_us,S1\n" + std::string(300'000, '1'));
  EXPECT_THAT(refusal({"run", "PidFollower", "--robot", "some.map"}),
              HasSubstr("some.map: expected a robot file, got a map; give it with --map"));
  EXPECT_THAT(refusal({"run", "PidFollower", "--map", "./robot.toml"}),
              HasSubstr("robot.toml: expected a map, got a robot file; give it with --robot"));
  EXPECT_THAT(refusal({"map", "check", "script.txt"}), HasSubstr("expected a map, got a script"));
  EXPECT_THAT(refusal({"robot", "check", "./checks.toml"}),
              HasSubstr("expected a robot file, got a file of checks"));
  EXPECT_THAT(refusal({"run", "PidFollower", "--script", "some.map"}),
              HasSubstr("expected a script, got a map"));
  EXPECT_THAT(refusal({"replay", "some.map"}), HasSubstr("expected a recording, got a map"));
  EXPECT_THAT(refusal({"report", "robot.toml"}), HasSubstr("expected a table, got a robot file"));
  EXPECT_THAT(
      refusal({"calibrate", "./log.csv", "robot.toml"}),
      HasSubstr("log.csv: expected a robot file, got a calibration log; robosim calibrate ROBOT LOG"));
  EXPECT_THAT(refusal({"run", "./robot.toml"}), HasSubstr("expected a fleet's file, got a robot file"));
}

TEST_F(Newcomers, AreAskedForMissingQuotes) {
  folder_.write("robot.toml", "base = uno5\n");
  EXPECT_THAT(refusal({"robot", "check", "./robot.toml"}),
              HasSubstr("robot.toml:1:8: text requires quotes: expected \"uno5\", got uno5"));
}

TEST_F(Newcomers, MaySaveAScriptWithAByteOrderMark) {
  folder_.write("script.txt",
                "\xEF\xBB\xBF"
                "at 1s prses start\n");
  EXPECT_THAT(
      refusal({"run", "PidFollower", "--script", "script.txt"}),
      AllOf(HasSubstr("script.txt:1:7: unknown verb"), HasSubstr("got “prses”; did you mean press?")));
}

TEST_F(Newcomers, AreOfferedTheWordThatTheyMeant) {
  folder_.write("robot.toml", "base = \"uno5\"\n[driver]\nchip = \"l298\"\n");
  folder_.write("script.txt", "at 1s press strat\n");
  EXPECT_THAT(refusal({"run", "PidFollower", "--goal", "lap:3"}),
              HasSubstr("got “lap:3”; did you mean laps:3?"));
  EXPECT_THAT(refusal({"run", "PidFollower", "--profile", "typcal"}), HasSubstr("did you mean typical?"));
  EXPECT_THAT(refusal({"run", "PidFollower", "--map", "ovla"}), HasSubstr("did you mean oval?"));
  EXPECT_THAT(refusal({"map", "show", "ovla"}), HasSubstr("did you mean oval?"));
  EXPECT_THAT(refusal({"run", "PidFollower", "--robot", "unno5"}), HasSubstr("did you mean uno5?"));
  EXPECT_THAT(refusal({"robot", "show", "unno5"}), HasSubstr("did you mean uno5?"));
  EXPECT_THAT(refusal({"run", "PidFollower", "--robot", "uno5@nanno"}), HasSubstr("did you mean nano?"));
  EXPECT_THAT(refusal({"robot", "check", "./robot.toml"}), HasSubstr("did you mean l298n?"));
  EXPECT_THAT(
      refusal({"run", "PidFollower", "--script", "script.txt"}),
      HasSubstr(
          "unknown button of robot “uno5”: expected start or bumper, got “strat”; did you mean start?"));
}

TEST_F(Newcomers, LearnOfAMissingFolderBeforeTheRun) {
  EXPECT_THAT(refusal({"run", "PidFollower", "--record", "runs/1.html"}),
              HasSubstr("runs/1.html: cannot be written: the folder runs does not exist; create it first"));
  EXPECT_THAT(refusal({"run", "PidFollower", "--plot", "runs/1.svg"}),
              HasSubstr("the folder runs does not exist"));
  EXPECT_THAT(refusal({"sweep", "PidFollower", "--csv", "runs/1.csv"}),
              HasSubstr("the folder runs does not exist"));
  EXPECT_THAT(refusal({"wire", "PidFollower", "--out", "runs/robot.toml"}),
              HasSubstr("the folder runs does not exist"));
}

TEST_F(Newcomers, AreToldWhatWasWrittenAndHowToLookAtIt) {
  const Ended ended = robosim_command({"run", "PidFollower", "--for", "1s", "--record", "run.html",
                                       "--record", "run.csv", "--plot", "run.svg"},
                                      folder_.path());
  EXPECT_THAT(ended.out,
              HasSubstr("\nrun.html is written; open it in a browser\nrun.csv is written\nrun.svg is "
                        "written\n"));
}

TEST_F(Newcomers, SeeTheSketchOfTheCurrentFolderByItsName) {
  const auto sketch = folder_ / "Mine";
  folder_.write("Mine/Mine.ino", "void setup() {}\nvoid loop() {}\n");
  const Ended swept = robosim_command({"sweep", "--seeds", "1", "--for", "1s", "--csv", "runs.csv"}, sketch);
  EXPECT_THAT(swept.out,
              AllOf(HasSubstr("Mine "), HasSubstr("Mine on oval with uno5"), Not(HasSubstr(". on oval"))));
  ASSERT_EQ(robosim_command({"report", "runs.csv", "--runs", "0"}, sketch).status, 0);
  EXPECT_THAT(read_file(sketch / "report.html"),
              AllOf(HasSubstr("<td class=\"left\">Mine</td>"), Not(HasSubstr("<td class=\"left\">.</td>"))));
}

TEST_F(Newcomers, LearnWhichOfSeveralInoFilesIsTheMainOne) {
  folder_.write("Line/a.ino", "void setup() {}\n");
  folder_.write("Line/b.ino", "void loop() {}\n");
  EXPECT_THAT(
      refusal({"run", "./Line"}),
      HasSubstr("expected Line.ino, named like its folder, among the 2 .ino files, got a.ino and b.ino; "
                "rename the main file to Line.ino, or name one of the files, as in ./Line/a.ino"));
}

}  // namespace cli_messages_test
}  // namespace robosim::test
