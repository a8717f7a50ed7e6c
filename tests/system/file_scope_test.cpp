// Tests that a run for a client of `robosim serve` reads only files of the served folder. Also tests
// untrusted text on a terminal, and files that unpack to many times their size.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>

#include "sim/base/file_scope.h"
#include "sim/build/sketch.h"
#include "tests/system/on_terminal.h"

namespace robosim::test {
namespace file_scope_test {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;

constexpr const char* kSketch = "void setup() { Serial.begin(9600); }\nvoid loop() {}\n";
constexpr const char* kRun = " --goal none --for 10ms";

/// A served folder, and a file next to it that no client may see.
class Served : public testing::Test {
 protected:
  void SetUp() override {
    place_.write("outside/secret", "SECRET\n");
    place_.write("outside/secret.toml", "SECRET = 1\n");
    place_.write("outside/secret.map", "SECRET\n");
    place_.write("outside/Theirs/Theirs.ino", "#error SECRET\n");
    place_.write("outside/secret.h", "#error SECRET\n");
    place_.write("outside/libs/Lib/Lib.h", "#error SECRET\n");
    place_.write("served/Mine/Mine.ino", kSketch);
  }

  /// Runs a command as `robosim serve` does: the restriction applies to the command, not to this process.
  Ended run(const std::string& words) const {
    const std::string variable = file_scope_variable(
        {fs::canonical(place_ / "served"), fs::canonical(place_.path()) / "pages", build::cache_folder()});
    return robosim_command({"-c", "env '" + variable + "' " + ROBOSIM_COMMAND + " run " + words + kRun},
                           place_ / "served", nullptr, "/dev/null", "/bin/sh");
  }
  std::string outside(const std::string& name) const { return (place_ / ("outside/" + name)).string(); }
  void refuses(const std::string& words) const {
    const Ended ended = run(words);
    EXPECT_EQ(ended.status, 2) << words << "\n" << ended.out << ended.err;
    EXPECT_THAT(ended.out + ended.err, Not(HasSubstr("SECRET"))) << words;
  }

