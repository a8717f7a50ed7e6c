// Tests `robosim run` with several robots: docs/howto/fleets.md.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "sim/exec/host/confinement.h"
#include "tests/support/require_target.h"
#include "tests/system/json_of.h"
#include "tests/system/on_terminal.h"

namespace robosim::test {
namespace cli_fleet_test {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

const std::vector<std::string> kTwoRobots{"run",    "A=PidFollower", "B=PidFollower", "--map",
                                          "oval",   "--for",         "12s",           "--goal",
                                          "laps:1", "--start",       "B=20,2,W"};

std::vector<std::string> two_with(const std::vector<std::string>& more) {
  std::vector<std::string> words = kTwoRobots;
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

TEST(CliFleet, TwoRobotsHaveALineAndAVerdictEach) {
  const Ended run = robosim_command(kTwoRobots);
  EXPECT_EQ(run.status, 0) << run.err << run.out;
  EXPECT_THAT(run.out, AllOf(HasSubstr("\nA      reached"), HasSubstr("\nB      reached"),
                             HasSubstr("A: The goal laps:1 was reached after"), HasSubstr("2 of 2 reached")));
}

TEST(CliFleet, OneThatFailsIsEnoughForTheExitStatus) {
  const Ended run = robosim_command(two_with({"--goal", "B=station:1"}));
  EXPECT_EQ(run.status, 2) << "the oval has no station";
  EXPECT_THAT(run.err, HasSubstr("robot B: "));
  const Ended late = robosim_command(two_with({"--goal", "B=laps:9"}));
  EXPECT_EQ(late.status, 4) << late.err;
  EXPECT_THAT(late.out, HasSubstr("1 of 2 reached"));
}

TEST(CliFleet, TheJsonHasAnObjectForEachAndTheFirstOnesRunIsTheOneItHasAlone) {
  const Ended run = robosim_command(two_with({"--json"}));
  EXPECT_EQ(robosim_command(two_with({"--json"})).out, run.out);
  const nlohmann::json fleet = json_of(run);
  EXPECT_EQ(fleet["schema"], "robosim.fleet/1");
  EXPECT_EQ(fleet["reached"], 2);
  ASSERT_EQ(fleet["robots"].size(), 2u);
  nlohmann::json first = fleet["robots"][0];
  EXPECT_EQ(first["name"], "A");
  const nlohmann::json alone = json_of(
      robosim_command({"run", "PidFollower", "--map", "oval", "--for", "12s", "--goal", "laps:1", "--json"}));
  EXPECT_EQ(first["trace_hash"], alone["trace_hash"]) << "the two robots never met";
  EXPECT_NE(fleet["robots"][1]["trace_hash"], first["trace_hash"]);
}

TEST(CliFleet, HostAndAvrDriveSideBySideFromAFile) {
  ROBOSIM_NEEDS_TARGET("avr");
  const Folder folder;
  write_file(folder / "robots.toml",
             "map = \"oval\"\n[[agent]]\nname = \"A\"\nsketch = \"PidFollower\"\ngoal = \"laps:1\"\n"
             "[[agent]]\nname = \"B\"\nsketch = \"PidFollower\"\ntarget = \"avr\"\ngoal = \"laps:1\"\n"
             "start = \"20,2,W\"\n");
  const Ended run = robosim_command({"run", "robots.toml"}, folder.path());
  EXPECT_EQ(run.status, 0) << run.err << run.out;
  EXPECT_THAT(run.out, AllOf(HasSubstr("uno5, host"), HasSubstr("uno5, avr"), HasSubstr("2 of 2")));
}

TEST(CliFleet, TheSameSketchTwiceHasItsVariablesTwiceAndACrashIsItsRobots) {
  ROBOSIM_NEEDS_TARGET("avr");
  const Folder folder;
  write_file(folder / "Count.ino",
             "int n;\nvoid setup() { Serial.begin(9600); }\n"
             "void loop() { delay(100); Serial.println(++n); if (n == 5 && digitalRead(2)) *(volatile int*)0 "
             "= 1; }\n");
  const Ended run = robosim_command(
      {"run", "A=./Count.ino", "B=./Count.ino", "C=./Count.ino", "--target", "C=avr", "--map", "oval",
       "--goal", "none", "--for", "1s", "--start", "B=20,2,W", "--start", "C=10,2,W", "--json"},
      folder.path());
  const nlohmann::json robots = json_of(run)["robots"];
  ASSERT_EQ(robots.size(), 3u) << run.err;
  for (const auto& robot : robots)
    EXPECT_THAT(robot["serial"].get<std::string>(), StartsWith("1\r\n2\r\n3\r\n4\r\n5"));
  EXPECT_EQ(robots[0]["verdict"], "crashed");
  EXPECT_THAT(robots[1]["why"].get<std::string>(), HasSubstr("in loop, Count.ino:3"));
  EXPECT_EQ(robots[2]["verdict"], "reached") << "address 0 is valid on a chip";
}

#if defined(__x86_64__)
TEST(CliFleet, ASketchThatTakesTheProcessDownIsNamed) {
  const Folder folder;
  write_file(folder / "Gone.ino",
             // If all signals are blocked, the kernel kills a process at its first refused call.
             "void setup() {}\nvoid loop() {\n  delay(300);\n  unsigned long all = ~0ul;\n"
             "  register long bytes asm(\"r10\") = 8;\n"
             "  asm volatile(\"syscall\" ::\"a\"(14l), \"D\"(2l), \"S\"(&all), \"d\"(0l), \"r\"(bytes)"
             " : \"rcx\", \"r11\", \"memory\");\n"
             "  asm volatile(\"syscall\" ::\"a\"(60l), \"D\"(3l) : \"rcx\", \"r11\", \"memory\");\n}\n");
  const Ended run = robosim_command({"run", "A=PidFollower", "B=./Gone.ino", "--map", "oval", "--goal",
                                     "none", "--for", "1s", "--start", "B=20,2,W", "--json"},
                                    folder.path());
  EXPECT_EQ(run.status, 1) << run.err << run.out;
  const nlohmann::json robots = json_of(run)["robots"];
  ASSERT_EQ(robots.size(), 2u) << run.err;
  EXPECT_EQ(robots[0]["verdict"], "interrupted");
  EXPECT_EQ(robots[0]["why"], "The run ended when the sketch of B ended its process.");
  EXPECT_EQ(robots[1]["verdict"], "crashed");
}
#endif

TEST(CliFleet, HostAvrAndStm32DriveTogetherAsEachDoesAlone) {
  ROBOSIM_NEEDS_TARGET("avr");
  ROBOSIM_NEEDS_TARGET("stm32");
  const Folder folder;
  write_file(folder / "cut.txt", "at 500ms power off for 300ms\n");
  const std::map<std::string, std::vector<std::string>> robots = {
      {"A", {"host", "10,14,E"}}, {"B", {"avr", "20,2,W"}}, {"C", {"stm32", "10,2,W"}}};
  const std::vector<std::string> common = {"--map", "oval",      "--goal", "none",  "--for",
                                           "2s",    "--profile", "ideal",  "--json"};
  std::map<std::string, std::string> alone;
  for (const auto& [name, robot] : robots) {
    std::vector<std::string> words = {"run", "PidFollower", "--target", robot[0], "--start", robot[1]};
    if (name == "C") words.insert(words.end(), {"--script", "cut.txt"});
    words.insert(words.end(), common.begin(), common.end());
    alone[name] = json_of(robosim_command(words, folder.path()))["trace_hash"];
  }
  for (const std::string order : {"ABC", "CBA"}) {
    std::vector<std::string> words = {"run"};
    for (const char name : order) words.push_back(name + std::string("=PidFollower"));
    for (const auto& [name, robot] : robots)
      words.insert(words.end(), {"--target", name + "=" + robot[0], "--start", name + "=" + robot[1]});
    words.insert(words.end(), {"--script", "C=cut.txt"});
    words.insert(words.end(), common.begin(), common.end());
    const Ended run = robosim_command(words, folder.path());
    EXPECT_EQ(run.status, 0) << run.err;
    const nlohmann::json fleet = json_of(run);
    std::map<std::string, std::string> together;
    for (const auto& robot : fleet["robots"]) together[robot["name"]] = robot["trace_hash"];
    EXPECT_EQ(together, alone) << order;
  }
}

TEST(CliFleet, ASketchBesideAnStm32IsConfinedAndTheOthersDriveOn) {
  ROBOSIM_NEEDS_TARGET("stm32");
  if (const std::string why = exec::why_not_confined(); !why.empty()) GTEST_SKIP() << why;
  const Folder folder;
  // The emulated STM32 must execute LDREX and STREX correctly, before and after a power cycle.
  write_file(folder / "Left.ino",
             "volatile unsigned shared;\n"
             "void setup() { Serial.begin(9600); }\n"
             "void loop() {\n  unsigned value, first, second;\n"
             "  asm volatile(\"ldrex %0, [%3]\\n strex %1, %0, [%3]\\n strex %2, %0, [%3]\"\n"
             "    : \"=&r\"(value), \"=&r\"(first), \"=&r\"(second) : \"r\"(&shared) : \"memory\");\n"
             "  Serial.print(first); Serial.print(second); delay(200);\n}\n");
  write_file(folder / "cut.txt", "at 300ms power off for 100ms\n");
  for (const auto& [line, refused] :
       std::map<std::string, std::string>{{"open(\"/etc/passwd\", 0)", "openat (files)"},
                                          {"mmap(0, 4096, 7, 0x22, -1, 0)", "mmap (memory)"}}) {
    write_file(
        folder / "Guest.ino",
        "extern \"C\" { int open(const char*, int, ...); void* mmap(void*, unsigned long, int, int, int, "
        "long); }\nvoid setup() {}\nvoid loop() { delay(100);\n  " +
            line + "; }\n");
    const Ended run = robosim_command(
        {"run", "A=./Guest.ino", "B=./Left.ino", "--target", "B=stm32", "--map", "oval", "--goal", "none",
         "--for", "1s", "--start", "B=20,2,W", "--script", "B=cut.txt", "--json"},
        folder.path());
    ASSERT_EQ(run.status, 1) << run.err;
    const nlohmann::json robots = json_of(run)["robots"];
    ASSERT_EQ(robots.size(), 2u) << run.err;
    EXPECT_EQ(robots[0]["verdict"], "crashed");
    EXPECT_THAT(robots[0]["why"].get<std::string>(), AllOf(HasSubstr(refused), HasSubstr("Guest.ino:4")));
    EXPECT_EQ(robots[1]["verdict"], "reached") << robots[1]["why"];
    EXPECT_EQ(robots[1]["serial"], "0101010101");
  }
}

TEST(CliFleet, TheOrderOfTheNamesChangesNothingButTheNumbers) {
  const auto hashes = [](const std::string& first, const std::string& second) {
    const Ended run = robosim_command({"run", first + "=PidFollower", second + "=PidFollower", "--map",
                                       "oval", "--for", "4s", "--goal", "none", "--start", "B=18,14,W",
                                       "--start", "A=10,14,E", "--profile", "ideal", "--json"});
    const nlohmann::json fleet = json_of(run);
    std::map<std::string, std::string> by_name;
    for (const auto& robot : fleet["robots"]) by_name[robot["name"]] = robot["trace_hash"];
    EXPECT_EQ(by_name.size(), 2u);
    EXPECT_GT(fleet["robots"][0]["metrics"]["collisions"], 0) << "the robots meet";
    return by_name;
  };
  EXPECT_EQ(hashes("A", "B"), hashes("B", "A"));
}

TEST(CliFleet, ARecordingHasRowsOfAllAndAPictureShowsAll) {
  const Folder folder;
  const Ended plain = robosim_command(two_with({"--json"}));
  const Ended run =
      robosim_command(two_with({"--json", "--record", "r.csv", "--plot", "p.svg"}), folder.path());
  EXPECT_EQ(run.out, plain.out) << "a recording changes nothing";
  const std::string csv = read_file(folder / "r.csv");
  EXPECT_THAT(csv, StartsWith("t_us,robot,x_mm,y_mm,yaw_rad,speed_mm_s,cross_track_mm,left,right,S1,"));
  EXPECT_THAT(csv, AllOf(HasSubstr("\n10000,A,"), HasSubstr("\n10000,B,")));
  const std::string svg = read_file(folder / "p.svg");
  EXPECT_THAT(svg, AllOf(HasSubstr("2 robots on oval: 2 of 2 reached their goals"), HasSubstr(">A</text>"),
                         HasSubstr(">B</text>")));
}

TEST(CliFleet, APageIsReplayedHeldAgainstAnotherAndWrittenAsATrace) {
  const Folder folder;
  const Ended plain = robosim_command(two_with({}));
  const Ended run = robosim_command(two_with({"--record", "r.html"}), folder.path());
  EXPECT_EQ(run.out, plain.out + "r.html is written; open it in a browser\n")
      << "a recording changes nothing";
  ASSERT_EQ(robosim_command(two_with({"--record", "s.rec", "--seed", "2"}), folder.path()).status, 0);
  const Ended replay =
      robosim_command({"replay", "r.html", "--over", "s.rec", "--record", "r.perfetto.json"}, folder.path());
  EXPECT_EQ(replay.status, 0) << replay.err;
  EXPECT_THAT(replay.out, AllOf(HasSubstr("2 robots on oval"), HasSubstr("2 of 2 reached their goals"),
                                HasSubstr("A over it: s.rec: PidFollower on oval, seed 2, host: reached"),
                                HasSubstr("\nB apart:   1 mm at ")));
  EXPECT_THAT(read_file(folder / "r.perfetto.json"),
              AllOf(HasSubstr("A: pins of the uno"), HasSubstr("B: pins of the uno")));
  folder.write("log.csv", "t,x,y\n0,1,1\n1,2,2\n");
  const Ended log = robosim_command({"replay", "r.html", "--over", "log.csv"}, folder.path());
  EXPECT_EQ(log.status, 2);
  EXPECT_THAT(log.err,
              HasSubstr("log.csv: no robot is in both runs: expected A or B, got one without a name"));
}

TEST(CliFleet, RobotsTalkByRadioFromHostToAvr) {
  ROBOSIM_NEEDS_TARGET("avr");
  const Folder folder;
  write_file(
      folder / "robot.toml",
      "base = \"uno5\"\n[[part]]\nname = \"air\"\ntype = \"serial-radio\"\npins = { txd = 0, rxd = 1 }\n");
  write_file(folder / "Ask.ino",
             "void setup() { Serial.begin(9600); delay(500); Serial.print('?'); }\n"
             "void loop() { if (Serial.available()) Serial.println(Serial.read() == '!' ? \"heard\" : "
             "\"else\"); }\n");
  write_file(
      folder / "Answer.ino",
      "void setup() { Serial.begin(9600); }\nvoid loop() { if (Serial.read() == '?') Serial.print('!'); }\n");
  const Ended run =
      robosim_command({"run", "A=./Ask.ino", "B=./Answer.ino", "--target", "B=avr", "--robot", "./robot.toml",
                       "--map", "oval", "--goal", "none", "--for", "1s", "--start", "B=20,2,W", "--json"},
                      folder.path());
  const nlohmann::json robots = json_of(run)["robots"];
  ASSERT_EQ(robots.size(), 2u) << run.err;
  EXPECT_EQ(robots[0]["serial"], "?heard\r\n");
  EXPECT_EQ(robots[1]["serial"], "!");
}

TEST(CliFleet, TwoNavigatorsWaitForEachOtherAndDoNotCollide) {
  ROBOSIM_NEEDS_TARGET("avr");
  const Ended run = robosim_command({"run", std::string(ROBOSIM_EXAMPLES) + "/navigators/robots.toml",
                                     "--target", "B=avr", "--for", "400s", "--json"});
  EXPECT_EQ(run.status, 0) << run.err;
  const nlohmann::json robots = json_of(run)["robots"];
  ASSERT_EQ(robots.size(), 2u) << run.err;
  for (const auto& robot : robots) {
    EXPECT_EQ(robot["verdict"], "reached") << robot["why"];
    EXPECT_EQ(robot["metrics"]["collisions"], 0);
  }
  EXPECT_THAT(robots[0]["serial"].get<std::string>(), HasSubstr("waiting"));
}

TEST(CliFleet, WhoLooksAheadStopsBeforeAnotherRobotAndWhoDoesNotDrivesIntoIt) {
  const std::string stops = ROBOSIM_SAMPLES "/StopsForBox";
  const auto collisions = [&](const std::string& sketch, bool another) {
    std::vector<std::string> words{"run",   "A=" + sketch, "--robot", "A=" + stops + "/robot.toml",
                                   "--map", "oval",        "--goal",  "none",
                                   "--for", "9s",          "--json"};
    if (another)
      words.insert(words.end(), {"B=" + std::string(ROBOSIM_TEST_SKETCHES) + "/NeverDrives", "--robot",
                                 "B=uno3", "--start", "B=20,14,E"});
    return json_of(robosim_command(words))["robots"][0]["metrics"]["collisions"].get<int>();
  };
  EXPECT_EQ(collisions(stops, false), 0);
  EXPECT_EQ(collisions("LeftPath", false), 0);
  EXPECT_EQ(collisions(stops, true), 0);
  EXPECT_EQ(collisions("LeftPath", true), 1);
}

TEST(CliFleet, TheViewEndsWithWhatAllHaveReached) {
  OnTerminal run(two_with({"--view", "--speed", "0"}), 100, 30);
  ASSERT_TRUE(run.wait_for("press any key")) << run.seen();
  EXPECT_NE(run.seen().find("reached: "), std::string::npos);
  run.type("x");
  EXPECT_TRUE(run.wait_for("2 of 2 reached their goals")) << run.seen();
  EXPECT_EQ(run.finish(), 0);
}

TEST(CliFleet, SweepsAndChecksCountARunInWhichAllReachTheirGoals) {
  const Folder folder;
  write_file(folder / "robots.toml",
             "map = \"oval\"\n[[agent]]\nname = \"A\"\nsketch = \"PidFollower\"\n"
             "[[agent]]\nname = \"B\"\nsketch = \"PidFollower\"\nstart = \"20,2,W\"\ngoal = \"laps:1\"\n");
  const Ended sweep = robosim_command(
      {"sweep", "robots.toml", "--seeds", "1..2", "--goal", "laps:1", "--for", "12s"}, folder.path());
  EXPECT_EQ(sweep.status, 0) << sweep.err;
  EXPECT_THAT(sweep.out, AllOf(HasSubstr("robots.toml"), HasSubstr("2 robots"), HasSubstr("1.0000")));
  const Ended late = robosim_command(
      {"sweep", "robots.toml", "--seeds", "1..1", "--goal", "laps:9", "--for", "12s"}, folder.path());
  EXPECT_THAT(late.out, HasSubstr("robot A: "));

  write_file(folder / "Mine.ino", "void setup() {}\nvoid loop() {}\n");
  write_file(folder / "checks.toml",
             "[[check]]\nname = \"both\"\nfleet = \"robots.toml\"\ngoal = \"laps:1\"\nfor = \"12s\"\n"
             "collisions = { max = 0 }\n");
  const Ended checks = robosim_command({"test", "Mine.ino"}, folder.path());
  EXPECT_EQ(checks.status, 0) << checks.out << checks.err;
  write_file(folder / "checks.toml", "[[check]]\nname = \"both\"\nfleet = \"robots.txt\"\n");
  const Ended bad = robosim_command({"test", "Mine.ino"}, folder.path());
  EXPECT_EQ(bad.status, 2);
  EXPECT_THAT(bad.out + bad.err, HasSubstr("checks.toml:3:9: fleet: expected a .toml file"));
}

TEST(CliFleet, WhatCannotBeSaidIsOneSentence) {
  const auto refusal = [](const std::vector<std::string>& more) {
    const Ended run = robosim_command(two_with(more));
    EXPECT_EQ(run.status, 2) << run.err;
    return run.err;
  };
  EXPECT_THAT(refusal({"--target", "B=pic"}), HasSubstr("robot B: "));
  EXPECT_THAT(refusal({"--start", "B=2,2,E"}), HasSubstr("--start is given more than once for B"));
  EXPECT_THAT(refusal({"--start", "A=20,2,E"}), HasSubstr("robot B starts on top of robot A"));
  EXPECT_THAT(refusal({"--robot", "B="}), HasSubstr("--robot: B= lacks a value"));
  EXPECT_THAT(refusal({"--gdb", "3333"}), HasSubstr("--gdb halts only one robot's chip"));
  EXPECT_THAT(refusal({"--script", "B=/none.txt"}), HasSubstr("/none.txt"));
  EXPECT_THAT(refusal({"--map", "ovall"}), HasSubstr("--map is given more than once"));
  EXPECT_THAT(refusal({"--robot", "B b=uno5"}),
              HasSubstr("invalid name of a robot: expected up to 32 letters, digits, _ and -, got “B b”"));
}

}  // namespace cli_fleet_test
}  // namespace robosim::test
