#include "sim/launch/fleet.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "sim/base/file.h"
#include "tests/support/readable.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_folder.h"

namespace robosim::launch::fleet_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

TEST(FleetFile, SaysOfEachRobotWhatTheCommandLineSaysOfOne) {
  const test::TemporaryFolder folder;
  write_file(folder.path() / "b.txt", "at 1s lift\n");
  const Fleet fleet = parse_fleet(R"(map = "own.map"

[[agent]]
name = "A"
sketch = "PidFollower"

[[agent]]
name = "b-2"
sketch = "./Mine"
robot = "robot.toml"
target = "avr"
start = "2,2,E"
goal = "laps:2"
script = "b.txt"
clock = "1h"
libraries = ["libs"]
sanitize = true
)",
                                  folder.path() / "robots.toml");
  const auto in_folder = [&](const char* file) { return (folder.path() / file).string(); };
  EXPECT_EQ(fleet.map, in_folder("own.map"));
  ASSERT_EQ(fleet.members.size(), 2u);
  EXPECT_EQ(fleet.members[0].name, "A");
  EXPECT_EQ(fleet.members[0].launch.sketch, "PidFollower");
  EXPECT_EQ(fleet.members[0].place.line, 3);
  const Member& b = fleet.members[1];
  EXPECT_EQ(b.launch.sketch, in_folder("Mine")) << "paths are relative to the file's folder";
  EXPECT_EQ(b.launch.robot, in_folder("robot.toml"));
  EXPECT_EQ(b.launch.target, "avr");
  EXPECT_EQ(b.launch.request.start, "2,2,E");
  EXPECT_EQ(b.launch.request.goal, "laps:2");
  EXPECT_EQ(b.launch.request.clock_ns, 3'600'000'000'000);
  EXPECT_EQ(b.launch.request.script, "at 1s lift\n");
  EXPECT_EQ(b.launch.request.script_file, in_folder("b.txt"));
  EXPECT_THAT(b.launch.libraries, ElementsAre(in_folder("libs")));
  EXPECT_TRUE(b.launch.sanitize);
}

TEST(FleetFile, PathsStayPathsInTheCurrentFolder) {
  const std::string text = "map = \"./floor\"\n[[agent]]\nname = \"A\"\nsketch = \"./Mine\"\n";
  for (const char* file : {"robots.toml", "./robots.toml", "there/../robots.toml"}) {
    const Fleet fleet = parse_fleet(text, file);
    EXPECT_EQ(fleet.members[0].launch.sketch, "./Mine") << file;
    EXPECT_EQ(fleet.map, "./floor") << file;
  }
}

TEST(FleetFile, ABareSketchIsTheFolderBesideTheFile) {
  const test::TemporaryFolder folder;
  std::filesystem::create_directories(folder.path() / "Mine");
  const Fleet fleet = parse_fleet(
      "[[agent]]\nname = \"A\"\nsketch = \"Mine\"\n[[agent]]\nname = \"B\"\nsketch = \"PidFollower\"\n",
      folder.path() / "fleet.toml");
  EXPECT_EQ(fleet.members[0].launch.sketch, folder.path() / "Mine");
  EXPECT_EQ(fleet.members[1].launch.sketch, "PidFollower");
}

TEST(FleetFile, NeedsTheRunnerThatHasAllOfItsTargets) {
  EXPECT_EQ(runner_of({"host", "host"}), "host");
  EXPECT_EQ(runner_of({"host", "avr"}), "avr");
  EXPECT_EQ(runner_of({"avr", "stm32", "avr"}), "stm32");
  EXPECT_EQ(runner_of({"host", "avr", "stm32"}), "stm32");
}

TEST(Fleet, IsOneResultThatNamesTheFirstRobotThatFailed) {
  wire::RunRequest request;
  request.name = "A";
  request.agents.resize(2);
  request.agents[0].name = "B";
  request.agents[1].name = "C";
  result::RunResult result;
  result.verdict = "reached";
  result.time_s = 3.0;
  result.serial = "a";
  result.metrics.collisions = 1;
  EXPECT_EQ(whole_of(result, request).time_s, 3.0) << "a single robot's result is unchanged";
  result.others.assign(2, result);
  result.others[0].time_s = 5.0;
  result.others[0].serial = "b";
  result::RunResult whole = whole_of(result, request);
  EXPECT_EQ(whole.verdict, "reached");
  EXPECT_EQ(whole.why, "All 3 robots reached their goals.");
  EXPECT_EQ(whole.time_s, 5.0);
  EXPECT_EQ(whole.metrics.collisions, 3);
  EXPECT_EQ(whole.serial, "aba");
  EXPECT_TRUE(whole.others.empty());
  result.others[1].verdict = "lost";
  result.others[1].status = 1;
  result.others[1].why = "The robot lost the line.";
  whole = whole_of(result, request);
  EXPECT_EQ(whole.verdict, "lost");
  EXPECT_EQ(whole.status, 1);
  EXPECT_EQ(whole.why, "robot C: The robot lost the line.");
}

struct Bad {
  const char* name;
  const char* text;
  const char* sentence;  ///< beginning of the error message after the file's name
};

void PrintTo(const Bad& bad, std::ostream* out) { *out << bad.name; }

