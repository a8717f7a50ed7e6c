// Tests the messages and saved files of failed tests. The tests that fail are in tests/system/failing.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <regex>
#include <sstream>

#include "sim/base/file.h"
#include "sim/testing/run_log.h"
#include "tests/support/temporary_folder.h"

namespace robosim::harness {
namespace failures_test {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

/// Replaces every number, and the spaces before it, with #.
std::string without_figures(const std::string& text) {
  return std::regex_replace(text, std::regex(" *[0-9]+([.][0-9]+)?"), "#");
}

class FailedTests : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new test::TemporaryFolder;
    run("GITHUB_ACTIONS=true GITHUB_STEP_SUMMARY=" + path("summary.md") + " ROBOSIM_ARTIFACTS=" +
            path("kept") + " " FAILING_TESTS " --gtest_color=no --gtest_output=xml:" + path("junit.xml"),
        "out.txt");
  }
  static void TearDownTestSuite() { delete folder_; }

  static std::string path(const std::string& name) { return (folder_->path() / name).string(); }
  static std::string text(const std::string& name) { return read_file(path(name)); }
  static void run(const std::string& command, const std::string& out) {
    const std::string line =
        "cd " FAILING_SKETCHES " && " + command + " > " + path(out) + " 2>&1 < /dev/null";
    ASSERT_NE(std::system(line.c_str()), -1);
  }

 private:
  static test::TemporaryFolder* folder_;
};

test::TemporaryFolder* FailedTests::folder_ = nullptr;

TEST_F(FailedTests, SayWhatHappenedWhenAndWhere) {
  EXPECT_THAT(
      text("out.txt"),
      AllOf(HasSubstr("Expected: follows the line within 15 mm"), HasSubstr("mm off the line, at column"),
            HasSubstr("it did not happen within 0.50 s that a motor is driven"),
            HasSubstr("the sketch says \"Ready: press start\\r\\n\""), HasSubstr("start pressed"),
            HasSubstr("the run ended at"), HasSubstr("Forgetful.ino:")));
}

/// Returns the part of Google Test's output `out` that belongs to a failed test.
std::string part_of(const std::string& test, const std::string& out) {
  const std::size_t begin = out.find("[ RUN      ] " + test + "\n");
  if (begin == std::string::npos) return "";
  return out.substr(begin, out.find("[  FAILED  ] " + test, begin) - begin);
}

TEST_F(FailedTests, TellOfTheRobotThoughTheExpectationKnowsNothingOfIt) {
  const std::string said = part_of("PassesBy.StopsAtAStation", text("out.txt"));
  const std::string told =
      "  TooFast on oval (uno5, target host, seed 3), 0.00 s to 1.00 s\n  before that:\n";
  const std::size_t at = said.find(told);
  ASSERT_NE(at, std::string::npos) << said;
  EXPECT_LT(said.find("robot.station()"), at);
  EXPECT_EQ(said.find(told, at + 1), std::string::npos) << "the second failure is at the same time";
  EXPECT_THAT(said.substr(at),
              AllOf(HasSubstr("the sketch says \"go\\r\\n\""), HasSubstr("\n  at 1.00 s it is at column "),
                    HasSubstr("\n  replay: " + text("kept/PassesBy.StopsAtAStation/command.txt")),
                    HasSubstr("\n  kept:   " + path("kept/PassesBy.StopsAtAStation") + "; open its run.html"),
                    HasSubstr("robot.verdict()")));
}

TEST_F(FailedTests, NameWhatIsKeptOfThemToMachinesToo) {
  const std::string junit = text("junit.xml");
  for (const char* test : {"TooFast.KeepsToTheLine", "PassesBy.StopsAtAStation", "InTheWay.NobodyIsTouched"})
    EXPECT_THAT(junit, HasSubstr("<property name=\"robosim_kept\" value=\"" + path("kept/") + test + "\"/>"));
}

TEST_F(FailedTests, OfPowerCutsTellOfTheRobotToo) {
  const std::string test = "Diary.StartsAfreshAtEveryPowerCut";
  EXPECT_THAT(part_of(test, text("out.txt")),
              AllOf(HasSubstr("in a run with a power cut during write 1"), HasSubstr("\n  Diary on oval"),
                    HasSubstr("power cut while byte 0 of the EEPROM was being written"),
                    HasSubstr("the sketch says \"was 0 255\\r\\n\"\n  at 0.10 s it is at column "),
                    HasSubstr("\n  replay: " + text("kept/" + test + "/command.txt"))));
  EXPECT_THAT(text("kept/" + test + "/script.txt"), HasSubstr("after eeprom 1 power off"));
}

