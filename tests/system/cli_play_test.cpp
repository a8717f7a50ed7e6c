// Tests `robosim play`, scripted from a pipe and on a terminal.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "tests/system/command.h"
#include "tests/system/on_terminal.h"

namespace robosim::test {
namespace cli_play_test {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

/// Returns the output of a session in which these lines are typed in advance.
Ended play(const std::vector<std::string>& words, const std::string& typed,
           const std::filesystem::path& folder = ".") {
  std::vector<std::string> all{"play"};
  all.insert(all.end(), words.begin(), words.end());
  const Folder files;
  return robosim_command(all, folder, nullptr, files.write("typed", typed).c_str());
}

// Accepts the default answers to the first four questions: the start's place, movement by cells, speed 1, and
// the algorithm "ai".
constexpr const char* kScan = "\n\n\n\n";

TEST(CliPlay, ASessionRunsFromAPipeToItsEnd) {
  const Ended ended = play({"d"}, std::string(kScan) + "\n5\n\nn\nq\n");
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_EQ(ended.err, "");
  for (const char* text :
       {"Map d: 31 columns x 19 rows, 68 line cells of 100 mm",
        "Scan complete. Time consumed: 141 s, 141 moves.", "7 stations, 5 junctions, 11 links; a tree",
        "S1 to S5\nJunctions: J1, J2, J3, J4, J5\nTurns: R, L, R, L, L",
        "On the map: east at J1, east at J2, east at J3, east at J4, north at J5", "Arrived at S5."})
    EXPECT_THAT(ended.out, HasSubstr(text));
  EXPECT_THAT(ended.out, Not(HasSubstr("\033"))) << "escape codes are for terminals";
}

TEST(CliPlay, TheMapsOfThePaperTakeItsTimes) {
  for (const auto& [map, time] : {std::pair{"c", "94 s"}, {"d", "141 s"}, {"e", "129 s"}, {"f", "247 s"}})
    EXPECT_THAT(play({map}, kScan).out, HasSubstr(std::string("Time consumed: ") + time)) << map;
}

TEST(CliPlay, EndsCleanlyWhereverItsInputEnds) {
  std::string typed;
  for (const char* line : {"d\n", "\n", "\n", "\n", "\n", "\n", "5\n", "\n", "n\n", "q"}) {
    EXPECT_EQ(play({}, typed).status, 0) << typed;
    typed += line;
  }
  EXPECT_EQ(play({}, typed).status, 0);
}

TEST(CliPlay, TheFoldersOwnMapsAreListedAndCanBeChosen) {
  const Folder folder;
  folder.write("mine.map", "_____\n_..._\n_____\n");
  folder.write("broken.map", "1\n123z\n");
  const Ended ended = play({}, "./broken.map\n./mine.map\n", folder.path());
  EXPECT_THAT(ended.out, HasSubstr("./mine.map"));
  EXPECT_THAT(ended.out, HasSubstr("in this folder"));
  EXPECT_THAT(ended.out, HasSubstr("Not possible: ./broken.map:"));
  EXPECT_THAT(ended.out, HasSubstr("Map mine: 5 columns x 3 rows, 3 line cells"));
}

TEST(CliPlay, AMapWithoutAJunctionAndAClosedLoopEndTheirScanToo) {
  const Folder folder;
  folder.write("line.map", "_____\n_..._\n_____\n");
  folder.write("ring.map", "_____\n_..._\n_._._\n_..._\n_____\n");
  folder.write("dot.map", "___\n_._\n___\n");
  EXPECT_THAT(play({"./line.map"}, kScan, folder.path()).out, HasSubstr("2 stations, 0 junctions"));
  EXPECT_THAT(play({"./ring.map"}, std::string(kScan) + "\n", folder.path()).out,
              HasSubstr("There is no station to drive to."));
  EXPECT_THAT(play({"./dot.map"}, std::string(kScan) + "\n", folder.path()).out,
              HasSubstr("There is only one station"));
}

TEST(CliPlay, WhatCannotBeReachedIsTold) {
  EXPECT_THAT(play({"island"}, kScan).out, HasSubstr("unreachable: "));
}

TEST(CliPlay, LeftAndRightWalkAndComeBack) {
  for (const char* which : {"1", "2"}) {
    const Ended ended = play({"d"}, std::string("\n\n\n") + which + "\n");
    EXPECT_THAT(ended.out, HasSubstr("The robot is back at its start. It met 7 ends\nof a line."));
  }
}

TEST(CliPlay, TheDrivenRobotScansAndGoesWhereItIsSent) {
  const Ended ended = play({"b"}, "\n2\n3\n99\n2\n1\n\nq\n");
  EXPECT_EQ(ended.status, 0) << ended.err;
  for (const char* text : {"scan complete: 4 stations, 2 junctions", "> 99\nrefused. Stations: 1",
                           "arrived at 2", "arrived at 1", "The robot has done its drives."})
    EXPECT_THAT(ended.out, HasSubstr(text));
}

TEST(CliPlay, TheDrivenRobotGoesOnFromWhereItAskedInOneRun) {
  namespace fs = std::filesystem;
  // Creates an installation whose runner records its requests.
  const Folder folder;
  const fs::path asked = folder / "asked";
  const fs::path runner =
      folder.write("libexec/robosim/robosim-host", "#!/bin/sh\ntee -a '" + asked.string() + "' | '" +
                                                       (helper_folder() / "robosim-host").string() + "'\n");
  fs::permissions(runner, fs::perms::owner_all);
  fs::create_directory(folder / "bin");
  fs::copy_file(ROBOSIM_COMMAND, folder / "bin/robosim");
  const fs::path typed = folder.write("typed", "\n2\n3\n2\n1\n\nq\n");
  const Ended ended =
      robosim_command({"play", "b"}, ".", nullptr, typed.c_str(), (folder / "bin/robosim").string());
  ASSERT_THAT(ended.out, AllOf(HasSubstr("arrived at 2"), HasSubstr("arrived at 1"))) << ended.err;
  std::istringstream lines(read_file(asked));
  int runs = 0;
  for (std::string line; std::getline(lines, line);)
    if (line.find("\"run\"") != std::string::npos) ++runs;
  EXPECT_EQ(runs, 1);
}

TEST(CliPlay, TheDrivenRobotToursByTheLeftHand) {
  EXPECT_THAT(play({"b"}, "\n2\n1\n").out, HasSubstr("reached: "));
}

TEST(CliPlay, AStartThatIsNoneAndAMapThatIsNoneAreRefusedAtOnce) {
  EXPECT_EQ(play({"d", "--start", "0,0,E"}, "").status, 2);
  EXPECT_EQ(play({"nowhere"}, "").status, 2);
  EXPECT_EQ(play({"--start", "1,1,E"}, "").status, 2);
}

constexpr const char* kEnter = "\033[?1049h\033[?25l";
constexpr const char* kLeave = "\033[0m\033[?25h\033[?1049l";

TEST(CliPlay, OnATerminalTheScanIsWatchedAndTheTerminalIsAsItWas) {
  OnTerminal session({"play", "c"}, 100, 30);
  ASSERT_TRUE(session.wait_for(kEnter)) << session.seen();
  ASSERT_TRUE(session.wait_for("Enter accepts")) << session.seen();
  EXPECT_TRUE(session.is_raw());
  session.type("\n\n\n\n");
  ASSERT_TRUE(session.wait_for("scanning")) << session.seen();
  session.type(" ");
  ASSERT_TRUE(session.wait_for("paused")) << session.seen();
  session.type("e");
  ASSERT_TRUE(session.wait_for("94")) << session.seen();
  session.type("q");
  ASSERT_TRUE(session.wait_for(kLeave)) << session.seen();
  EXPECT_EQ(session.finish(), 0);
  EXPECT_FALSE(session.is_raw());
}

TEST(CliPlay, CtrlCLeavesTheTerminalAsItWasAtAQuestionAndInAScan) {
  for (const char* typed : {"", "\n", "\n\n\n\n"}) {
    OnTerminal session({"play", "c"}, 100, 30);
    ASSERT_TRUE(session.wait_for("Enter accepts")) << session.seen();
    session.type(typed);
    if (std::string(typed).size() == 4) {
      ASSERT_TRUE(session.wait_for("scanning")) << session.seen();
    }
    session.type("\003");
    ASSERT_TRUE(session.wait_for(kLeave)) << session.seen();
    EXPECT_EQ(session.finish(), 130);
    EXPECT_FALSE(session.is_raw());
  }
}

TEST(CliPlay, SigtermRestoresTheTerminalToo) {
  OnTerminal session({"play", "c"}, 100, 30);
  ASSERT_TRUE(session.wait_for("Enter accepts")) << session.seen();
  session.signal(SIGTERM);
  ASSERT_TRUE(session.wait_for(kLeave)) << session.seen();
  EXPECT_EQ(session.finish(), 128 + SIGTERM);
  EXPECT_FALSE(session.is_raw());
}

TEST(CliPlay, ATooSmallWindowSaysSoAndGrowsAgain) {
  OnTerminal session({"play", "c"}, 30, 8);
  ASSERT_TRUE(session.wait_for("Too small")) << session.seen();
  session.resize(100, 30);
  ASSERT_TRUE(session.wait_for("Enter accepts")) << session.seen();
  session.type("q");
  EXPECT_EQ(session.finish(), 0);
}

}  // namespace cli_play_test
}  // namespace robosim::test
