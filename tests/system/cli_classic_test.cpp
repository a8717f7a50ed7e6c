// Tests `robosim classic`, as a user runs it.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/system/json_of.h"

namespace robosim::test {
namespace cli_classic_test {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// The floor of these tests: two junctions, and a station that faces a wall.
constexpr const char* kFloor =
    "00000000000\n"
    "00001000000\n"
    "00001000000\n"
    "01111111120\n"
    "00000010000\n"
    "00000010000\n"
    "00000000000\n";

json classic(const Folder& folder, std::vector<std::string> words) {
  words.insert(words.begin(), {"classic", "./floor.map", "--json"});
  const Ended run = robosim_command(words, folder.path());
  EXPECT_EQ(run.status, 0) << run.err;
  return json::parse(run.out, nullptr, false);
}

TEST(CliClassic, TellsScanAndRoutesForPrograms) {
  const Folder folder;
  folder.write("floor.map", kFloor);
  const json out = classic(folder, {"--start", "1,3,E", "--speed", "2", "--to", "3", "--to", "2"});
  EXPECT_EQ(out["schema"], "robosim.classic/1");
  const int cells = 12, ends = 4, facing_a_wall = 1;
  EXPECT_EQ(out["scan"]["moves"], 2 * (cells - 1) + ends + 2 * facing_a_wall);
  EXPECT_EQ(out["scan"]["time"], 2 * (2 * (cells - 1) + ends + 2 * facing_a_wall));
  EXPECT_EQ(out["scan"]["end"], json::parse(R"([1, 3, "E"])"));
  EXPECT_EQ(out["scan"]["stations"], json::parse(R"([{"id": 1, "x": 1, "y": 3}, {"id": 2, "x": 6, "y": 5},
                                                     {"id": 3, "x": 8, "y": 3}, {"id": 4, "x": 4, "y": 1}])"));
  EXPECT_EQ(out["scan"]["junctions"][1]["slots"],
            json::parse(R"([{"junction": 1}, {"station": 2}, {"station": 3}])"));
  ASSERT_EQ(out["routes"].size(), 2u);
  EXPECT_EQ(out["routes"][0]["junctions"], json::parse("[1, 2]"));
  EXPECT_EQ(out["routes"][0]["turns"], "RL");
  EXPECT_EQ(out["routes"][0]["time"], 2 * (7 + 1 + 1)) << "path, turn and wall";
  EXPECT_EQ(out["routes"][0]["ratio_to_shortest"], 1);
  EXPECT_EQ(out["routes"][1]["from"], 3);
  EXPECT_EQ(out["routes"][1]["turns"], "L");
}

TEST(CliClassic, AllIsEveryOrderedPair) {
  const Folder folder;
  folder.write("floor.map", kFloor);
  EXPECT_EQ(classic(folder, {"--to", "all"})["routes"].size(), 4u * 3u);
}

TEST(CliClassic, TheTraceHoldsEveryMove) {
  const Folder folder;
  folder.write("floor.map", kFloor);
  const json out = classic(folder, {"--start", "1,3,E", "--trace"});
  EXPECT_EQ(out["trace"].size(), out["scan"]["moves"]);
  EXPECT_EQ(out["trace"][0], json::parse(R"([1, 3, "E", "straight", "step_forward", 1])"));
  EXPECT_EQ(out["trace"][3], json::parse(R"([4, 3, "E", "junction", "choose_right", 4])"));
}

TEST(CliClassic, AnUnknownDestinationIsRefusedWithTheStationsThatExist) {
  const Ended run = robosim_command({"classic", "c", "--to", "9"});
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.err, HasSubstr("unknown or unreachable station “9”"));
  EXPECT_THAT(run.err, HasSubstr("1, 2, 3, 4, 5, 6"));
  EXPECT_THAT(run.out, IsEmpty());
}

TEST(CliClassic, TheWalksEndWhenTheSameRoundBeginsAgainOrAfterTheirSteps) {
  const Ended closed = robosim_command({"classic", "oval", "--algorithm", "left", "--json"});
  EXPECT_EQ(closed.status, 0);
  EXPECT_EQ(json_of(closed)["walk"]["state"], "closed");
  const Ended limited =
      robosim_command({"classic", "oval", "--algorithm", "right", "--steps", "5", "--json"});
  EXPECT_EQ(limited.status, 0);
  EXPECT_EQ(json_of(limited)["walk"]["state"], "out_of_moves");
  EXPECT_EQ(json_of(limited)["walk"]["moves"], 5);
  EXPECT_EQ(json_of(limited)["walk"]["time"], 5);
}

TEST(CliClassic, RunsTheTemplateOfAnAlgorithmOfOnesOwn) {
  const std::string file = std::string(ROBOSIM_EXAMPLES) + "/my_algorithm.cpp";
  const Ended run = robosim_command({"classic", "d", "--algorithm", file, "--json"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(json_of(run)["walk"]["state"], "returned");
  EXPECT_EQ(json_of(run)["walk"]["dead_ends"].size(), 7u) << "all stations of map d";
  EXPECT_EQ(robosim_command({"classic", "d", "--algorithm", file, "--json"}).out, run.out);
}

TEST(CliClassic, TheTemplateOfASketchVisitsEveryStationOnADrivenRobot) {
  const std::string sketch = std::string(ROBOSIM_EXAMPLES) + "/MyNavigator";
  const Ended run = robosim_command({"run", sketch, "--map", "b", "--robot", "uno5", "--json"});
  EXPECT_EQ(run.status, 0) << run.err;
  const json out = json::parse(run.out, nullptr, false);
  EXPECT_EQ(out["verdict"], "reached");
  EXPECT_EQ(out["metrics"]["stations"], json::parse(R"(["1", "4", "3", "2"])"))
      << "the left-hand walk reaches the last number first";
}

TEST(CliClassic, AnAlgorithmThatCrashesIsToldInASentence) {
  const Folder folder;
  folder.write("crash.cpp",
               "#include <robosim/cells.h>\n"
               "void navigate(robosim::Cells& robot) { robot.step_forward(); *(volatile int*)8 = 1; }\n");
  const Ended run = robosim_command({"classic", "d", "--algorithm", "./crash.cpp"}, folder.path());
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.err, HasSubstr("./crash.cpp crashed"));
  EXPECT_THAT(run.err, HasSubstr("after 1 move, the last from 3,10,E"));
}

TEST(CliClassic, AnAlgorithmThatWalksForEverEndsWithItsMoves) {
  const Folder folder;
  folder.write("spin.cpp",
               "#include <robosim/cells.h>\n"
               "void navigate(robosim::Cells& robot) { for (;;) robot.turn_around(); }\n");
  const Ended run = robosim_command({"classic", "d", "--algorithm", "./spin.cpp", "--steps", "50", "--json"},
                                    folder.path());
  EXPECT_EQ(run.status, 4);
  EXPECT_EQ(json_of(run)["walk"]["moves"], 50);
}

TEST(CliClassic, AnAlgorithmThatLoopsWithoutAMoveIsToldInASentence) {
  const Folder folder;
  folder.write(
      "loop.cpp",
      "#include <robosim/cells.h>\n"
      "void navigate(robosim::Cells& robot) { while (robot.sense() != robosim::Sense::no_path); }\n");
  const Ended run = robosim_command({"classic", "d", "--algorithm", "./loop.cpp"}, folder.path());
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.err, HasSubstr("loops without end"));
  EXPECT_THAT(run.err, HasSubstr("before its first move"));
}

TEST(CliClassic, AnAlgorithmThatThrowsIsToldInASentence) {
  const Folder folder;
  folder.write("throw.cpp",
               "#include <robosim/cells.h>\n#include <stdexcept>\n"
               "void navigate(robosim::Cells&) { throw std::runtime_error(\"no idea\"); }\n");
  const Ended run = robosim_command({"classic", "d", "--algorithm", "./throw.cpp"}, folder.path());
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.err, HasSubstr("./throw.cpp threw an exception: no idea"));
}