  Folder place_;
};

TEST_F(Served, RunsWhatLiesInTheFolder) {
  place_.write("served/robots/base.toml", "base = \"uno5\"\n");
  place_.write("served/robots/mine.toml", "base = \"../robots/base.toml\"\n");
  place_.write("served/go.script", "at 1ms press start\n");
  place_.write("served/maps/hall.map", "S....\n");
  place_.write("served/common/pid.h", "const int kP = 1;\n");
  place_.write("served/Mine/Mine.ino", "#include \"../common/pid.h\"\nvoid setup() {}\nvoid loop() {}\n");
  place_.write("served/two.toml",
               "map = \"maps/hall.map\"\n[[agent]]\nname = \"A\"\nsketch = \"./Mine\"\n"
               "robot = \"robots/mine.toml\"\nscript = \"go.script\"\n");
  const Ended one = run("./Mine --robot robots/mine.toml --map ./maps/hall.map");
  EXPECT_EQ(one.status, 0) << one.err;
  const Ended fleet = run("./two.toml");
  EXPECT_EQ(fleet.status, 0) << fleet.err;
}

TEST_F(Served, RunsSeveralRobotsOnAMapOfRobosims) {
  place_.write("served/two.toml",
               "map = \"oval\"\n[[agent]]\nname = \"A\"\nsketch = \"PidFollower\"\n"
               "[[agent]]\nname = \"B\"\nsketch = \"./Mine\"\nstart = \"20,2,W\"\n");
  const Ended fleet = run("./two.toml");
  EXPECT_EQ(fleet.status, 0) << fleet.err;
}

TEST_F(Served, ReadsNoScriptMapSketchRobotOrLibraryThatAFileOfRobotsNamesOutside) {
  const std::string agent = "[[agent]]\nname = \"A\"\nsketch = \"./Mine\"\n";
  const std::string absolute = outside("secret"), relative = "../outside/secret";
  for (const std::string& secret : {absolute, relative, std::string("Mine/../../outside/secret")}) {
    for (const std::string& text :
         {agent + "script = \"" + secret + "\"\n", "map = \"" + secret + ".map\"\n" + agent,
          agent + "robot = \"" + secret + ".toml\"\n",
          "[[agent]]\nname = \"A\"\nsketch = \"" + secret + ".elf\"\n"}) {
      place_.write("served/fleet.toml", text);
      refuses("./fleet.toml");
      EXPECT_THAT(run("./fleet.toml").err,
                  HasSubstr("leads out of the served folder: expected a path inside it"))
          << text;
    }
  }
  place_.write("served/Mine/Mine.ino", "#include <Lib.h>\nvoid setup() {}\nvoid loop() {}\n");
  place_.write("served/fleet.toml", agent + "libraries = \"" + outside("libs") + "\"\n");
  refuses("./fleet.toml");
  place_.write("served/fleet.toml", "[[agent]]\nname = \"A\"\nsketch = \"" + outside("Theirs") + "\"\n");
  refuses("./fleet.toml");
}

TEST_F(Served, TellsNotEvenWhetherAFileOutsideIsThere) {
  const auto sentence = [&](const std::string& name) {
    place_.write("served/fleet.toml",
                 "map = \"" + name + "\"\n[[agent]]\nname = \"A\"\nsketch = \"./Mine\"\n");
    const std::string err = run("./fleet.toml").err;
    return err.substr(err.find("' leads out") == err.npos ? 0 : err.find("' leads out"));
  };
  EXPECT_EQ(sentence(outside("secret.map")), sentence(outside("none.map")));
}

TEST_F(Served, ReadsNoBaseOfARobotOutside) {
  place_.write("served/robot.toml", "base = \"../outside/secret.toml\"\n");
  refuses("./Mine --robot ./robot.toml --map oval");
  place_.write("served/robot.toml", "base = \"" + outside("secret.toml") + "\"\n");
  refuses("./Mine --robot ./robot.toml --map oval");
}

TEST_F(Served, FollowsNoLinkOut) {
  fs::create_symlink(place_ / "outside/secret.map", place_ / "served/link.map");
  fs::create_symlink("../outside/secret.toml", place_ / "served/link.toml");
  fs::create_directory_symlink("../outside", place_ / "served/away");
  fs::create_symlink("../outside/secret.map", place_ / "served/Mine/only.map");
  refuses("./Mine --map ./link.map");
  refuses("./Mine --map oval --robot ./link.toml");
  refuses("./Mine --map ./away/secret.map");
  refuses("./away/Theirs --map oval");
  refuses("./Mine");  // the only map in Mine is a link
  fs::create_symlink("../../outside/secret.h", place_ / "served/Mine/secret.h");
  place_.write("served/Mine/Mine.ino", "#include \"secret.h\"\nvoid setup() {}\nvoid loop() {}\n");
  refuses("./Mine --map oval");
}

TEST_F(Served, CompilesNoHeaderAndTakesNoFolderOutside) {
  place_.write("served/Mine/Mine.ino",
               "#include \"../../outside/secret.h\"\nvoid setup() {}\nvoid loop() {}\n");
  refuses("./Mine --map oval");
  place_.write("served/Mine/Mine.ino", kSketch);
  place_.write("served/Mine/platformio.ini",
               "[platformio]\nsrc_dir = ../../outside/Theirs\n[env:uno]\nboard = uno\n");
  refuses("./Mine --map oval");
  place_.write("served/Mine/platformio.ini",
               "[env:uno]\nboard = uno\nlib_extra_dirs = " + outside("libs") + "\n");
  place_.write("served/Mine/src/main.cpp",
               "#include <Arduino.h>\n#include <Lib.h>\nvoid setup() {}\nvoid loop() {}\n");
  refuses("./Mine --map oval");
}

TEST(OnATerminal, WhatASketchSendsIsShownAndNotCarriedOut) {
  const Folder folder;
  folder.write("S/S.ino",
               "void setup() { Serial.begin(9600); "
               "Serial.print(\"\\x1b]0;title\\x07\\x1b[2J\\rreached\\r\\nnext\\n\"); "
               "Serial.flush(); }\nvoid loop() {}\n");
  const std::vector<std::string> words{"run",     (folder / "S").string(),
                                       "--map",   "oval",
                                       "--robot", "uno5",
                                       "--goal",  "none",
                                       "--for",   "200ms",
                                       "--serial"};
  OnTerminal run(words, 100, 30);
  run.finish();
  EXPECT_THAT(run.seen(), HasSubstr("\\x1b]0;title\\x07\\x1b[2J\\x0dreached\r\nnext\r\n"));
  EXPECT_THAT(run.seen(), AllOf(Not(HasSubstr("\033]")), Not(HasSubstr("\033[2J"))));
  EXPECT_THAT(robosim_command(words).out, HasSubstr("\x1b]0;title\x07")) << "a pipe gets the bytes";
}

TEST(OnATerminal, NamesAndErrorsAreShownAndNotCarriedOut) {
  const Folder folder;
  const std::string evil = "\033]0;title\a\nrobosim: reached";
  folder.write("S/S.ino", "#error \"\033[2J\"\nvoid setup() {}\nvoid loop() {}\n");
  folder.write(evil + ".map", "no map\n");
  folder.write("robot.toml", "\"\033[31m\" = 1\n");
  for (const std::vector<std::string>& words : {std::vector<std::string>{"run", "./S", "--map", "oval"},
                                                {"map", "check", "./" + evil + ".map"},
                                                {"run", "./" + evil},
                                                {"robot", "check", "./robot.toml"}}) {
    const Ended ended = robosim_command(words, folder.path());
    EXPECT_NE(ended.status, 0);
    EXPECT_THAT(ended.err, Not(HasSubstr("\033"))) << words[1];
    EXPECT_THAT("\n" + ended.err, Not(HasSubstr("\nrobosim: reached"))) << words[1];
  }
}

}  // namespace file_scope_test
}  // namespace robosim::test
