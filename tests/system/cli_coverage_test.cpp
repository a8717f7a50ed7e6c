// Tests `robosim run --coverage`, as a user runs it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "tests/support/require_target.h"
#include "tests/system/command.h"

namespace robosim::test {
namespace cli_coverage_test {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

const std::string kCovered =
    "#include \"limits.h\"\n"                       // 1
    "int runs;\n"                                   // 2
    "void remember(int what) {\n"                   // 3
    "  if (what > kMost) {\n"                       // 4
    "    Serial.println(\"too much\");\n"           // 5
    "    runs = 0;\n"                               // 6
    "  }\n"                                         // 7
    "  runs += doubled(what);\n"                    // 8
    "}\n"                                           // 9
    "void setup() {\n"                              // 10
    "  Serial.begin(9600);\n"                       // 11
    "  for (int i = 0; i < 3; i++) remember(i);\n"  // 12
    "}\n"                                           // 13
    "void loop() {\n"                               // 14
    "  while (Serial.available()) {\n"              // 15
    "    const int got = Serial.read();\n"          // 16
    "    if (got == 'm') remember(99);\n"           // 17
    "    if (got == 'x') abort();\n"                // 18
    "    if (got == 'h') for (;;) runs++;\n"        // 19
    "  }\n"                                         // 20
    "  delay(1);\n"                                 // 21
    "}\n";                                          // 22

class CliCoverage : public ::testing::Test {
 protected:
  CliCoverage() {
    folder_.write("My Sketches/Mine/Mine.ino", kCovered);
    folder_.write("My Sketches/Mine/limits.h", "constexpr int kMost = 9;\nint doubled(int n);\n");
    folder_.write("My Sketches/Mine/src/double.cpp",
                  "int doubled(int n) {\n  if (n < 0)\n    return 0;\n  return 2 * n;\n}\n");
  }

  Ended run(std::vector<std::string> more) {
    std::vector<std::string> words = {
        "run", "My Sketches/Mine/Mine.ino", "--goal", "none", "--for", "2s", "--coverage", "out"};
    words.insert(words.end(), more.begin(), more.end());
    return robosim_command(words, folder_.path());
  }
  std::string info() const { return read_file(folder_ / "out/coverage.info"); }

