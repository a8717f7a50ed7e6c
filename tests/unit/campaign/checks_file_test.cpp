#include "sim/campaign/check/checks_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/base/file.h"
#include "sim/campaign/check/check_result.h"
#include "tests/support/readable.h"
#include "tests/support/temporary_folder.h"

namespace robosim::campaign {
namespace checks_file_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class ChecksFile : public ::testing::Test {
 protected:
  std::vector<Check> read(const std::string& text) {
    write_file(folder_.path() / "checks.toml", text);
    return read_checks(folder_.path() / "checks.toml");
  }
  std::string in_folder(const std::string& file) const { return (folder_.path() / file).string(); }

  test::TemporaryFolder folder_;
};

TEST_F(ChecksFile, KeysAreTheFlagsOfSweep) {
  const Check check = read(R"([[check]]
name = "all of them"
map = ["oval", "own.map"]
robot = "robot.toml"
target = ["host", "avr"]
start = "2,2,E"
goal = "laps:2"
for = "60s"
clock = "1h"
seeds = "3..60"
profile = "ideal"
script = "script.txt"
send = ["a\n", 'say "b"']
libraries = "libs"
sanitize = true
min-rate = 0.9
sure = true
stop-early = true
)")[0];
  EXPECT_EQ(check.name, "all of them");
  EXPECT_EQ(check.place.line, 1);
  const SweepOptions& sweep = check.sweep;
  EXPECT_THAT(sweep.maps, ElementsAre("oval", in_folder("own.map"))) << "paths are relative to the file";
  EXPECT_THAT(sweep.robots, ElementsAre(in_folder("robot.toml")));
  EXPECT_THAT(sweep.targets, ElementsAre("host", "avr"));
  EXPECT_EQ(sweep.each.request.start, "2,2,E");
  EXPECT_EQ(sweep.each.request.goal, "laps:2");
  EXPECT_EQ(sweep.each.request.for_ns, 60'000'000'000);
  EXPECT_EQ(sweep.each.request.clock_ns, 3'600'000'000'000);
  EXPECT_EQ(sweep.first_seed, 3u);
  EXPECT_EQ(sweep.last_seed, 60u);
  EXPECT_FALSE(check.detect) << "--sanitize changes the timing";
  EXPECT_EQ(sweep.each.request.profile, "ideal");
  EXPECT_EQ(sweep.each.script, in_folder("script.txt"));
  EXPECT_THAT(sweep.each.send, ElementsAre("a\\n", "say \\\"b\\\"")) << "the texts are escaped as in scripts";
  EXPECT_THAT(sweep.each.libraries, ElementsAre(in_folder("libs")));
  EXPECT_TRUE(sweep.each.sanitize);
  EXPECT_EQ(sweep.min_rate, 0.9);
  EXPECT_TRUE(sweep.sure);
  EXPECT_TRUE(sweep.stop_early);
}

TEST_F(ChecksFile, WithoutKeysItIsOneRunThatMustReachItsGoal) {
  const Check check = read("[[check]]\nname = 'x'\n")[0];
  EXPECT_EQ(check.sweep.first_seed, 1u);
  EXPECT_EQ(check.sweep.last_seed, 1u);
  EXPECT_EQ(check.sweep.each.request.for_ns, launch::RunSettings().request.for_ns);
  EXPECT_THAT(check.expect, ElementsAre("reached"));
  EXPECT_THAT(check.limits, IsEmpty());
  EXPECT_FALSE(check.sweep.min_rate);
}

TEST_F(ChecksFile, DetectorsAreAskedUnlessItSaysOtherwise) {
  EXPECT_TRUE(read("[[check]]\nname = \"a\"\n")[0].detect);
  EXPECT_FALSE(read("[[check]]\nname = \"a\"\ndetect = false\n")[0].detect);
}

TEST_F(ChecksFile, LimitsAreNamedAsTheFiguresOfRun) {
  const Check check = read(R"([[check]]
name = 'x'
target = 'avr'
collisions = { max = 0 }
laps_s = { min = 1.5, max = 9 }
loop_us_max = { max = 2000 }
serial = ["a", "b"]
stations = "dock"
expect = ["stuck", "lost"]
)")[0];
  ASSERT_EQ(check.limits.size(), 3u);
  EXPECT_STREQ(check.limits[0].figure->name, "laps_s");
  EXPECT_EQ(check.limits[0].min, 1.5);
  EXPECT_EQ(check.limits[0].max, 9.0);
  EXPECT_STREQ(check.limits[1].figure->name, "collisions");
  EXPECT_FALSE(check.limits[1].min);
  EXPECT_EQ(check.limits[1].max, 0.0);
  EXPECT_STREQ(check.limits[2].figure->name, "loop_us_max");
  EXPECT_THAT(check.serial, ElementsAre("a", "b"));
  EXPECT_THAT(check.stations, ElementsAre("dock"));
  EXPECT_THAT(check.expect, ElementsAre("stuck", "lost"));
}

struct RefusedChecks {
  const char* text;
  const char* says;
};

class RefusedChecksFile : public ChecksFile, public ::testing::WithParamInterface<RefusedChecks> {};

TEST_P(RefusedChecksFile, IsToldWithLineAndColumn) {
  try {
    read(GetParam().text);
    FAIL() << "not refused";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr(std::string("checks.toml:") + GetParam().says));
  }
}

INSTANTIATE_TEST_SUITE_P(
    Each, RefusedChecksFile,
    ::testing::Values(
        RefusedChecks{"", " expected at least one [[check]]"},
        RefusedChecks{"check = 3", " expected at least one [[check]]"},
        RefusedChecks{"[[checks]]\nname = 'x'\n", "1:1: unknown key checks"},
        RefusedChecks{"[[check]]\nmap = 'oval'\n", "1:1: [[check]] lacks the key name"},
        RefusedChecks{"[[check]]\nname = ''\n",
                      "1:1: name: expected a description of the check, got an empty string"},
        RefusedChecks{"[[check]]\nname = 'x'\n[[check]]\nname = 'x'\n", "3:1: duplicate check name “x”"},
        RefusedChecks{"[[check]]\nname = 'x'\nmpa = 'oval'\n",
                      "3:7: unknown key mpa in [[check]]: expected name, map, robot"},
        RefusedChecks{"[[check]]\nname = 'x'\nfor = 60\n", "3:7: for: expected a time above 0"},
        RefusedChecks{"[[check]]\nname = 'x'\nmap = ''\n", "3:7: map: expected a word, got an empty string"},
        RefusedChecks{"[[check]]\nname = 'x'\nsanitize = true\ndetect = true\n",
                      "4:10: detect and sanitize exclude each other"},
        RefusedChecks{"[[check]]\nname = 'x'\nsanitize = 1\n",
                      "3:12: sanitize: expected true or false, got 1"},
        RefusedChecks{"[[check]]\nname = 'x'\nseed = -1\n", "3:8: seed: expected a whole number"},
        RefusedChecks{"[[check]]\nname = 'x'\nseed = 1\nseeds = '1..2'\n",
                      "3:8: seed and seeds exclude each other"},
        RefusedChecks{"[[check]]\nname = 'x'\nmin-rate = 2\n", "3:12: min-rate: expected a share"},
        RefusedChecks{"[[check]]\nname = 'x'\nmap = ['a', 'a']\n", "3:7: map a is given twice"},
        RefusedChecks{"[[check]]\nname = 'x'\nsure = true\n", "3:8: sure requires min-rate"},
        RefusedChecks{"[[check]]\nname = 'x'\nexpect = 'lsot'\n", "3:10: expect: expected reached"},
        RefusedChecks{"[[check]]\nname = 'x'\ncollisions = 0\n", "3:14: collisions: expected "},
        RefusedChecks{"[[check]]\nname = 'x'\ncollisions = {}\n",
                      "3:14: collisions requires min, max or both"},
        RefusedChecks{"[[check]]\nname = 'x'\ncollisions = { most = 0 }\n",
                      "3:23: unknown key most in collisions"},
        RefusedChecks{"[[check]]\nname = 'x'\ncollisions = { max = '0' }\n",
                      "3:22: max of collisions: expected a number"},
        RefusedChecks{"[[check]]\nname = 'x'\ncpu_load = { max = 1 }\n",
                      "3:12: cpu_load requires a chip target"}),
    test::numbered(&RefusedChecks::says));

TEST_F(ChecksFile, SaysOfAllRunsWhatMustNeverAndAlwaysBe) {
  const auto checks = parse_checks(
      "never = [\"serial: ERROR\", \"shows: E\"]\nalways = \"serial: ready\"\n[[check]]\nname = \"a\"\n",
      "checks.toml");
  ASSERT_EQ(checks.at(0).assertions.size(), 3u);
  result::RunResult result;
  result.verdict = "reached";
  result.serial = "ready\n";
  EXPECT_EQ(why_failed(checks[0], result), std::nullopt);
  result.shown = "lcd: E 5";
  EXPECT_EQ(why_failed(checks[0], result), "the sketch showed “E”, which it must never do");
  result.shown = result.serial = "";
  EXPECT_EQ(why_failed(checks[0], result), "the sketch has not sent “ready”, which it must always do");
  EXPECT_THAT([] { parse_checks("never = \"ERROR\"\n[[check]]\nname = \"a\"\n", "checks.toml"); },
              Throws<InputError>(Property(&InputError::message, HasSubstr("never: expected "))));
}

}  // namespace checks_file_test
}  // namespace robosim::campaign