class BadFleet : public ::testing::TestWithParam<Bad> {};

TEST_P(BadFleet, IsOneSentenceWithItsPlace) {
  const std::string said = test::refusal([] {
    Fleet fleet = parse_fleet(GetParam().text, "robots.toml");
    choose(fleet);
  });
  EXPECT_THAT(said, StartsWith(std::string("robots.toml") + GetParam().sentence));
  EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 0);
}

std::string many(int robots) {
  std::string text;
  for (int i = 0; i < robots; ++i)
    text += "[[agent]]\nname = \"r" + std::to_string(i) + "\"\nsketch = \"PidFollower\"\n";
  return text;
}
const std::string kTooMany = many(257);

const Bad kBad[] = {
    {"empty", "", ": the fleet has no robots: expected a table [[agent]] for each robot"},
    {"noAgents", "map = \"oval\"", ": the fleet has no robots"},
    {"notATable", "agent = 3", ": the fleet has no robots"},
    {"oneTable", "[agent]\nname = \"A\"", ": the fleet has no robots"},
    {"notToml", "[[agent]\n", ":1:"},
    {"unknownTop", "maps = \"oval\"\n[[agent]]\nname = \"A\"\nsketch = \"PidFollower\"", ":1:"},
    {"mapIsANumber", "map = 3\n[[agent]]\nname = \"A\"\nsketch = \"PidFollower\"", ":1:"},
    {"noName", "[[agent]]\nsketch = \"PidFollower\"", ":1:1: [[agent]] lacks"},
    {"emptyName", "[[agent]]\nname = \"\"\nsketch = \"PidFollower\"",
     ":2:8: invalid name of a robot: expected up to 32 letters, digits, _ and -, got “”"},
    {"nameWithASpace", "[[agent]]\nname = \"A B\"\nsketch = \"PidFollower\"",
     ":2:8: invalid name of a robot: expected up to 32 letters, digits, _ and -, got “A B”"},
    {"nameIsANumber", "[[agent]]\nname = 1\nsketch = \"PidFollower\"", ":2:8: name"},
    {"longName", "[[agent]]\nname = \"abcdefghijklmnopqrstuvwxyz-1234567\"\nsketch = \"PidFollower\"",
     ":2:8: invalid name of a robot"},
    {"nameTwice",
     "[[agent]]\nname = \"A\"\nsketch = \"PidFollower\"\n[[agent]]\nname = \"A\"\nsketch = \"PidFollower\"",
     ":5:8: name: A is already the name of the robot on line 1"},
    {"noSketch", "[[agent]]\nname = \"A\"", ":1:1: [[agent]] lacks"},
    {"emptySketch", "[[agent]]\nname = \"A\"\nsketch = \"\"",
     ":3:10: sketch: expected a word, got an empty string"},
    {"noSuchSketch", "[[agent]]\nname = \"A\"\nsketch = \"PidFolower\"", ":1:1: robot A: "},
    {"unknownKey", "[[agent]]\nname = \"A\"\nsketch = \"PidFollower\"\ncolour = \"red\"",
     ":4:10: unknown key colour"},
    {"unknownTarget", "[[agent]]\nname = \"A\"\nsketch = \"PidFollower\"\ntarget = \"pic\"", ":4:10: "},
    {"noSuchRobot", "[[agent]]\nname = \"A\"\nsketch = \"PidFollower\"\nrobot = \"uno9\"", ":1:1: robot A: "},
    {"noSuchMap", "map = \"ovall\"\n[[agent]]\nname = \"A\"\nsketch = \"PidFollower\"", ":2:1: robot A: "},
    {"clockWithoutUnit", "[[agent]]\nname = \"A\"\nsketch = \"PidFollower\"\nclock = \"5\"",
     ":4:9: clock: expected a time above 0 with a unit"},
    {"clockIsANumber", "[[agent]]\nname = \"A\"\nsketch = \"PidFollower\"\nclock = 5", ":4:9: clock"},
    {"emptyStart", "[[agent]]\nname = \"A\"\nsketch = \"PidFollower\"\nstart = \"\"",
     ":4:9: start: expected a word, got an empty string"},
    {"sanitizeIsText", "[[agent]]\nname = \"A\"\nsketch = \"PidFollower\"\nsanitize = \"yes\"",
     ":4:12: sanitize"},
    {"librariesAreNumbers", "[[agent]]\nname = \"A\"\nsketch = \"PidFollower\"\nlibraries = [1]",
     ":4:14: libraries"},
    {"tooMany", kTooMany.c_str(), ":769:1: too many robots: expected at most 256, got 257"},
};

INSTANTIATE_TEST_SUITE_P(Files, BadFleet, ::testing::ValuesIn(kBad),
                         [](const auto& bad) { return std::string(bad.param.name); });

TEST(FleetFile, AScriptThatIsNotThereIsNamed) {
  EXPECT_THAT(
      [] {
        parse_fleet("[[agent]]\nname = \"A\"\nsketch = \"PidFollower\"\nscript = \"none.txt\"", "r.toml");
      },
      ::testing::ThrowsMessage<InputError>(HasSubstr("none.txt")));
}

}  // namespace robosim::launch::fleet_test