// A run reports a script's step at the end of its tick. If the sketch responds within this tick, the run
// reports the response first. RunLog corrects this order.
TEST(RunLog, HasACauseBeforeItsEffect) {
  testing::RunLog log;
  log.add({1'000'400'000, "the sketch says \"refused\""});
  log.add({1'000'000'000, "\"3\" sent to the sketch"});
  log.add({1'000'000'000, "start pressed"});
  ASSERT_EQ(log.events.size(), 3u);
  EXPECT_EQ(log.events[0].text, "\"3\" sent to the sketch");
  EXPECT_EQ(log.events[1].text, "start pressed");
}

TEST_F(FailedTests, AreReplayedByTheCommandThatTheyTell) {
  const std::string command = text("kept/TooFast.KeepsToTheLine/command.txt");
  EXPECT_THAT(text("out.txt"), HasSubstr("replay: " + command));
  EXPECT_THAT(command,
              HasSubstr("robosim run ./TooFast --map oval --robot uno5 --target host --seed 3 --goal none "
                        "--script "));
  const std::string arguments =
      command.substr(std::string("robosim").size(), command.size() - std::string("robosim\n").size());
  run(ROBOSIM_COMMAND + arguments + " --json", "replay.json");
  const std::string junit = text("junit.xml");
  const std::string key = "robosim_trace_hash\" value=\"";
  const std::size_t at = junit.find(key);
  ASSERT_NE(at, std::string::npos) << junit;
  const std::string hash = junit.substr(at + key.size(), junit.find('"', at + key.size()) - at - key.size());
  EXPECT_THAT(text("replay.json"), HasSubstr(hash));
}

TEST_F(FailedTests, KeepWhatIsNeededToUnderstandThem) {
  const fs::path kept = path("kept/TooFast.KeepsToTheLine");
  for (const char* file : {"command.txt", "script.txt", "map.map", "robot.toml", "serial.txt", "events.txt",
                           "run.csv", "run.vcd", "run.html"})
    EXPECT_TRUE(fs::exists(kept / file)) << file;
  EXPECT_EQ(read_file(kept / "script.txt"), "at 1ms cover S3 50ms\n");
  EXPECT_EQ(read_file(kept / "serial.txt"), "go\r\n");
  EXPECT_THAT(read_file(kept / "run.csv"), HasSubstr("\n5000000,"));
  EXPECT_FALSE(fs::exists(path("kept/Forgetful.VisitsTheStations/script.txt")))
      << "the test does nothing to the robot";
  EXPECT_THAT(text("out.txt"), Not(HasSubstr("a fault of Robosim")));
}

TEST_F(FailedTests, InRandomWorldsAreReplayedInTheSmallestOne) {
  const std::string kept = path("kept/StopsAtTees.ToursEveryTree");
  EXPECT_FALSE(fs::exists(kept + "-2")) << "intermediate worlds are not saved";
  const std::string map = read_file(kept + "/map.map");
  EXPECT_EQ(std::count(map.begin(), map.end(), '.'), 6) << "a single bend is enough\n" << map;
  std::istringstream rows(map);
  for (std::string row; std::getline(rows, row);)
    EXPECT_THAT(text("out.txt"), HasSubstr("    " + row + "\n"));
  const std::string command = text("kept/StopsAtTees.ToursEveryTree/command.txt");
  run(ROBOSIM_COMMAND +
          command.substr(std::string("robosim").size(), command.size() - std::string("robosim\n").size()),
      "replay.txt");
  EXPECT_THAT(text("replay.txt"),
              HasSubstr("timeout: The 60.00 s of simulated time are up before the goal tour"));
}

TEST_F(FailedTests, OfSeveralRobotsKeepAFileOfThemThatRunsAgain) {
  const fs::path kept = path("kept/InTheWay.NobodyIsTouched");
  for (const char* file :
       {"robots.toml", "B.txt", "map.map", "A-serial.txt", "B-events.txt", "run.csv", "run.html"})
    EXPECT_TRUE(fs::exists(kept / file)) << file;
  EXPECT_EQ(read_file(kept / "B.txt"), "at 0ms power off 10000ms\n");
  EXPECT_THAT(text("out.txt"), HasSubstr("A: TooFast on oval (uno5, target host, seed 3)"));
  const std::string command = read_file(kept / "command.txt");
  EXPECT_THAT(text("out.txt"), HasSubstr("replay: " + command));
  run(ROBOSIM_COMMAND +
          command.substr(std::string("robosim").size(), command.size() - std::string("robosim\n").size()) +
          " --json",
      "fleet.json");
  EXPECT_THAT(text("fleet.json"), HasSubstr("\"collisions\": 1"));
}

TEST_F(FailedTests, AreAnnotationsAndATableOnGitHub) {
  EXPECT_THAT(text("out.txt"), HasSubstr("::error file="));
  EXPECT_THAT(text("out.txt"), HasSubstr("failing.cpp,line=12,title=TooFast.KeepsToTheLine::"));
  EXPECT_THAT(text("out.txt"), HasSubstr("%0A  at 1.00 s it is at column "))
      << "the message of robot.station()";
  EXPECT_THAT(
      text("summary.md"),
      AllOf(HasSubstr("### Robosim: 0 passed, 7 failed, 0 skipped"), HasSubstr("| `WrongButton."),
            HasSubstr("| `Forgetful.VisitsTheStations` | Forgetful on d (uno3, target host, seed 1), "),
            HasSubstr(": it did not come to 2 and 3 before "),
            HasSubstr(" s as crashed: The sketch crashed")));
}

TEST_F(FailedTests, AreOneTableThoughEachHasAProcess) {
  for (const char* one : {"TooFast.*", "Forgetful.*"})
    run("GITHUB_ACTIONS=true GITHUB_STEP_SUMMARY=" + path("ctest.md") +
            " ROBOSIM_ARTIFACTS=none " FAILING_TESTS " --gtest_filter=" + one,
        "one.txt");
  EXPECT_THAT(text("ctest.md"),
              ::testing::MatchesRegex(
                  "### Robosim: failed tests\n\n\\| test \\| what was found \\|\n\\|---\\|---\\|\n"
                  "\\| `TooFast[^\n]*\\|\n\\| `Forgetful[^\n]*\\|\n"));
}

TEST_F(FailedTests, CountTheLinesThatTheyHaveRunWhereCoverageIsAskedFor) {
  run("ROBOSIM_ARTIFACTS=none ROBOSIM_COVERAGE=" + path("coverage") +
          " " FAILING_TESTS " --gtest_filter=TooFast.*:Forgetful.*",
      "covered.txt");
  const std::string info = text("coverage/coverage.info");
  EXPECT_THAT(info, AllOf(HasSubstr("/TooFast.ino\n"), HasSubstr("/Forgetful.ino\n")));
  EXPECT_THAT(info, HasSubstr("DA:17,")) << "speedOn() of Forgetful";
  for (const auto& entry : fs::directory_iterator(path("coverage")))
    EXPECT_THAT(entry.path().filename().string(), Not(HasSubstr(".counters")))
        << "no file of counters is left";
}

TEST_F(FailedTests, AreTheExamplesOfTheGuide) {
  const std::string guide = read_file(TESTING_GUIDE);
  // Each line of an example must be a line of the output. Line numbers and measurements may differ, because
  // they depend on the compiler.
  const std::string out = without_figures(text("out.txt"));
  std::size_t begin = guide.find("```text\n");
  int lines = 0;
  ASSERT_NE(begin, std::string::npos);
  while (begin != std::string::npos) {
    const std::size_t end = guide.find("```\n", begin + 8);
    std::istringstream example(guide.substr(begin + 8, end - begin - 8));
    for (std::string line; std::getline(example, line); ++lines) {
      if (line.find("replay:") != std::string::npos || line.find("kept:") != std::string::npos ||
          line.find("failing.cpp") != std::string::npos)
        continue;
      EXPECT_THAT(out, HasSubstr(without_figures(line)));
    }
    begin = guide.find("```text\n", end);
  }
  EXPECT_GT(lines, 20);
}

}  // namespace failures_test
}  // namespace robosim::harness
