#include "sim/launch/names.h"

#include <gmock/gmock.h>

#include <fstream>

#include "sim/base/error.h"
#include "tests/support/temporary_folder.h"

namespace robosim::launch::names_test {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class NamesTest : public ::testing::Test {
 protected:
  NamesTest() { fs::current_path(folder_); }
  ~NamesTest() override { fs::current_path(before_); }
  void touch(const std::string& name) const {
    fs::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name) << "";
  }
  template <typename Choose>
  static std::string refusal(Choose choose) {
    try {
      choose();
    } catch (const std::exception& error) {
      return error.what();
    }
    return "";
  }
  const test::TemporaryFolder temporary_;
  const fs::path folder_ = temporary_.path(), before_ = fs::current_path();
};

TEST_F(NamesTest, ASketchWithoutANameIsTheCurrentFolder) {
  EXPECT_THAT(refusal([] { choose_sketch(""); }), HasSubstr("has no sketch"));
  touch("My.ino");
  const SketchChoice choice = choose_sketch("");
  EXPECT_EQ(choice.name, ".");
  EXPECT_TRUE(fs::equivalent(choice.folder, folder_));
}

TEST_F(NamesTest, OfTheCurrentFolderPeopleAreShownItsName) {
  touch("My/My.ino");
  EXPECT_EQ(title_of(choose_sketch("./My")), "./My");
  EXPECT_EQ(title_of(choose_sketch("PidFollower")), "PidFollower");
  fs::current_path(folder_ / "My");
  EXPECT_EQ(title_of(choose_sketch("")), "My");
  EXPECT_EQ(title_of(choose_sketch("./")), "My");
}

TEST_F(NamesTest, ASketchsFileStandsInItsFolder) {
  touch("My/My.ino");
  EXPECT_EQ(choose_sketch("My/My.ino").folder, "My");
  EXPECT_EQ(choose_sketch("./My").folder, "./My");
  EXPECT_EQ(choose_sketch("My/My.ino").name, "My/My.ino");
}

TEST_F(NamesTest, ASketchOfOursIsFoundByName) {
  EXPECT_TRUE(fs::exists(choose_sketch("PidFollower").path));
  EXPECT_THAT(refusal([] { choose_sketch("PidFolower"); }), HasSubstr("did you mean PidFollower?"));
  EXPECT_THAT(refusal([] { choose_sketch("no/such"); }), HasSubstr("no/such: no such file"));
}

TEST_F(NamesTest, ABareWordNamesAFolderHereBeforeASketchOfRobosim) {
  touch("Mine/Mine.ino");
  touch("PidFollower/PidFollower.ino");
  EXPECT_EQ(choose_sketch("Mine").path, "Mine");
  EXPECT_EQ(choose_sketch("Mine").folder, "Mine");
  const SketchChoice hiding = choose_sketch("PidFollower");
  EXPECT_EQ(hiding.path, "PidFollower");
  EXPECT_THAT(remarks_on_project(hiding, {}), ElementsAre(HasSubstr("not the sample sketch")));
  EXPECT_THAT(remarks_on_project(choose_sketch("./PidFollower"), {}), IsEmpty());
  EXPECT_THAT(refusal([] { choose_sketch("Mime"); }),
              HasSubstr("'Mime' is neither a folder here nor a sketch of Robosim; there are "));
}

TEST_F(NamesTest, AFileWithoutItsEndingIsShownWithIt) {
  touch("yard.map");
  touch("mine.toml");
  touch("Mine");
  EXPECT_THAT(refusal([] { choose_map("yard", "."); }),
              HasSubstr("to use the file in this folder, give yard.map"));
  EXPECT_THAT(refusal([] { choose_robot("mine", "."); }),
              HasSubstr("to use the file in this folder, give mine.toml"));
  EXPECT_THAT(refusal([] { choose_sketch("Mine"); }), HasSubstr("to use the file here, give ./Mine"));
}

TEST_F(NamesTest, AnElfSaysWhichTargetItIsFor) {
  std::string header(64, '\0');
  header.replace(0, 7, "\177ELF\1\1\1");
  header[18] = 83;
  std::ofstream(folder_ / "a.elf") << header;
  EXPECT_EQ(choose_sketch("./a.elf").elf_target, "avr");
  header[18] = 40;
  std::ofstream(folder_ / "a.elf") << header;
  EXPECT_EQ(choose_sketch("./a.elf").elf_target, "stm32");
  std::ofstream(folder_ / "a.elf") << "not an ELF";
  EXPECT_THROW(choose_sketch("./a.elf"), InputError);
  EXPECT_THROW(choose_sketch("./none.elf"), InputError);
}

