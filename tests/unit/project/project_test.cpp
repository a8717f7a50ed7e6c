#include "sim/build/project/project.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include <fstream>

#include "sim/build/project/board_names.h"
#include "tests/support/temporary_folder.h"

namespace robosim::project {
namespace project_test {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class ProjectTest : public ::testing::Test {
 protected:
  ProjectTest() {
    ::setenv("HOME", folder_.c_str(), 1);
    ::unsetenv("ARDUINO_DIRECTORIES_USER");
  }

  void write(const std::string& name, const std::string& text) const {
    fs::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name) << text;
  }
  Project platformio(const std::string& ini, const std::string& environment = "") const {
    write("platformio.ini", ini);
    fs::create_directories(folder_ / "src");
    return read_project(folder_, environment);
  }
  Project sketch_yaml(const std::string& yaml, const std::string& profile = "") const {
    write("sketch.yaml", yaml);
    return read_project(folder_, profile);
  }
  template <typename Read>
  std::string refusal(Read read) const {
    try {
      read();
    } catch (const InputError& error) {
      return error.what();
    }
    return "nothing was refused";
  }

  const test::TemporaryFolder temporary_;
  const fs::path folder_ = temporary_.path();
};

std::string board(const BoardSpec* found) { return found ? found->name : "none"; }

TEST(BoardNames, AnFqbnNamesTheBoardWhateverOptionsItHas) {
  EXPECT_EQ(board(board_of_fqbn("arduino:avr:uno")), "uno");
  EXPECT_EQ(board(board_of_fqbn("arduino:avr:nano:cpu=atmega328old")), "nano");
  EXPECT_EQ(board(board_of_fqbn("arduino:avr:nano:cpu=atmega168")), "nano168");
  EXPECT_EQ(board(board_of_fqbn("arduino:avr:mega:cpu=atmega2560")), "mega");
  EXPECT_EQ(board(board_of_fqbn("arduino:avr:pro")), "promini16") << "Arduino's default";
  EXPECT_EQ(board(board_of_fqbn("arduino:avr:pro:cpu=8MHzatmega328")), "promini8");
  EXPECT_EQ(board(board_of_fqbn("STMicroelectronics:stm32:GenF1:pnum=BLUEPILL_F103C8,usb=none")), "bluepill");
}

TEST(BoardNames, AnFqbnOfAnotherChipNamesNone) {
  EXPECT_EQ(board(board_of_fqbn("arduino:avr:mega:cpu=atmega1280")), "none");
  EXPECT_EQ(board(board_of_fqbn("arduino:avr:pro:cpu=8MHzatmega168")), "none");
  EXPECT_EQ(board(board_of_fqbn("ATTinyCore:avr:attinyx5:chip=45")), "none");
  EXPECT_EQ(board(board_of_fqbn("STMicroelectronics:stm32:GenF1:pnum=MAPLEMINI_F103CB")), "none");
  EXPECT_EQ(board(board_of_fqbn("esp32:esp32:esp32")), "none");
  EXPECT_EQ(board(board_of_fqbn("uno")), "none");
  EXPECT_EQ(board(board_of_fqbn("")), "none");
}

TEST(BoardNames, AnotherBoardWithTheChipAndTheClockStandsIn) {
  EXPECT_EQ(board(board_with_chip("atmega328p", "MiniCore:avr:328:bootloader=uart0,clock=16MHz_external")),
            "uno");
  EXPECT_EQ(board(board_with_chip("atmega328", "MiniCore:avr:328")), "uno")
      << "this chip has the same registers";
  EXPECT_EQ(board(board_with_chip("atmega328p", "MiniCore:avr:328:clock=8MHz_internal")), "promini8");
  EXPECT_EQ(board(board_with_chip("atmega328p", "MiniCore:avr:328:clock=20MHz_external")), "none");
  EXPECT_EQ(board(board_with_chip("atmega2560", "MegaCore:avr:2560:clock=16MHz_external")), "mega");
  EXPECT_EQ(board(board_with_chip("atmega1284p", "MightyCore:avr:1284")), "none");
  EXPECT_EQ(board(board_with_chip("", "MiniCore:avr:328")), "none") << "the file names no chip";
}

TEST_F(ProjectTest, AStandInIsRemarkedOnceItIsNeeded) {
  Project project;
  project.file = "x/build.options.json";
  project.board_name = "MiniCore:avr:328";
  EXPECT_THAT(refusal([&] { check_board(project); }), HasSubstr("unknown board MiniCore:avr:328"));
  find_stand_in(project, "atmega1284p");
  EXPECT_THAT(project.remarks, IsEmpty());
  EXPECT_THROW(check_board(project), InputError);
  find_stand_in(project, "atmega328p");
  EXPECT_THAT(
      project.remarks,
      ElementsAre("build.options.json names the board MiniCore:avr:328, which Robosim does not have: the "
                  "program is for an ATmega328P at 16 MHz, as on the uno"));
  EXPECT_NO_THROW(check_board(project));
}

TEST(BoardNames, PlatformioMayHaveSeveralNamesForABoard) {
  EXPECT_EQ(board(board_of_platformio("nanoatmega328")), "nano");
  EXPECT_EQ(board(board_of_platformio("nanoatmega328new")), "nano");
  EXPECT_EQ(board(board_of_platformio("esp32dev")), "none");
  EXPECT_EQ(board(board_of_platformio("")), "none");
}

TEST_F(ProjectTest, ValuesOfPlatformioMayStandInOtherSections) {
  fs::create_directories(folder_ / "more");
  const Project project = platformio(R"(; made by hand
[common]
speed = 120   ; of 255
flags = -D SPEED=${common.speed}
    -DNAME=\"a b\"
# -DOLD
[base]
board = uno
[env]
framework = arduino
build_flags = ${common.flags} -I more
[env:mine]
extends = base
build_flags =
  ${env.build_flags}
  -DENV=${this.__env__} -Wall
  -std=gnu++17
)");
  EXPECT_EQ(board(project.board), "uno");
  EXPECT_EQ(project.environment, "mine");
  EXPECT_THAT(project.flags, ElementsAre("-DSPEED=120", "-DNAME=\"a", "-DENV=mine"));
  EXPECT_THAT(project.includes, ElementsAre(folder_ / "more"));
  EXPECT_THAT(project.remarks,
              ElementsAre("only -D, -U and -I of build_flags are used; ignored: b\" -std=gnu++17"));
}

TEST_F(ProjectTest, OptionsThatNameProgramsOrFilesAreNotTaken) {
  for (const char* option : {"-include",
                             "-imacros",
                             "-fplugin=evil.so",
                             "-B.",
                             "-specs=evil",
                             "--specs=evil",
                             "-wrapper",
                             "@evil",
                             "-x",
                             "-isystem",
                             "-iquote",
                             "-idirafter",
                             "-iprefix",
                             "-dumpbase",
                             "-o",
                             "--sysroot=/",
                             "-T",
                             "-Xlinker",
                             "-fprofile-use=evil",
                             "-D-fplugin=evil.so",
                             "-D@evil",
                             "-D1",
                             "-D",
                             "-U=",
                             "'-DA=1\n  x'",
                             "evil.cpp",
                             "'-DA B=1'"}) {
    const Project project = platformio(std::string("[env:a]\nboard = uno\nbuild_flags = ") + option + "\n");
    EXPECT_THAT(project.flags, IsEmpty()) << option;
    EXPECT_THAT(project.includes, IsEmpty()) << option;
    EXPECT_EQ(project.remarks.size(), 1u) << option;
  }
  EXPECT_THAT(
      platformio("[env:a]\nboard = uno\nbuild_flags = -Wl,-T,evil -Wp,-include,evil -Ofast -g3\n").flags,
      IsEmpty());
  EXPECT_THAT(platformio("[env:a]\nboard = uno\nbuild_flags = -DF(x)=x '-DA=\"a b\"' -D B -UC\n").flags,
              ElementsAre("-DF(x)=x", "-DA=\"a b\"", "-DB", "-UC"));
}

TEST_F(ProjectTest, TheEnvironmentIsTheOneNamedElseTheDefaultElseTheFirstOfAKnownBoard) {
  const std::string ini = "[env:esp]\nboard = esp32dev\n[env:a]\nboard = uno\n[env:b]\nboard = leonardo\n";
  EXPECT_EQ(platformio(ini).environment, "a");
  EXPECT_THAT(platformio(ini).remarks,
              ElementsAre("a, one of 3 environments in platformio.ini, is used; choose another with --env"));
  EXPECT_EQ(platformio("[platformio]\ndefault_envs = esp, b\n" + ini).environment, "b");
  EXPECT_EQ(board(platformio(ini, "b").board), "leonardo");
  EXPECT_THAT(refusal([&] { platformio(ini, "c"); }), HasSubstr("--env: there is no environment “c”"));
  EXPECT_THAT(refusal([&] { platformio("[platformio]\ndefault_envs = x\n" + ini); }),
              HasSubstr("default_envs: no such section [env:x]"));
}

TEST_F(ProjectTest, ABoardThatRobosimDoesNotHaveIsNamedWithItsPlaceAndTheOnesThereAre) {
  const Project project = platformio("[env:esp]\nboard = esp32dev\n");
  EXPECT_THAT(refusal([&] { check_board(project); }),
              AllOf(HasSubstr("platformio.ini:2: unknown board esp32dev"), HasSubstr("uno, nanoatmega328new"),
                    HasSubstr("--robot uno5@nano")));
  check_board(platformio("[env:uno]\nboard = uno\n"));
}

TEST_F(ProjectTest, PlatformiosFoldersOfLibrariesAreTakenWhereTheyAre) {
  for (const char* name : {"lib", ".pio/libdeps/uno", ".pio/libdeps/other", "shared"})
    fs::create_directories(folder_ / name);
  const Project project =
      platformio("[env:uno]\nboard = uno\nlib_deps = Servo\nlib_extra_dirs = shared, gone\n");
  EXPECT_THAT(project.libraries,
              ElementsAre(folder_ / "lib", folder_ / ".pio/libdeps/uno", folder_ / "shared"));
  EXPECT_THAT(project.remarks, IsEmpty());
  fs::remove_all(folder_ / ".pio");
  EXPECT_THAT(platformio("[env:uno]\nboard = uno\nlib_deps = Servo\n").remarks,
              ElementsAre(HasSubstr("lib_deps names Servo, but .pio/libdeps/uno does not exist yet")));
}

TEST_F(ProjectTest, WhatPlatformioWouldRefuseIsRefusedWithItsLine) {
  EXPECT_THAT(
      refusal([&] { platformio("[env:a]\nboard uno\n"); }),
      HasSubstr("platformio.ini:2: a line without =: expected [SECTION] or KEY = VALUE, got “board uno”"));
  EXPECT_THAT(refusal([&] { platformio("board = uno\n"); }), HasSubstr("a line before the first section"));
  EXPECT_THAT(refusal([&] { platformio("[platformio]\n"); }), HasSubstr("the file has no environment"));
  EXPECT_THAT(refusal([&] { platformio("[env:a]\nextends = env:a\n"); }), HasSubstr("in a circle"));
  EXPECT_THAT(refusal([&] { platformio("[env:a]\nboard = ${env:a.board}\n"); }),
              HasSubstr("refers to itself"));
  std::string many = "[env:a]\nboard = uno\nbuild_flags = ${this.a1}\n";
  for (int level = 1; level < 15; ++level) {
    many += "a" + std::to_string(level) + " =";
    for (int i = 0; i < 10; ++i) many += " ${this.a" + std::to_string(level + 1) + "}";
    many += "\n";
  }
  EXPECT_THAT(refusal([&] { platformio(many + "a15 =\n"); }), HasSubstr("too many ${…}"));
  EXPECT_THAT(refusal([&] { platformio("[env:a]\nboard = uno\nframework = mbed\n"); }),
              HasSubstr("platformio.ini:3: framework: expected arduino, got mbed"));
}

TEST_F(ProjectTest, AProfileSaysBoardAndLibraries) {
  const Project project = sketch_yaml(R"(profiles:
  uno:
    fqbn: arduino:avr:uno
    libraries:
      - Servo (1.2.1)
      - PID
      - dir: libs/Mine
  mega: {fqbn: "arduino:avr:mega"}
default_profile: uno
)");
  EXPECT_EQ(project.environment, "uno");
  EXPECT_EQ(board(project.board), "uno");
  ASSERT_EQ(project.wanted.size(), 2u);
  EXPECT_EQ(project.wanted[0].name, "Servo");
  EXPECT_EQ(project.wanted[0].version, "1.2.1");
  EXPECT_EQ(project.wanted[1].version, "");
  EXPECT_THAT(project.libraries, ElementsAre(folder_ / "libs/Mine"));
  EXPECT_EQ(board(read_project(folder_, "mega").board), "mega");
  EXPECT_THAT(refusal([&] { read_project(folder_, "nano"); }),
              HasSubstr("--env: there is no profile “nano”"));
}

TEST_F(ProjectTest, ASketchWithoutProfilesMayStillSayItsBoard) {
  EXPECT_EQ(board(sketch_yaml("default_fqbn: arduino:avr:leonardo\n").board), "leonardo");
  EXPECT_EQ(board(sketch_yaml("default_port: /dev/ttyACM0\n").board), "none");
  EXPECT_EQ(board(sketch_yaml("").board), "none");
  EXPECT_THAT(refusal([&] { sketch_yaml("a: [1\nb: 2\n"); }), HasSubstr("sketch.yaml:"));
  EXPECT_THAT(refusal([&] { sketch_yaml("default_profile: x\n"); }),
              HasSubstr("default_profile: no such profile x"));
}

TEST_F(ProjectTest, SectionsThatExtendEachOtherInManyWaysAreLookedThroughOnce) {
  std::string ini = "[env:a]\nboard = uno\nextends = s0, s0, s0, s0, s0, s0, s0, s0, s0, s0\n[s14]\n";
  for (int i = 0; i < 14; ++i) {
    const std::string next = "s" + std::to_string(i + 1);
    ini += "[s" + std::to_string(i) + "]\nextends = " + next;
    for (int k = 0; k < 9; ++k) ini += ", " + next;
    ini += "\n";
  }
  EXPECT_EQ(board(platformio(ini).board), "uno");
}

TEST_F(ProjectTest, NothingOfThisMachinesEnvironmentReachesASketch) {
  ::setenv("ROBOSIM_SECRET", "hunter2", 1);
  const Project project = platformio("[env:a]\nboard = uno\nbuild_flags = -DA=${sysenv.ROBOSIM_SECRET}\n");
  EXPECT_THAT(project.flags, ElementsAre("-DA=${sysenv.ROBOSIM_SECRET}"));
}

TEST_F(ProjectTest, NestingHasALimitForItsTimeGrowsWithTheSquare) {
  EXPECT_THAT(refusal([&] { sketch_yaml("default_fqbn: arduino:avr:uno\na: " + std::string(200'000, '[')); }),
              HasSubstr("sketch.yaml:2: the YAML is nested too deeply: expected at most 64 levels"));
  EXPECT_EQ(board(sketch_yaml("default_fqbn: arduino:avr:uno\na: " + std::string(60, '[') +
                              std::string(60, ']') + "\n")
                      .board),
            "uno");
}

TEST_F(ProjectTest, AnchorsThatStandForEachOtherAMillionTimesCostNothing) {
  std::string yaml = "a0: &a0 [x, x, x, x, x, x, x, x, x, x]\n";
  for (int i = 1; i < 30; ++i) {
    const std::string last = "*a" + std::to_string(i - 1);
    yaml += "a" + std::to_string(i) + ": &a" + std::to_string(i) + " [" + last + ", " + last + ", " + last +
            "]\n";
  }
  EXPECT_EQ(board(sketch_yaml(yaml + "default_fqbn: arduino:avr:uno\n").board), "uno");
}

TEST_F(ProjectTest, AFolderWithoutSuchFilesHasNoEnvironment) {
  EXPECT_TRUE(read_project(folder_).file.empty());
  EXPECT_THAT(refusal([&] { read_project(folder_, "uno"); }),
              HasSubstr("--env requires a platformio.ini with environments or a sketch.yaml"));
}

TEST_F(ProjectTest, WhatArduinoCliOrPlatformioHaveBuiltKnowsItsBoardAndItsSketch) {
  write("build/arduino.avr.mega/My.ino.elf", "");
  EXPECT_EQ(board(project_of_image(folder_ / "build/arduino.avr.mega/My.ino.elf").board), "mega");
  EXPECT_EQ(sketch_of_image(folder_ / "build/arduino.avr.mega/My.ino.elf"), folder_);
  write("tmp/build.options.json",
        R"({"fqbn": "arduino:avr:leonardo", "sketchLocation": ")" + (folder_ / "My").string() + "\"}");
  EXPECT_EQ(board(project_of_image(folder_ / "tmp/My.ino.elf").board), "leonardo");
  EXPECT_EQ(sketch_of_image(folder_ / "tmp/My.ino.elf"), "") << "the sketch is gone";
  platformio("[env:n]\nboard = nanoatmega328\n");
  EXPECT_EQ(board(project_of_image(folder_ / ".pio/build/n/firmware.elf").board), "nano");
  EXPECT_EQ(sketch_of_image(folder_ / ".pio/build/n/firmware.elf"), folder_);
  EXPECT_TRUE(project_of_image(folder_ / "some/other.elf").file.empty());
}

TEST_F(ProjectTest, SketchbooksAreThoseOfTheIdeAndOfArduinoCli) {
  EXPECT_THAT(sketchbooks(), IsEmpty());
  write(".arduino15/preferences.txt", "a=b\nsketchbook.path=/home/me/book\n");
  write(".arduino15/arduino-cli.yaml", "directories:\n  data: /x\n  user: /home/me/cli\n");
  write(".arduinoIDE/arduino-cli.yaml", "directories:\n  user: /home/me/ide\n");
  EXPECT_THAT(sketchbooks(), ElementsAre("/home/me/book", "/home/me/cli", "/home/me/ide"));
}

}  // namespace project_test
}  // namespace robosim::project
