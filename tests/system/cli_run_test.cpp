// Tests `robosim run` from the command line to the verdict.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "tests/support/require_target.h"
#include "tests/system/json_of.h"

namespace robosim::test {
namespace cli_run_test {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

const std::vector<std::string> kShort{"run",  "PidFollower", "--map", "oval",  "--robot",
                                      "uno5", "--goal",      "none",  "--for", "2s"};

std::vector<std::string> with(std::vector<std::string> words, const std::vector<std::string>& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

std::string hash_of(const Ended& run) {
  const nlohmann::json result = json_of(run);
  return result.is_object() ? result["trace_hash"].get<std::string>() : "none: " + run.err;
}

TEST(CliRun, EqualInputsGiveEqualBytesAndAnotherSeedAnotherHash) {
  const Ended first = robosim_command(with(kShort, {"--json"}));
  EXPECT_EQ(first.status, 0) << first.err;
  EXPECT_THAT(first.out, StartsWith("{\n  \"schema\": \"robosim.run/1\",\n  \"verdict\": \"reached\","));
  EXPECT_EQ(robosim_command(with(kShort, {"--json"})).out, first.out);
  EXPECT_NE(hash_of(robosim_command(with(kShort, {"--json", "--seed", "2"}))), hash_of(first));
}

TEST(CliRun, TheScreenHasPictureVerdictAndFigures) {
  const Ended run = robosim_command(kShort);
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("reached: "));
  EXPECT_THAT(run.out, HasSubstr("cross-track"));
  EXPECT_THAT(run.out, HasSubstr("S"));
  EXPECT_THAT(run.out, Not(HasSubstr("\033"))) << "no colours in a file";
  EXPECT_THAT(run.err, IsEmpty()) << "no progress in a pipe";
}

TEST(CliRun, ARecordingHasARowEveryTenMillisecondsAndChangesNoResult) {
  const Folder folder;
  const Ended plain = robosim_command(with(kShort, {"--json"}));
  const Ended recorded =
      robosim_command(with(kShort, {"--json", "--record", "a.csv", "--record", "b.csv"}), folder.path());
  EXPECT_EQ(recorded.out, plain.out);
  const std::string csv = read_file(folder / "a.csv");
  EXPECT_THAT(csv, StartsWith("t_us,x_mm,y_mm,yaw_rad,speed_mm_s,cross_track_mm,left,right,S1,"));
  EXPECT_THAT(csv, HasSubstr("\n0,"));
  EXPECT_THAT(csv, HasSubstr("\n2000000,"));
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 201);
  EXPECT_EQ(read_file(folder / "b.csv"), csv);
}

TEST(CliRun, ASketchFolderBringsItsMapAndItsRobot) {
  const Folder folder;
  folder.write("Mine/Mine.ino",
               "void setup() { Serial.begin(9600); Serial.println(\"here\"); }\nvoid loop() { delay(1); }\n");
  folder.write("Mine/only.map", "_____\n_..._\n_____\n");
  folder.write("Mine/robot.toml", robosim_command({"robot", "show", "uno3"}).out);
  const Ended run = robosim_command({"run", "--goal", "none", "--for", "100ms", "--json"}, folder / "Mine");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("the map is only.map"));
  EXPECT_THAT(run.err, HasSubstr("the robot is robot.toml"));
  const nlohmann::json result = json_of(run);
  EXPECT_EQ(result["inputs"]["sketch"], ".");
  EXPECT_EQ(result["inputs"]["map"], "only.map");
  EXPECT_EQ(result["inputs"]["robot"], "robot.toml");
  EXPECT_EQ(result["serial"], "here\r\n");
  const Ended by_path = robosim_command(
      {"run", "./Mine/Mine.ino", "--goal", "none", "--for", "100ms", "--json"}, folder.path());
  EXPECT_EQ(hash_of(by_path), hash_of(run));
}