TEST_F(NamesTest, TheOnlyMapBesideTheSketchIsTaken) {
  EXPECT_EQ(choose_map("", folder_).name, "oval");
  EXPECT_THAT(choose_map("", folder_).announcement, HasSubstr("the map is oval"));
  touch("a.map");
  const Choice one = choose_map("", folder_);
  EXPECT_EQ(one.name, "a.map");
  EXPECT_EQ(one.path, folder_ / "a.map");
  EXPECT_THAT(one.announcement, HasSubstr("a.map"));
  touch("b.map");
  EXPECT_EQ(choose_map("", folder_).name, "oval");
  EXPECT_THAT(choose_map("", folder_).announcement, HasSubstr("2 maps"));
}

TEST_F(NamesTest, WhatALinkerCallsAMapIsNone) {
  std::ofstream(folder_ / "sketch.map") << "Archive member included to satisfy reference by file (symbol)\n";
  EXPECT_EQ(choose_map("", folder_).name, "oval");
  std::ofstream(folder_ / "other.map") << "\nMemory Configuration\n";
  touch("mine.map");
  EXPECT_EQ(choose_map("", folder_).name, "mine.map");
}

TEST_F(NamesTest, AMapThatIsNamedIsNotAnnounced) {
  touch("a.map");
  EXPECT_EQ(choose_map("d", folder_).announcement, "");
  EXPECT_TRUE(fs::exists(choose_map("d", folder_).path));
  EXPECT_EQ(choose_map("./a.map", folder_).name, "./a.map");
  EXPECT_THAT(refusal([&] { choose_map("ovla", folder_); }), HasSubstr("did you mean oval?"));
  EXPECT_THAT(refusal([&] { choose_map("x.map", folder_); }), HasSubstr("x.map: no such file"));
}

TEST_F(NamesTest, TheRobotBesideTheSketchComesBeforeUno5) {
  EXPECT_EQ(choose_robot("", folder_).name, "uno5");
  EXPECT_EQ(choose_robot("", folder_, "stm32").name, "bluepill5");
  touch("robot.toml");
  EXPECT_EQ(choose_robot("", folder_).name, "robot.toml");
  EXPECT_EQ(choose_robot("", folder_).path, folder_ / "robot.toml");
  EXPECT_NE(choose_robot("", folder_).announcement, "");
  EXPECT_EQ(choose_robot("uno3", folder_).name, "uno3");
  EXPECT_EQ(choose_robot("uno3", folder_).announcement, "");
  EXPECT_THAT(refusal([&] { choose_robot("uno55", folder_); }), HasSubstr("did you mean uno5?"));
}

TEST_F(NamesTest, ARobotMayBeNamedWithAnotherBoard) {
  EXPECT_EQ(choose_robot("uno3@bluepill", folder_).path, "uno3@bluepill");
  touch("robot.toml");
  const std::string file = (folder_ / "robot.toml").string();
  EXPECT_EQ(choose_robot(file + "@bluepill", folder_).path, file + "@bluepill");
  EXPECT_THAT(refusal([&] { choose_robot("uno55@bluepill", folder_); }), HasSubstr("did you mean uno5?"));
  EXPECT_THAT(refusal([&] { choose_robot("./none.toml@bluepill", folder_); }),
              HasSubstr("./none.toml: no such file"));
}

TEST(Target, SketchesAreCompiledForAllThree) {
  EXPECT_NO_THROW(check_build_target("host"));
  EXPECT_NO_THROW(check_build_target("avr"));
  EXPECT_NO_THROW(check_build_target("stm32"));
  EXPECT_THROW(check_build_target("mars"), InputError);
}

TEST(Target, SketchesRunOnAllThree) {
  EXPECT_NO_THROW(check_target("host"));
  EXPECT_NO_THROW(check_target("avr"));
  EXPECT_NO_THROW(check_target("stm32"));
  EXPECT_THROW(check_target("mars"), InputError);
}

}  // namespace robosim::launch::names_test
