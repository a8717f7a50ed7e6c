#include "sim/cli/files/build_command.h"

#include <gmock/gmock.h>

#include "sim/base/file.h"
#include "tests/support/temporary_folder.h"

namespace robosim::cli::build_command_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

// A fixture with the result of a build, whose image file is not an ELF file.
class BuildReport : public ::testing::Test {
 protected:
  BuildReport() {
    image_.name = "My";
    image_.image = folder_.path() / "My-0123.elf";
    write_file(image_.image, "no ELF");
    image_.compiler = "gcc 5.4.0 avr";
    image_.libraries = {"LineKit", "EEPROM"};
    image_.text_bytes = 5480;
    image_.data_bytes = 165;
    robot_.name = "uno5";
  }

  test::TemporaryFolder folder_;
  build::Image image_;
  wire::RobotInfo robot_;
};

TEST_F(BuildReport, SaysTheSizesForAChipAsArduinoDoes) {
  EXPECT_EQ(size_report(image_, "avr", *find_board("uno"), {"out/My.elf", "out/My.hex"}),
            "My for the uno (gcc 5.4.0 avr)\n"
            "Sketch uses 5480 bytes (16%) of program storage space. Maximum is 32256 bytes.\n"
            "Global variables use 165 bytes (8%) of dynamic memory, leaving 1883 bytes for local variables. "
            "Maximum is 2048 bytes.\n"
            "libraries: LineKit, EEPROM\n"
            "image: out/My.elf\n"
            "hex: out/My.hex\n");
}

TEST_F(BuildReport, WarnsAsArduinoDoesWhereLittleIsLeftForTheStack) {
  const auto report = [&](std::uint64_t data_bytes) {
    image_.data_bytes = data_bytes;
    return size_report(image_, "avr", *find_board("uno"), {});
  };
  EXPECT_THAT(report(1536), Not(HasSubstr("Low memory")));
  EXPECT_THAT(report(1537), HasSubstr("bytes.\nLow memory available, stability problems may occur.\n"));
}

TEST_F(BuildReport, NamesTheChipsRoomAfterTheSizesOnTheHost) {
  EXPECT_THAT(size_report(image_, "host", *find_board("nano"), {image_.image}),
              HasSubstr("the nano's 30720 bytes of flash and 2048 bytes of RAM"));
}

TEST_F(BuildReport, SaysHowFarTheRobotsBudgetAllows) {
  EXPECT_THAT(over_budget(image_, robot_), IsEmpty());
  robot_.budget = {5480, 165};
  EXPECT_THAT(over_budget(image_, robot_), IsEmpty());
  robot_.budget = {5479, 164};
  EXPECT_THAT(
      over_budget(image_, robot_),
      ElementsAre(
          "My is over the budget: it uses 5480 bytes of flash, and the robot uno5 allows 5479",
          "My is over the budget: it uses 165 bytes of RAM for variables, and the robot uno5 allows 164"));
}

}  // namespace robosim::cli::build_command_test
