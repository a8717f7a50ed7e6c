// Tests the messages for sketches that do not compile or link.
#include <gmock/gmock.h>

#include "tests/unit/build/fixture.h"

namespace robosim::build {
namespace errors_test {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::ContainsRegex;
using testing::EndsWith;
using testing::HasSubstr;
using testing::MatchesRegex;
using testing::Not;
using testing::StartsWith;

TEST_F(SketchTest, ACompileErrorNamesTheInoAndItsLineAndNothingOfTheMachine) {
  write("Wrong/Wrong.ino", "int before() { return 1; }\nvoid setup() {\n  int x = \n}\nvoid loop() {}\n");
  const std::string error = error_of("Wrong");
  EXPECT_THAT(error, AllOf(StartsWith("Wrong.ino:4:1: error: "), Not(HasSubstr(folder_.string())),
                           Not(HasSubstr(cache_folder().string())), Not(HasSubstr("stdin"))));
  try {
    build_here("Wrong");
    FAIL() << "it compiles";
  } catch (const CompileError& compile_error) {
    EXPECT_EQ(compile_error.place().file, "Wrong.ino");
    EXPECT_EQ(compile_error.place().line, 4);
    EXPECT_EQ(compile_error.place().column, 1);
  }
}

TEST_F(SketchTest, AnErrorInATabNamesTheTab) {
  write("Tabs/Tabs.ino", kEmptySketch);
  write("Tabs/more.ino", "\nvoid more() { undeclared(3); }\n");
  EXPECT_THAT(error_of("Tabs"), StartsWith("more.ino:2:15: error: 'undeclared' was not declared"));
}

TEST_F(SketchTest, AnErrorInASourceOrHeaderNamesIt) {
  write("Parts/Parts.ino", "#include \"part.h\"\n" + kEmptySketch);
  write("Parts/part.h", "#pragma once\nint part(;\n");
  EXPECT_THAT(error_of("Parts"), StartsWith("part.h:2:10: error: "));
  write("Parts/part.h", "#pragma once\n");
  write("Parts/src/deep.cpp", "int deep() { return x; }\n");
  EXPECT_THAT(error_of("Parts"), StartsWith("src/deep.cpp:1:21: error: "));
}

TEST_F(SketchTest, AMessageAboutTheCoreSaysNotWhereThisMachineKeepsIt) {
  write("Core/Core.ino", "struct P : Print {};\nP p;\n" + kEmptySketch);
  EXPECT_THAT(error_of("Core"),
              AllOf(StartsWith("Core.ino:2:3: error: "), HasSubstr("\nPrint.h:"),
                    Not(HasSubstr(cache_folder().string())), Not(HasSubstr(data_folder().string()))));
}

TEST_F(SketchTest, AMissingHeaderIsNamedWithWhereItWasLookedFor) {
  write("Needy/Needy.ino", "// needs more\n#include <NoSuchSensor.h>\n" + kEmptySketch);
  EXPECT_THAT(error_of("Needy", {folder_}),
              AllOf(StartsWith("Needy.ino:2:10: no such header NoSuchSensor.h in the sketch, nor"),
                    HasSubstr(folder_.string()), HasSubstr("home/Arduino/libraries")));
  EXPECT_THROW(build({folder_ / "Needy", *find_board("uno")}), MissingLibrary)
      << "the library may be elsewhere";
}

TEST_F(SketchTest, PartsOfTheChipThatTheHostHasNotAreToldApartToo) {
  write("Boot/Boot.ino", "#include <avr/boot.h>\n" + kEmptySketch);
  EXPECT_THAT(error_of("Boot"), StartsWith("Boot.ino:1:10: avr/boot.h belongs to avr-libc"));
  write("Boot/Boot.ino", "#include <vector>\n" + kEmptySketch);
  EXPECT_THAT(error_of("Boot"),
              StartsWith("Boot.ino:1:10: no such header vector: Arduino boards with an AVR"));
  write("Boot/Boot.ino", "void setup() { asm volatile(\"wdr\"); }\nvoid loop() {}\n");
  EXPECT_THAT(error_of("Boot"), AllOf(StartsWith("Boot.ino:1: asm() contains assembler of the chip ("),
                                      HasSubstr(" `wdr'"), EndsWith("); build for the target avr")));
  write("Boot/Boot.ino", "asm(\"wdr\");\n" + kEmptySketch);
  EXPECT_THAT(error_of("Boot"),
              AllOf(StartsWith("asm() contains assembler of the chip ("), HasSubstr(" `wdr'")))
      << "gcc notes no line for asm() outside of a function";
}

TEST_F(SketchTest, AChangeOfOursThatTheAssemblerRefusesIsNotTheSketchsFault) {
  write("Empty/Empty.ino", kEmptySketch);
  const std::string compiler = build_here("Empty").compiler;  // such as "gcc 12.2.0 x86_64-linux-gnu"
  const std::string gcc = compiler.substr(compiler.rfind(' ') + 1) + "-gcc";
  // Simulates a later assembler, which rejects the output of changed_for_host().
  const fs::path later = write("Divides/bin/" + gcc,
                               "#!/bin/sh\nfor file; do :; done\n"
                               "if grep -q '^.Lrobosim_divides' \"$file\"; then\n"
                               "  echo \"$file:7: Error: no such instruction\"; exit 1\nfi\n"
                               "exec /usr/bin/" +
                                   gcc + " \"$@\"\n");
  fs::permissions(later, fs::perms::owner_all);
  ::setenv("PATH", (later.parent_path().string() + ":" + ::getenv("PATH")).c_str(), 1);
  write("Divides/Divides.ino", "volatile int n;\nvoid setup() { n = 5 / n; }\nvoid loop() {}\n");
  try {
    build_here("Divides");
    FAIL() << "it compiles";
  } catch (const InputError& error) {
    FAIL() << "the sketch is blamed: " << error.what();
  } catch (const std::runtime_error& error) {
    const fs::path saved = cache_folder() / "refused.s";
    EXPECT_THAT(
        error.what(),
        AllOf(MatchesRegex("as [0-9.]+ rejects the assembly that Robosim has generated: Error: no such.*"),
              EndsWith("; please report this with the file " + saved.string())));
    EXPECT_THAT(read_file(saved), HasSubstr(".Lrobosim_divides"));
  }
}

TEST_F(SketchTest, ASketchWithoutLoopIsToldSo) {
  write("Half/Half.ino", "void setup() {}\n");
  EXPECT_EQ(error_of("Half"),
            "Half.ino: the sketch has no function loop(); every sketch needs setup() and loop()");
}

TEST_F(SketchTest, AFunctionThatNobodyDefinesIsNamedWithTheLineThatCallsIt) {
  write("Link/Link.ino", "void later(int);\nvoid setup() { later(3); }\nvoid loop() {}\n");
  EXPECT_EQ(error_of("Link"), "Link.ino:2: undefined reference to `later(int)'");
}

TEST_F(SketchTest, ATwiceDefinedFunctionIsNamed) {
  write("Twice/Twice.ino", "int twice() { return 1; }\n" + kEmptySketch);
  write("Twice/other.cpp", "int twice() { return 2; }\n");
  EXPECT_THAT(error_of("Twice"), AllOf(HasSubstr("other.cpp:1: multiple definition of `twice()'"),
                                       HasSubstr("Twice.ino:1: first defined here"), Not(HasSubstr(".o:"))));
}

TEST_F(SketchTest, AHeaderWithOtherCapitalLettersIsNamed) {
  write("Small/Small.ino", "#include <arduino.h>\n" + kEmptySketch);
  EXPECT_THAT(error_of("Small"),
              StartsWith("Small.ino:1:10: no such header arduino.h: write Arduino.h, because Linux"));
  write("Small/Small.ino", "#include <AVR/io.h>\n" + kEmptySketch);
  EXPECT_THAT(error_of("Small"), HasSubstr("no such header AVR/io.h"))
      << "only file names are compared without case";
  write("Small/Small.ino", "#include \"MOTORS.H\"\n" + kEmptySketch);
  write("Small/motors.h", "");
  EXPECT_THAT(error_of("Small"), HasSubstr("no such header MOTORS.H: write motors.h, because Linux"));
  write("Small/Small.ino", "#include \"Part.h\"\n" + kEmptySketch);
  write("Small/libraries/Part/part.h", "");
  EXPECT_THAT(error_of("Small"), HasSubstr("no such header Part.h: write part.h, because Linux"));
  for (const char* outside : {"/etc/PASSWD", "../Small/SMALL.ino", "../../../../../../../etc/PASSWD"}) {
    write("Small/Small.ino", std::string("#include \"") + outside + "\"\n" + kEmptySketch);
    EXPECT_THAT(error_of("Small"), Not(HasSubstr("write "))) << outside;
  }
}

TEST_F(SketchTest, APrivateHeaderOfTheAvrCoreIsForTheTargetAvr) {
  write("Private/Private.ino", "#include <wiring_private.h>\n" + kEmptySketch);
  EXPECT_THAT(error_of("Private"),
              AllOf(StartsWith("Private.ino:1:10: wiring_private.h is a private part of"),
                    EndsWith("; build for the target avr")));
}

TEST_F(SketchTest, TheMainFileIsTheOneWithSetupAndLoop) {
  write("Download/main.ino", "// void setup() {}\nvoid  setup( void )\n{\n}\nvoid loop(){ other(); }\n");
  write("Download/a.ino", "/* void loop() {} */ void other() {}\nvoid setups() {}\nvoid loop();\n");
  EXPECT_EQ(error_of("Download"), "no error");
  EXPECT_EQ(remark_on_main_file(folder_ / "Download"),
            "Download has no Download.ino: its main file is main.ino, which defines setup() and loop(); "
            "Arduino's IDE requires that the folder is called main");
  write("Download/Download.ino", "void third() {}\n");
  EXPECT_EQ(remark_on_main_file(folder_ / "Download"), "");
  EXPECT_EQ(remark_on_main_file(folder_ / "Download/a.ino"), "");
}

TEST_F(SketchTest, NoMainFileIsSoughtInLinksAndInLargeFiles) {
  write("Open/a.ino", "void other() {}\n");
  write("Open/main.ino", kEmptySketch);
  EXPECT_NE(remark_on_main_file(folder_ / "Open"), "");
  fs::create_symlink("a.ino", folder_ / "Open/link.ino");
  EXPECT_EQ(remark_on_main_file(folder_ / "Open"), "");
  EXPECT_THAT(error_of("Open"), HasSubstr("named like its folder, among the 3 .ino files"));
  fs::remove(folder_ / "Open/link.ino");
  fs::resize_file(folder_ / "Open/a.ino", 9 << 20);
  EXPECT_EQ(remark_on_main_file(folder_ / "Open"), "");
}

TEST_F(SketchTest, ATabThatIsAlsoIncludedIsToldSo) {
  write("Twice/Twice.ino", "#include \"motors.ino\"\n" + kEmptySketch);
  write("Twice/motors.ino", "void motors() {}\n");
  EXPECT_THAT(error_of("Twice"),
              EndsWith("hint: all .ino files of a folder form one sketch: remove #include \"motors.ino\""));
}

TEST_F(SketchTest, LongOutputOfTheCompilerIsShortenedToTwentyLines) {
  std::string calls;
  for (int i = 0; i < 12; ++i) calls += "  undeclared" + std::to_string(i) + "();\n";
  write("Many/Many.ino", "void setup() {\n" + calls + "  A8;\n}\nvoid loop() { WRONG }\n");
  const auto lines = [](const std::string& text) { return std::count(text.begin(), text.end(), '\n') + 1; };
  const std::string error = error_of("Many");
  EXPECT_LE(lines(error), 21) << error;
  EXPECT_THAT(error, HasSubstr("2 |   undeclared0();")) << "the first message has its source";
  EXPECT_THAT(error, HasSubstr("'undeclared11' was not declared"));
  EXPECT_THAT(error, AllOf(StartsWith("Many.ino:2:3: error: 'undeclared0' was not declared"),
                           ContainsRegex("\n… [0-9]+ more lines; robosim build prints all of them$")));
  try {
    build::Request request{folder_ / "Many", *find_board("uno")};
    request.all_messages = true;
    build::build(request);
    FAIL() << "it compiles";
  } catch (const CompileError& all) {
    EXPECT_GT(lines(all.what()), 21);
    EXPECT_THAT(all.what(), HasSubstr("WRONG"));
  }
  EXPECT_EQ(folded("one\ntwo\n"), "one\ntwo\n");
}

TEST_F(SketchTest, WhatIsNoSketchIsRefused) {
  write("Nothing/readme.txt", "");
  write("HandIn/.git/git.ino", kEmptySketch);
  write("HandIn/Follower/Follower.ino", kEmptySketch);
  write("Many/a.ino", kEmptySketch);
  write("Many/b.ino", kEmptySketch);
  write("Asm/Asm.ino", kEmptySketch);
  write("Asm/fast.S", "nop\n");
  EXPECT_THAT(error_of("NoSuch"), HasSubstr("no such sketch"));
  EXPECT_THAT(error_of("Nothing"), EndsWith("got a folder without an .ino file"));
  EXPECT_THAT(error_of("HandIn"),
              EndsWith("without an .ino file; it contains the sketch Follower: name that folder"));
  EXPECT_THAT(error_of("Nothing/readme.txt"),
              HasSubstr("expected a sketch: a folder, an .ino or a .cpp file"));
  EXPECT_THAT(
      error_of("Many"),
      HasSubstr("expected Many.ino, named like its folder, among the 2 .ino files, got a.ino and b.ino"));
  EXPECT_THAT(error_of("Asm"), StartsWith("fast.S: assembler sources require a chip"));
  EXPECT_THAT(
      [this] {
        build({folder_ / "Many/a.ino", *find_board("uno"), "pdp11"});
      },
      testing::ThrowsMessage<InputError>(HasSubstr("unknown target pdp11")));
  EXPECT_THAT(error_of("Many/a.ino", {folder_ / "none"}),
              HasSubstr("not a folder: expected a folder of libraries"));
}

TEST_F(SketchTest, ACacheThatCannotBeWrittenIsNamed) {
  write("Any/Any.ino", kEmptySketch);
  write("xdg/robosim/entries", "a file where a folder should be");
  ::setenv("XDG_CACHE_HOME", (folder_ / "xdg").c_str(), 1);
  EXPECT_THAT(error_of("Any"),
              StartsWith((folder_ / "xdg/robosim/entries").string() + ": cannot use the folder: "));
}

TEST_F(SketchTest, ACacheWhoseFoldersAreOfAnotherUserIsNamedWithAWayOut) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may write every folder";
  write("Any/Any.ino", kEmptySketch);
  ::setenv("XDG_CACHE_HOME", (folder_ / "xdg").c_str(), 1);
  std::filesystem::create_directories(folder_ / "xdg/robosim/work");
  std::filesystem::permissions(folder_ / "xdg/robosim/work",
                               std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
  EXPECT_THAT(error_of("Any"), HasSubstr("Permission denied: expected a folder that this user can write"));
  std::filesystem::permissions(folder_ / "xdg/robosim/work", std::filesystem::perms::owner_all);
}

TEST_F(SketchTest, AMissingCompilerIsNamedWithItsPackage) {
  write("Any/Any.ino", kEmptySketch);
  ::setenv("PATH", folder_.c_str(), 1);
  EXPECT_THAT([this] { build_here("Any"); },
              testing::ThrowsMessage<ToolMissing>("g++ is missing: sudo apt install g++"));
}

}  // namespace errors_test
}  // namespace robosim::build
