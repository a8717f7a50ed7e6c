#include "sim/cli/files/map_command.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>

#include "sim/base/file.h"
#include "sim/cli/files/map_generate.h"
#include "sim/map/map.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_folder.h"

namespace robosim::cli::map_command_test {

using ::testing::AllOf;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

class MapCommand : public testing::Test {
 protected:
  std::string file(const char* name, const char* text) const {
    write_file(folder_.path() / name, text);
    return (folder_.path() / name).string();
  }
  ExitStatus check(const std::vector<std::string>& maps, const std::string& start = "") {
    return check_maps(maps, start, out_, errors_);
  }

  test::TemporaryFolder folder_;
  std::ostringstream out_;
  std::ostringstream errors_;
};

TEST_F(MapCommand, CheckSaysWhatItFound) {
  EXPECT_EQ(check({"d", "oval"}), ExitStatus::ok);
  EXPECT_THAT(out_.str(), HasSubstr("31 x 19 cells of 100 mm: 3100 x 1900 mm"));
  EXPECT_THAT(out_.str(), HasSubstr("68 line cells"));
  EXPECT_THAT(out_.str(), HasSubstr("7 stations, 5 junctions, not a single loop"));
  EXPECT_THAT(out_.str(), HasSubstr("1 at 3,10; 2 at 7,15"));
  EXPECT_THAT(out_.str(), HasSubstr("one loop of 64 steps"));
  EXPECT_THAT(out_.str(), HasSubstr("start     10,14,E"));
  EXPECT_EQ(errors_.str(), "");
}

TEST_F(MapCommand, CheckNumbersStationsFromTheStartItIsGiven) {
  EXPECT_EQ(check({"d"}, "27,10"), ExitStatus::ok);
  EXPECT_THAT(out_.str(), HasSubstr("1 at 27,10; 2 at 20,3"));
}

TEST_F(MapCommand, CheckReportsTightBendsAndWhatIsOutOfReach) {
  EXPECT_EQ(check({file("m.map", "+++\ncorner = \"80 mm\"\n+++\n..___...\n_..._.__\n")}), ExitStatus::ok);
  EXPECT_THAT(out_.str(),
              HasSubstr("2 bends have legs too short for a radius of 80 mm: 1,0 gets 50 mm; 1,1 gets 50 mm"));
  EXPECT_THAT(out_.str(), HasSubstr("2 stations cannot be reached from the start: 7,0; 5,1"));
}

TEST_F(MapCommand, CheckSaysWhereAPathComesNearAWall) {
  const auto said = [&](const std::string& y, const std::string& rows) {
    out_.str("");
    const std::string text = "+++\n[[path]]\nfrom = [\"200 mm\", \"" + y +
                             " mm\"]\nsegments = [{ length = \"500 mm\" }]\n+++\n" + rows;
    EXPECT_EQ(check({file("m.map", text.c_str())}), ExitStatus::ok);
    return out_.str();
  };
  const std::string bare = "_________\n_________\n_________\n_________\n";
  const std::string wall = "_________\n_________\n____#____\n_________\n";
  EXPECT_THAT(said("150", bare), AllOf(HasSubstr("the map is fine\n"), Not(HasSubstr("note"))));
  EXPECT_THAT(said("70", bare), HasSubstr("note: path 1 at 2,3 is 70 mm from the map's edge: a robot"));
  EXPECT_THAT(said("260", wall), HasSubstr("note: path 1 at 4,1 is 60 mm from a wall: a robot"));
  EXPECT_THAT(said("260", wall), Not(HasSubstr("the map is fine")));
  EXPECT_THAT(said("150", wall), HasSubstr("note: path 1 at 4,2 runs into a wall"));
}

TEST_F(MapCommand, CheckCountsSurfacesAndJoints) {
  const std::string map = file("m.map",
                               "+++\n[[surface]]\nat = [\"50 mm\", \"50 mm\"]\nradius = \"20 mm\"\n"
                               "kind = \"wet\"\n[[joint]]\nat = [\"50 mm\", \"50 mm\"]\nsize = [\"3 mm\", "
                               "\"99 mm\"]\n[legend]\n4 = \"wet line\"\n5 = \"carpet\"\n+++\n.44.\n_5__\n");
  EXPECT_EQ(check({map}), ExitStatus::ok);
  EXPECT_THAT(out_.str(), HasSubstr("  surfaces  1, and 3 cells by the legend\n"));
  std::ostringstream json;
  EXPECT_EQ(check_maps({map}, "", json, errors_, true), ExitStatus::ok);
  EXPECT_THAT(out_.str(), HasSubstr("  joints    1\n"));
  EXPECT_THAT(json.str(), HasSubstr("\"surface_cells\": 3"));
  EXPECT_THAT(json.str(), HasSubstr("\"joints\": 1"));
}

TEST_F(MapCommand, CheckGoesOnAfterAMapThatIsWrong) {
  const std::string wrong = file("wrong.map", "..\n.\n");
  EXPECT_EQ(check({wrong, "ovall", "oval"}), ExitStatus::bad_input);
  EXPECT_THAT(errors_.str(), HasSubstr("wrong.map:2:2: "));
  EXPECT_THAT(errors_.str(), HasSubstr("ovall"));
  EXPECT_THAT(out_.str(), HasSubstr("one loop"));
}

TEST_F(MapCommand, CheckRefusesAGoalThatCannotBeReached) {
  EXPECT_EQ(check({file("a.map", "+++\ngoal = \"laps:2\"\n+++\n....\n")}), ExitStatus::bad_input);
  EXPECT_THAT(errors_.str(), HasSubstr("a.map:2:8: goal laps:2 requires a single loop"));
  EXPECT_EQ(check({file("b.map", "+++\ngoal = \"station:3\"\n+++\n....\n")}), ExitStatus::bad_input);
  EXPECT_THAT(errors_.str(), HasSubstr("expected 1 or 2, got “3”"));
  EXPECT_EQ(check({file("c.map", "+++\n[stations]\ndock = [2, 0]\n[goal]\nx = 2\ny = 0\n+++\n....\n")}),
            ExitStatus::ok);
}

TEST_F(MapCommand, GraphTellsStationsAndJunctionsWithWhereTheirLinesLead) {
  EXPECT_EQ(graph_of_map({"graph", "blocked"}),
            "blocked: from 4,14,E 3 stations, 3 junctions, 7 lines of 52 moves, 0 cycles\n"
            "\n"
            "station   at         leads to (junction.slot), in moves\n"
            "1         4,14       junction 1.0 in 5\n"
            "2         28,14      junction 3.2 in 5\n"
            "3         16,4       junction 2.2 in 4\n"
            "\n"
            "junction  at         slots 0, 1, 2, … lead to (junction.slot), in moves\n"
            "1         9,14       station 1 in 5 | obstacle at 16,14 after 6 | junction 2.0 in 13\n"
            "2         16,8       junction 1.2 in 13 | junction 3.0 in 13 | station 3 in 4\n"
            "3         23,14      junction 2.1 in 13 | obstacle at 16,14 after 6 | station 2 in 5\n");
}

TEST_F(MapCommand, GraphForProgramsHasTheShapeOfAScan) {
  const std::string map = file("m.map",
                               "+++\n[stations]\ndock = [0, 2]\n+++\n"
                               "__.___\n__.___\n....x.\n______\n_1____\n");
  EXPECT_EQ(nlohmann::json::parse(graph_of_map({"graph", map, "0,2", true})), nlohmann::json::parse(R"({
    "schema": "robosim.graph/1",
    "start": [0, 2, "E"],
    "stations": [{"id": 1, "x": 0, "y": 2, "name": "dock"}, {"id": 2, "x": 2, "y": 0}],
    "junctions": [{"id": 1, "x": 2, "y": 2, "slots": [{"station": 1}, {"blocked": [4, 2]}, {"station": 2}]}],
    "unreachable": [[5, 2], [1, 4]],
    "edges": [
      {"from": {"station": 1}, "to": {"junction": 1, "slot": 0}, "length": 2},
      {"from": {"station": 2}, "to": {"junction": 1, "slot": 2}, "length": 2},
      {"from": {"junction": 1, "slot": 1}, "to": {"blocked": [4, 2]}, "length": 1}]})"));
}

TEST_F(MapCommand, GraphForProgramsHasEveryLineOnce) {
  const nlohmann::json graph = nlohmann::json::parse(graph_of_map({"graph", "city", "", true}));
  EXPECT_EQ(graph["stations"].size(), 6u);
  EXPECT_EQ(graph["junctions"].size(), 25u);
  EXPECT_EQ(graph["edges"].size(), 46u);  // a tree of 31 nodes has 30 edges; 16 cycles need 16 more
}

TEST_F(MapCommand, GraphForGraphvizNamesNodesAndLabelsLines) {
  const std::string island = graph_of_map({"graph", "island", "", false, true});
  EXPECT_THAT(island, StartsWith("graph \"island\" {\n"));
  EXPECT_THAT(island, HasSubstr("  s1 -- j1 [label=\"5\"]\n"));
  EXPECT_THAT(island, HasSubstr("  s1 [shape=circle, label=\"1\", pos=\"2,4!\"]\n"));
  EXPECT_THAT(island, HasSubstr("style=dashed, label=\"?\""));
  EXPECT_THAT(island, EndsWith("}\n"));
  const std::string blocked = graph_of_map({"graph", "blocked", "", false, true});
  EXPECT_THAT(blocked, HasSubstr("  x1 [shape=plain, label=\"x\", pos=\"8,2!\"]\n"));
  EXPECT_THAT(blocked, HasSubstr("  j1 -- x1 [label=\"6\"]\n"));
}

TEST_F(MapCommand, GraphOfALineWithoutNodesSaysSo) {
  EXPECT_EQ(graph_of_map({"graph", "oval"}),
            "oval: from 10,14,E 0 stations, 0 junctions, 0 lines of 0 moves, 0 cycles\n");
}

TEST_F(MapCommand, GenerateWritesMapsWhoseNamesTellHowToMakeThemAgain) {
  const std::string folder = (folder_.path() / "new" / "maps").string();
  EXPECT_EQ(generate_maps({"cycles", 5, 3, 9, folder}, out_), ExitStatus::ok);
  EXPECT_EQ(out_.str(), "wrote 3 maps, " + folder + "/cycles-5-9.map to cycles-5-11.map\n");
  for (const int seed : {9, 10, 11}) {
    const std::string name = "cycles-5-" + std::to_string(seed);
    const map::Map map = map::read_map(folder + '/' + name + ".map");
    EXPECT_EQ(map.name, name);
    EXPECT_EQ(map.generator, "cycles 1 stations 5 seed " + std::to_string(seed));
    EXPECT_EQ(check({folder + '/' + name + ".map"}), ExitStatus::ok);
  }
}

TEST_F(MapCommand, GeneratedTracksAreLoopsThatTheirSeedDetermines) {
  const std::string folder = folder_.path().string();
  EXPECT_EQ(generate_maps({kTrackFamily, 12, 2, 3, folder}, out_), ExitStatus::ok);
  std::set<std::string> texts;
  for (const int seed : {3, 4}) {
    const std::string path = folder + "/track-12-" + std::to_string(seed) + ".map";
    EXPECT_EQ(map::read_map(path).goal, "laps:1");
    EXPECT_EQ(check({path}), ExitStatus::ok);
    texts.insert(read_file(path));
  }
  EXPECT_EQ(texts.size(), 2u) << "another seed, another track";
  generate_maps({kTrackFamily, 12, 1, 3, folder + "/again"}, out_);
  EXPECT_TRUE(texts.contains(read_file(folder + "/again/track-12-3.map")));
}

TEST_F(MapCommand, GenerateOverwritesNothing) {
  const std::string mine = file("tree-4-3.map", "...\n");
  EXPECT_THAT(test::refusal([&] {
                generate_maps({"tree", 4, 5, 1, folder_.path().string()}, out_);
              }),
              StartsWith(mine + ": exists already; nothing was written"));
  EXPECT_EQ(read_file(mine), "...\n");
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "tree-4-1.map"));
  EXPECT_THROW(generate_maps({"tree", 4, 1, 1, mine}, out_), InputError);  // a file instead of a folder
}

TEST_F(MapCommand, ShowDrawsTheMap) {
  EXPECT_EQ(show_map("d", "", {}, out_), ExitStatus::ok);
  EXPECT_THAT(out_.str(), HasSubstr("1►─────┴"));
  EXPECT_THAT(out_.str(), Not(HasSubstr("Only columns")));
  EXPECT_THROW(show_map("d", "0,0", {}, out_), InputError);
}

}  // namespace robosim::cli::map_command_test