TEST(CliClassic, EqualSeedsOfNoiseGiveEqualOutputAndTheExitStatusTellsHowItEnded) {
  const std::vector<std::string> words{"classic", "d", "--noise", "miss=0.02,slip=0.01",
                                       "--seed",  "3", "--json"};
  const Ended run = robosim_command(words);
  const json out = json::parse(run.out, nullptr, false);
  EXPECT_EQ(run.status, out["scan"]["state"] == "complete" ? 0 : 1);
  EXPECT_EQ(robosim_command(words).out, run.out);
}

TEST(CliClassic, AMalformedMapIsRefusedWithLineAndColumn) {
  const Folder folder;
  folder.write("ragged.map", "00000\n0111\n00000\n");
  folder.write("letters.map", "00000\n01q10\n00000\n");
  folder.write("cr.map", "00000\r01110\r00000\r");
  folder.write("blank.map", "\n00000\n01110\n");
  folder.write("empty.map", "");
  const std::vector<std::pair<std::string, std::string>> expected{{"ragged.map", "ragged.map:2"},
                                                                  {"letters.map", "letters.map:2:3"},
                                                                  {"cr.map", "cr.map:1"},
                                                                  {"blank.map", "blank.map:1"},
                                                                  {"empty.map", "empty.map"}};
  for (const auto& [file, place] : expected) {
    const Ended run = robosim_command({"classic", "./" + file}, folder.path());
    EXPECT_EQ(run.status, 2) << file;
    EXPECT_THAT(run.err, HasSubstr(place));
    EXPECT_THAT(run.out, IsEmpty());
  }
}

TEST(CliClassic, AStartThatIsNoLineIsRefused) {
  for (const char* start : {"0,0,E", "999,1,E", "4,9,Q", "4;9"})
    EXPECT_EQ(robosim_command({"classic", "c", "--start", start}).status, 2) << start;
}

TEST(CliClassic, AnAlgorithmThatDoesNotCompileShowsFileAndLine) {
  const Folder folder;
  folder.write("bad.cpp",
               "#include <robosim/cells.h>\nvoid navigate(robosim::Cells& robot) { robot.fly(); }\n");
  const Ended run = robosim_command({"classic", "d", "--algorithm", "./bad.cpp"}, folder.path());
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.err, HasSubstr("./bad.cpp:2:"));
}

}  // namespace cli_classic_test
}  // namespace robosim::test