  Folder folder_;
};

TEST_F(CliCoverage, SaysWhichLinesNeverRanAndWritesATracefile) {
  const Ended ended = run({});
  EXPECT_EQ(ended.status, 0) << ended.out << ended.err;
  EXPECT_THAT(ended.out, AllOf(HasSubstr("coverage: 12 of 18 lines of Mine.ino ran; never ran: 5-6, 16-19\n"),
                               HasSubstr("3 of 4 lines of double.cpp ran; never ran: 3\n")));
  const std::string sketch = (folder_ / "My Sketches/Mine/Mine.ino").string();
  EXPECT_THAT(info(), AllOf(HasSubstr("SF:" + std::filesystem::canonical(sketch).string() + "\n"),
                            HasSubstr("FNDA:3,remember(int)\n"), HasSubstr("\nDA:4,3\nDA:5,0\nDA:6,0\n"),
                            Not(HasSubstr("Arduino.h"))));
}

TEST_F(CliCoverage, RunsAddUpAndTheSameRunCountsOnce) {
  run({});
  const std::string once = info();
  run({});
  EXPECT_EQ(info(), once);
  EXPECT_THAT(run({"--send", "m"}).out, HasSubstr("coverage: 18 of 18 lines of Mine.ino ran\n"));
  EXPECT_THAT(info(), AllOf(HasSubstr("FNDA:7,remember(int)\n"), HasSubstr("\nDA:4,7\nDA:5,1\nDA:6,1\n")));
}

TEST_F(CliCoverage, CountsUpToACrashAHangAndAPowerCut) {
  const Ended crashed = run({"--send", "x"});
  EXPECT_EQ(crashed.status, 1);
  EXPECT_THAT(crashed.out, HasSubstr("of Mine.ino ran; never ran: 5-6, 19\n"));
  folder_.write("cut.txt", "at 1s send \"h\"\nat 1500ms power off 100ms\n");
  run({"--script", "cut.txt"});
  EXPECT_THAT(info(), HasSubstr("FNDA:3,setup\n")) << "once in the first run, twice in the second";
  EXPECT_THAT(info(), Not(HasSubstr("\nDA:19,0\n")));
}

TEST_F(CliCoverage, RunsSideBySideLoseNothing) {
  std::vector<std::thread> all;
  for (int seed = 1; seed <= 4; ++seed)
    all.emplace_back([&, seed] { run({"--seed", std::to_string(seed)}); });
  for (std::thread& one : all) one.join();
  EXPECT_THAT(info(), HasSubstr("FNDA:12,remember(int)\n"));
}

TEST_F(CliCoverage, IsTakenFromTheEnvironmentForWholeTestSuites) {
  ::setenv("ROBOSIM_COVERAGE", (folder_ / "out").c_str(), 1);
  const Ended ended =
      robosim_command({"run", "My Sketches/Mine/", "--goal", "none", "--for", "1s"}, folder_.path());
  ::unsetenv("ROBOSIM_COVERAGE");
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_THAT(ended.out, Not(HasSubstr("coverage")));
  EXPECT_THAT(info(), HasSubstr("FNDA:3,remember(int)\n"));
}

TEST_F(CliCoverage, GoesTogetherWithChecks) {
  const Ended ended = run({"--sanitize"});
  EXPECT_EQ(ended.status, 0) << ended.out << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("coverage: 12 of 18 lines of Mine.ino ran"));
}

// On a chip, only lines that remain after optimisation are counted.
TEST_F(CliCoverage, IsCountedOnAChipByTheEmulatorAndChangesNothing) {
  for (const auto& [target, robot] :
       {std::pair{"avr", "uno5"}, std::pair{"avr", "mega5"}, std::pair{"avr", "leonardo5"},
        std::pair{"avr", "uno5@nano168"}, std::pair{"stm32", "bluepill5"}}) {
    std::filesystem::remove_all(folder_ / "out");
    const std::vector<std::string> chip = {"--target", target, "--robot", robot, "--json"};
    const Ended counted = run(chip);
    ASSERT_EQ(counted.status, 0) << robot << counted.err;
    EXPECT_THAT(counted.err, HasSubstr("of Mine.ino ran; never ran: 5")) << robot;
    EXPECT_THAT(counted.err, HasSubstr(", 16-19\n")) << robot;
    EXPECT_THAT(info(),
                AllOf(HasSubstr("\nDA:11,1\n"), HasSubstr("\nDA:17,0\n"), Not(HasSubstr("Arduino.h"))))
        << robot;
    std::vector<std::string> words = {"run", "My Sketches/Mine/Mine.ino", "--goal", "none", "--for", "2s"};
    words.insert(words.end(), chip.begin(), chip.end());
    EXPECT_EQ(robosim_command(words, folder_.path()).out, counted.out) << robot << ": the same run";
    std::vector<std::string> sends = chip;
    sends.insert(sends.end(), {"--send", "m"});
    run(sends);
    EXPECT_THAT(info(), AllOf(HasSubstr("\nDA:5,1\n"), HasSubstr("\nDA:11,2\n"), HasSubstr("\nDA:17,1\n")))
        << robot;
  }
}

TEST_F(CliCoverage, OnAChipEachPowerCycleAndWhatWasLeftOutWhileItWaitedCount) {
  folder_.write("cut.txt", "at 1s power off 100ms\n");
  folder_.write("Waits/Waits.ino",
                "void setup() {\n"
                "  pinMode(13, OUTPUT);\n"
                "}\n"
                "void loop() {\n"
                "  if (PIND & 16)\n"
                "    PORTB = 32;\n"
                "}\n");
  const Ended ended =
      robosim_command({"run", "./Waits", "--target", "avr", "--robot", "uno5", "--goal", "none", "--for",
                       "2s", "--script", "cut.txt", "--coverage", "out", "--json"},
                      folder_.path());
  ASSERT_EQ(ended.status, 0) << ended.err;
  EXPECT_THAT(info(), HasSubstr("\nDA:2,2\n"));
  const auto rounds = nlohmann::json::parse(ended.out)["resources"]["loops"].get<std::uint64_t>();
  std::uint64_t looked = 0;
  const std::string text = info();
  std::istringstream(text.substr(text.find("\nDA:5,") + 6)) >> looked;
  EXPECT_GT(looked, 10'000u);
  EXPECT_GE(looked, rounds) << "`rounds` counts only since the power returned";
}

TEST_F(CliCoverage, IsRefusedForAFolderThatCannotBe) {
  folder_.write("file", "");
  const Ended bad = robosim_command({"run", "PidFollower", "--coverage", "file"}, folder_.path());
  EXPECT_EQ(bad.status, 2);
  EXPECT_THAT(bad.err, HasSubstr("file: --coverage: files cannot be written into this folder"));
}

TEST_F(CliCoverage, MakesAPageWhereGenhtmlIsThere) {
  if (std::system("command -v genhtml >/dev/null 2>&1") != 0) {
    ASSERT_FALSE(is_required("lcov")) << "genhtml is missing: apt install lcov";
    GTEST_SKIP() << "genhtml is missing: apt install lcov";
  }
  EXPECT_THAT(run({}).out, HasSubstr("html/index.html\n"));
  EXPECT_THAT(read_file(folder_ / "out/html/index.html"), HasSubstr("coverage.info"));
}

}  // namespace cli_coverage_test
}  // namespace robosim::test