TEST(CliRun, SendReachesTheSketchAfterASecond) {
  const Folder folder;
  const auto sketch =
      folder.write("Echo/Echo.ino",
                   "void setup() { Serial.begin(9600); }\n"
                   "void loop() { while (Serial.available()) Serial.write(Serial.read() + 1); delay(1); }\n");
  const Ended run = robosim_command({"run", sketch.string(), "--map", "oval", "--robot", "uno3", "--goal",
                                     "none", "--for", "2s", "--send", "HAL", "--json"});
  EXPECT_EQ(json_of(run)["serial"], "IBM") << run.err;
}

struct Case {
  const char* name;
  std::vector<std::string> words;
  int status;
  const char* says;
};

class CliStatus : public ::testing::TestWithParam<Case> {};

TEST_P(CliStatus, IsAsDocumentedAndTheErrorIsOneSentence) {
  const Folder folder;
  folder.write("Bad/Bad.ino", "void setup() {}\nvoid loop() { nonsense }\n");
  folder.write("Still/Still.ino", "void setup() {}\nvoid loop() { delay(10); }\n");
  folder.write("bad.map", "0000\n0?00\n");
  folder.write("bad.toml", "base = \"uno5\"\nwheels = 7\n");
  folder.write("bad.txt", "at 1s pres start\n");
  const Ended run = robosim_command(GetParam().words, folder.path());
  EXPECT_EQ(run.status, GetParam().status) << run.out << run.err;
  EXPECT_THAT(run.out + run.err, HasSubstr(GetParam().says));
  if (GetParam().status == 2 || GetParam().status == 5) {
    EXPECT_THAT(run.out, IsEmpty());
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, CliStatus,
    ::testing::Values(
        Case{"Timeout",
             {"run", "./Still", "--map", "oval", "--robot", "uno3", "--goal", "tour", "--for", "1s"},
             4,
             "timeout:"},
        Case{"Syntax", {"run", "./Bad", "--map", "oval", "--robot", "uno3"}, 2, "Bad.ino:2:"},
        Case{"BadMap", {"run", "./Still", "--map", "bad.map", "--robot", "uno3"}, 2, "bad.map:2:2"},
        Case{"BadRobot", {"run", "./Still", "--map", "oval", "--robot", "bad.toml"}, 2, "bad.toml:2"},
        Case{"BadScript",
             {"run", "./Still", "--map", "oval", "--robot", "uno3", "--script", "bad.txt"},
             2,
             "bad.txt:1"},
        Case{"BadGoal",
             {"run", "./Still", "--map", "oval", "--robot", "uno3", "--goal", "laps:x"},
             2,
             "laps:x"},
        Case{
            "BadStart", {"run", "./Still", "--map", "oval", "--robot", "uno3", "--start", "0,0,E"}, 2, "0,0"},
        Case{"NoSketch", {"run"}, 2, "the current folder has no sketch"},
        Case{"NoSuchMap", {"run", "./Still", "--map", "ovla"}, 2, "did you mean oval?"},
        Case{"View", {"run", "./Still", "--view"}, 2, "--view requires a terminal"},
        Case{"BadRecord",
             {"run", "./Still", "--record", "x.gif"},
             2,
             "expected a name that ends in .csv, .vcd, .html"},
        Case{"Test", {"test"}, 2, "the current folder has no sketch"},
        Case{"CheckRobot", {"robot", "check", "bad.toml"}, 2, "bad.toml:2"},
        Case{"CheckMap", {"map", "check", "bad.map"}, 2, "bad.map:2:2"},
        Case{"Bare", {}, 0, "robosim run my/Sketch --map my.map"}),
    [](const auto& test) { return test.param.name; });

TEST(Cli, AStockRobotsOwnTextIsFine) {
  for (const char* name : {"uno2", "uno3", "uno5", "nano8rc"}) {
    const Folder folder;
    const Ended shown = robosim_command({"robot", "show", name});
    EXPECT_EQ(shown.status, 0) << shown.err;
    folder.write("robot.toml", shown.out);
    const Ended checked = robosim_command({"robot", "check", "robot.toml"}, folder.path());
    EXPECT_EQ(checked.status, 0) << checked.err;
    EXPECT_THAT(checked.out, HasSubstr("robot.toml is fine"));
    EXPECT_THAT(checked.out, HasSubstr(" (P")) << "each pin has the board's name and the chip's name";
  }
}

TEST(Cli, ARobotIsShownAsOneFileWithWhatItInherits) {
  const Folder folder;
  folder.write("my.toml", "base = \"uno5\"\n[chassis]\nwheel = \"42 mm\"\n");
  const Ended shown = robosim_command({"robot", "show", "./my.toml", "--full"}, folder.path());
  EXPECT_EQ(shown.status, 0) << shown.err;
  EXPECT_THAT(shown.out, AllOf(HasSubstr("\nwheel = \"42 mm\"\n"), HasSubstr("# uno5.toml:")));
  folder.write("one.toml", shown.out);
  EXPECT_EQ(robosim_command({"robot", "check", "one.toml"}, folder.path()).status, 0);
}

TEST(Cli, TheKitsOfTheDocsTakeTenLinesAndAreFine) {
  int kits = 0;
  for (const auto& kit : std::filesystem::directory_iterator(ROBOSIM_EXAMPLES "/kits")) {
    const Ended checked = robosim_command({"robot", "check", kit.path().string()});
    EXPECT_EQ(checked.status, 0) << checked.err;
    EXPECT_THAT(checked.out, AllOf(HasSubstr("left "), HasSubstr("right "), HasSubstr("line sensors")));
    std::ifstream file(kit.path());
    int lines = 0;
    for (std::string line; std::getline(file, line);) lines += line[0] == '#' ? 0 : 1;
    EXPECT_LE(lines, 10) << kit.path();
    ++kits;
  }
  EXPECT_EQ(kits, 5);
}

// The Zumo drives forward if DIR is low on both sides.
TEST(Cli, AKitDrivesAheadAsItsLibraryDrivesIt) {
  const Folder folder;
  folder.write(
      "Ahead/Ahead.ino",
      "void setup() { pinMode(7, OUTPUT); pinMode(8, OUTPUT); analogWrite(9, 120); analogWrite(10, 120); "
      "delay(700); analogWrite(9, 0); analogWrite(10, 0); }\nvoid loop() {}\n");
  const Ended ended =
      robosim_command({"run", "./Ahead", "--robot", ROBOSIM_EXAMPLES "/kits/zumo-leonardo.toml", "--goal",
                       "still", "--for", "3s", "--record", "run.csv"},
                      folder.path());
  EXPECT_EQ(ended.status, 0) << ended.out << ended.err;
  EXPECT_THAT(read_file(folder.path() / "run.csv"), HasSubstr(",0.47058823529411764,0.47058823529411764,"));
}

TEST(Cli, AFullDiskIsNoticed) {
  const Ended full = robosim_command({"robot", "show", "uno5"}, ".", "/dev/full");
  EXPECT_EQ(full.status, 2);
  EXPECT_THAT(full.err, HasSubstr("cannot write to standard output"));
}

TEST(CliRun, PutsABoardOfTheTargetOnARobotThatHasNone) {
  ROBOSIM_NEEDS_TARGET("stm32");
  const Ended ended = robosim_command(with(kShort, {"--target", "stm32", "--json"}));
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_THAT(ended.err,
              HasSubstr("for target stm32, the robot is uno5@bluepill: a bluepill replaces its uno on the "
                        "same pins\n"));
  EXPECT_EQ(json_of(ended)["inputs"]["robot"], "uno5@bluepill");
  std::vector<std::string> named = with(kShort, {"--target", "stm32", "--json"});
  named[5] = "uno5@bluepill";
  const Ended same = robosim_command(named);
  EXPECT_EQ(same.out, ended.out);
  EXPECT_THAT(same.err, Not(HasSubstr("replaces it")));
}

}  // namespace cli_run_test
}  // namespace robosim::test
