#include "sim/launch/launch.h"

#include <gmock/gmock.h>

#include "sim/base/error.h"
#include "sim/base/file.h"
#include "sim/base/robot_name.h"
#include "tests/support/temporary_folder.h"

namespace robosim::launch::launch_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// Provides image files for both emulated chips, so that no test compiles a sketch.
class LaunchTest : public ::testing::Test {
 protected:
  LaunchTest() {
    for (const auto& [name, machine] : {std::pair{"uno.elf", 83}, std::pair{"pill.elf", 40}}) {
      std::string header(60, '\0');
      header.replace(0, 7, "\177ELF\1\1\1");
      header[18] = static_cast<char>(machine);
      write_file(folder_.path() / name, header);
    }
  }
  Launch launch_of(const std::string& file) const {
    Launch launch;
    launch.sketch = (folder_.path() / file).string();
    return launch;
  }
  Prepared prepare(const Launch& launch) {
    Launcher launcher({[this](const std::string& sentence) { told_.push_back(sentence); }, {}, {}, {}});
    return launcher.prepare(launch, choose(launch), describe, {});
  }
  /// Describes bluepill5 as a Blue Pill, and any other robot as an Uno. A board in the robot's name has
  /// priority.
  static wire::RobotInfo describe(const std::string& robot) {
    const std::string board = parse_robot_name(robot).board;
    wire::RobotInfo info;
    info.name = robot;
    info.board.name = !board.empty() ? board : robot == "bluepill5" ? "bluepill" : "uno";
    return info;
  }

  test::TemporaryFolder folder_;
  std::vector<std::string> told_;
};

TEST_F(LaunchTest, ChoosesWhatIsNotNamedAndTellsIt) {
  const Prepared run = prepare(launch_of("uno.elf"));
  EXPECT_EQ(run.target, "avr") << "the target that the image is for";
  EXPECT_EQ(run.map.name, "oval");
  EXPECT_EQ(run.robot.name, "uno5");
  EXPECT_THAT(told_, ElementsAre(HasSubstr("the map is oval"), HasSubstr("the robot is uno5")));
  EXPECT_EQ(prepare(launch_of("pill.elf")).robot.name, "bluepill5");
}

TEST_F(LaunchTest, AsksForTheFilesAndForAllElseThatWasNamed) {
  Launch launch = launch_of("uno.elf");
  launch.map = "d";
  launch.robot = "uno3";
  launch.request.goal = "laps:2";
  launch.request.seed = 7;
  const Prepared run = prepare(launch);
  EXPECT_EQ(run.request.image, launch.sketch);
  EXPECT_THAT(run.request.map, ::testing::EndsWith("maps/d.map"));
  EXPECT_EQ(run.request.robot, "uno3");
  EXPECT_EQ(run.request.goal, "laps:2");
  EXPECT_EQ(run.request.seed, 7u);
  EXPECT_EQ(run.request.profile, "typical");
  EXPECT_TRUE(told_.empty());
}

TEST_F(LaunchTest, PutsABoardOfTheTargetOnARobotThatWasNamed) {
  Launch launch = launch_of("pill.elf");
  launch.robot = "uno3";
  const Prepared run = prepare(launch);
  EXPECT_EQ(run.robot.name, "uno3@bluepill");
  EXPECT_EQ(run.request.robot, "uno3@bluepill");
  EXPECT_STREQ(run.wanted.board.name, "bluepill");
  EXPECT_THAT(told_.back(), HasSubstr("the robot is uno3@bluepill"));
}

TEST_F(LaunchTest, RefusesATargetThatAFinishedImageIsNotFor) {
  Launch launch = launch_of("uno.elf");
  for (const char* target : {"host", "stm32", "mars"}) {
    launch.target = target;
    EXPECT_THROW(choose(launch), InputError) << target;
  }
  launch.target = "avr";
  EXPECT_EQ(choose(launch).target, "avr");
}

TEST_F(LaunchTest, TellsOfSeveralRunsOnceWhatTheyShare) {
  Launcher launcher({[this](const std::string& sentence) { told_.push_back(sentence); }, {}, {}, {}});
  const Launch launch = launch_of("uno.elf");
  for (int i = 0; i < 3; ++i) launcher.prepare(launch, choose(launch), describe, {});
  EXPECT_EQ(told_.size(), 2u);
}

TEST_F(LaunchTest, SaysOfWhatNeedsTheChipThatItCompilesThere) {
  if (!build::missing_tool("host").empty() || !build::missing_tool("avr").empty()) GTEST_SKIP();
  test::use_shared_cache();
  const auto error_of = [this](const std::string& code) {
    write_file(folder_.path() / "needy.cpp", "#include <Arduino.h>\n" + code + "void loop() {}\n");
    try {
      prepare(launch_of("needy.cpp"));
    } catch (const build::CompileError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_THAT(
      error_of("void setup() { asm volatile(\"wdr\"); }\n"),
      ::testing::AllOf(HasSubstr("asm() contains assembler of the chip"), HasSubstr("add --target avr")));
  EXPECT_THAT(error_of("void setup() { missing(); }\n"),
              ::testing::AllOf(HasSubstr("missing"), ::testing::Not(HasSubstr("--target avr"))));
}

}  // namespace robosim::launch::launch_test
