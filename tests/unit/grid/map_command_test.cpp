#include "sim/cli/map_command.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <sstream>
#include <string>

#include "sim/base/file.h"
#include "tests/support/temporary_folder.h"

namespace robosim::cli {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

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
              HasSubstr("2 bends are too short in the legs for 80 mm: 1,0 gets 50 mm; 1,1 gets 50 mm"));
  EXPECT_THAT(out_.str(), HasSubstr("2 stations cannot be reached from the start: 7,0; 5,1"));
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
  EXPECT_THAT(errors_.str(), HasSubstr("a.map:2:8: goal is laps:2"));
  EXPECT_EQ(check({file("b.map", "+++\ngoal = \"station:3\"\n+++\n....\n")}), ExitStatus::bad_input);
  EXPECT_THAT(errors_.str(), HasSubstr("there are 1 or 2"));
  EXPECT_EQ(check({file("c.map", "+++\n[stations]\ndock = [2, 0]\n[goal]\nx = 2\ny = 0\n+++\n....\n")}),
            ExitStatus::ok);
}

TEST_F(MapCommand, ShowDrawsTheMap) {
  EXPECT_EQ(show_map("d", "", {}, out_), ExitStatus::ok);
  EXPECT_THAT(out_.str(), HasSubstr("1►─────┴"));
  EXPECT_THAT(out_.str(), Not(HasSubstr("Only columns")));
  EXPECT_THROW(show_map("d", "0,0", {}, out_), InputError);
}

}  // namespace
}  // namespace robosim::cli
