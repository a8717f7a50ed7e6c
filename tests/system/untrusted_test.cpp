// Tests `--untrusted`: a sketch by another author runs only if this machine can confine it, and is graded on
// a chip. docs/explanation/security.md lists the confined actions.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include <algorithm>
#include <sstream>

#include "sim/base/program_sandbox.h"
#include "sim/build/process.h"
#include "sim/build/sketch.h"
#include "tests/support/require_target.h"
#include "tests/system/command.h"
#include "tests/system/system_test.h"

namespace robosim::test {
namespace untrusted_test {

using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

constexpr const char* kLap =
    "[[check]]\nname = \"drives a lap\"\nmap = \"oval\"\nrobot = \"uno5\"\ngoal = \"laps:1\"\nfor = "
    "\"30s\"\n";

std::string empty_sketch(const std::string& begin) { return begin + "\nvoid setup() {}\nvoid loop() {}\n"; }

/// Returns a sketch that follows the line with LineKit's controller, faster or slower.
std::string follower(int speed) {
  return "#include <LineKit.h>\nconst uint8_t PINS[] = {A0, A1, A2, A3, A4};\nAnalogLineSensors "
         "sensors(PINS);\n"
         "DriveMotors motors(DriveMotor(5, 7, 8), DriveMotor(6, 9, 10));\nPidController pid(80, 0, 3);\n"
         "void setup() { sensors.begin(); sensors.setRange(110, 880); motors.begin(); pid.setLimits(-200, "
         "200); }\n"
         "void loop() {\n  sensors.read();\n  float turn = pid.update(sensors.position() / 1000.0, 0.005);\n"
         "  motors.drive(" +
         std::to_string(speed) + " + turn, " + std::to_string(speed) + " - turn);\n  delay(5);\n}\n";
}

/// Returns a sketch that follows the line, or drives straight on, with only Arduino's functions.
std::string by_hand(int speed, bool looks) {
  const auto sees = [&](const char* one, const char* other) {
    if (!looks) return std::string("false");
    return std::string("analogRead(") + one + ") > 400 || analogRead(" + other + ") > 400";
  };
  const std::string fast = std::to_string(speed);
  return "void drive(int left, int right) {\n"
         "  digitalWrite(7, left > 0); digitalWrite(8, left < 0); analogWrite(5, abs(left));\n"
         "  digitalWrite(9, right > 0); digitalWrite(10, right < 0); analogWrite(6, abs(right));\n}\n"
         "void setup() { for (int pin = 5; pin <= 10; pin++) pinMode(pin, OUTPUT); }\nvoid loop() {\n  if (" +
         sees("A0", "A1") + ") drive(30, " + fast + ");\n  else if (" + sees("A3", "A4") + ") drive(" + fast +
         ", 30);\n  else drive(" + fast + ", " + fast + ");\n  delay(2);\n}\n";
}

class Untrusted : public testing::Test {
 protected:
  void SetUp() override {
    if (!ProgramSandbox::missing().empty()) GTEST_SKIP() << ProgramSandbox::missing();
    needs_target("avr");
    folder_.write("class.toml", kLap);
    folder_.write("secret/secret.h", "const int secret = 42;\n");
  }
  Ended robosim(std::vector<std::string> words) const {
    return robosim_command(std::move(words), folder_.path());
  }
  /// Runs a command as if the kernel lacked `what` (lacking.cpp).
  Ended without(const std::string& what, std::vector<std::string> words) const {
    words.insert(words.begin(), {what, ROBOSIM_COMMAND});
    return robosim_command(std::move(words), folder_.path(), nullptr, "/dev/null", ROBOSIM_LACKING);
  }
  void write_hostile_ones() const {
    folder_.write("pupils/eve/eve.ino", empty_sketch("#include \"/etc/passwd\""));
    folder_.write("pupils/mallory/mallory.ino", empty_sketch("#include \"notes.h\""));
    std::filesystem::create_symlink("../../secret/secret.h", folder_ / "pupils/mallory/notes.h");
    folder_.write("pupils/oscar/oscar.ino", empty_sketch("asm(\".incbin \\\"../../secret/secret.h\\\"\");"));
  }

  Folder folder_;
};

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream all(text);
  for (std::string line; std::getline(all, line);) lines.push_back(line);
  return lines;
}

TEST_F(Untrusted, AClassOfThirtyGetsTwentySevenRightVerdictsAndThreeRefusals) {
  std::vector<std::string> words{"test", "--untrusted", "--checks", "class.toml"}, due;
  const auto hand_in = [&](const std::string& name, const std::string& text, const char* verdict) {
    folder_.write("pupils/" + name + "/" + name + ".ino", text);
    due.push_back(verdict);
  };
  for (int i = 0; i < 10; ++i) hand_in("a" + std::to_string(i), follower(100 + 4 * i), "passed");
  for (int i = 0; i < 8; ++i) hand_in("b" + std::to_string(i), by_hand(104 + 2 * i, true), "passed");
  for (int i = 0; i < 5; ++i) hand_in("c" + std::to_string(i), by_hand(90 + 10 * i, false), "lost");
  for (int i = 0; i < 2; ++i)
    hand_in(
        "d" + std::to_string(i),
        "void setup() { Serial.begin(9600); Serial.println(F(\"{\\\"id\\\":2,\\\"result\\\":{\\\"verdict\\\":"
        "\\\"reached\\\",\\\"status\\\":0}}\")); }\nvoid loop() { delay(1); }\n",
        "timeout");
  for (int i = 0; i < 2; ++i) hand_in("e" + std::to_string(i), empty_sketch("int x = ;"), "expected");
  write_hostile_ones();
  due.insert(due.end(), 3, "outside");
  for (const auto& pupil : std::filesystem::directory_iterator(folder_ / "pupils"))
    words.push_back("pupils/" + pupil.path().filename().string() + "/");
  std::sort(words.begin() + 4, words.end());
  ASSERT_EQ(words.size(), 4 + 30u);

  const Ended ended = robosim(words);
  EXPECT_EQ(ended.status, 2) << ended.err;
  std::vector<std::string> lines = lines_of(ended.out);
  ASSERT_EQ(lines.size(), 31u) << ended.out;
  EXPECT_EQ(lines.back(), "18 of 30 sketches passed all checks");
  for (std::size_t i = 0; i < 30; ++i) {
    const std::string verdict = due[i];
    if (verdict == "outside") {
      EXPECT_THAT(lines[i], AllOf(HasSubstr("  ERROR   "),
                                  testing::AnyOf(HasSubstr("is not a readable file of the sketch"),
                                                 HasSubstr("outside of the sketch's folder"))));
    } else {
      EXPECT_THAT(lines[i], HasSubstr(verdict));
    }
  }
  EXPECT_THAT(ended.out, AllOf(Not(HasSubstr("42")), Not(HasSubstr("root:"))));
}

TEST_F(Untrusted, ASketchThatBreaksAToolOrCannotBeReadIsAnErrorOfItsOwn) {
  std::string nested;
  for (int i = 0; i < 180'000; ++i) nested += "namespace{";  // arduino-ctags uses stack for each level
  folder_.write("anna/anna.ino", empty_sketch(nested + std::string(180'000, '}')));
  folder_.write("ben/ben.ino", empty_sketch(""));
  folder_.write("cleo/cleo.ino", empty_sketch(""));
  std::filesystem::create_symlink("itself.h", folder_ / "cleo/itself.h");
  folder_.write("checks.toml",
                "[[check]]\nname = \"a\"\nmap = \"oval\"\nrobot = \"uno5\"\ngoal = \"none\"\nfor = \"10ms\"\n"
                "target = \"avr\"\n");
  for (const char* how : {"--untrusted", "--jobs=1"}) {
    const Ended ended = robosim({"test", how, "--checks", "checks.toml", "anna/", "ben/", "cleo/"});
    EXPECT_EQ(ended.status, 2) << ended.err;
    const std::vector<std::string> lines = lines_of(ended.out);
    ASSERT_EQ(lines.size(), 4u) << ended.out << ended.err;
    EXPECT_THAT(lines[0],
                AllOf(StartsWith("anna  ERROR   "), HasSubstr("arduino-ctags, which lists the sketch")));
    EXPECT_EQ(lines[1], "ben   passed  1 of 1");
    EXPECT_THAT(lines[2], StartsWith("cleo  ERROR   "));
  }
}

TEST_F(Untrusted, RunsAreOnTheChipOfTheRobotsBoardAndTheHostIsRefused) {
  folder_.write("S/S.ino", empty_sketch(""));
  const std::string check =
      "[[check]]\nname = \"waits\"\nmap = \"oval\"\nrobot = \"uno5\"\ngoal = \"none\"\nfor = \"50ms\"\n";
  folder_.write("checks.toml", check);
  EXPECT_EQ(robosim({"test", "--untrusted", "./S", "--checks", "checks.toml"}).out,
            "passed  waits  oval · uno5 · avr  reached after 0.05 s\n1 of 1 check passed\n");
  folder_.write("checks.toml", check + "target = [\"avr\", \"host\"]\n");
  const Ended host = robosim({"test", "--untrusted", "./S", "--checks", "checks.toml"});
  EXPECT_EQ(host.status, 2);
  EXPECT_THAT(host.err,
              StartsWith("robosim: checks.toml:1:1: target: with --untrusted, expected avr, stm32, or no "
                         "target (the chip of the robot's board), got host"));
}

TEST_F(Untrusted, ChecksBesideASketchAreToldToBeItsAuthorsAndNameNoFileOutsideOfItsFolder) {
  folder_.write("S/S.ino", empty_sketch(""));
  const auto with = [&](const std::string& line) {
    folder_.write("S/checks.toml",
                  "[[check]]\nname = \"a\"\ngoal = \"none\"\nfor = \"10ms\"\n" + line + "\n");
    return robosim({"test", "--untrusted", "./S"});
  };
  EXPECT_EQ(with("map = \"oval\"\nrobot = \"uno5\"").status, 0);
  EXPECT_THAT(with("").err, HasSubstr("the checks.toml in its own folder, which its author wrote"));
  for (const char* line : {"map = \"../secret/secret.h\"", "map = \"/etc/passwd\"",
                           "robot = \"../secret/secret.h\"", "script = \"../secret/secret.h\"",
                           "libraries = \"../secret\"", "robot = \"../secret/secret.h@nano\""}) {
    const Ended ended = with(line);
    EXPECT_EQ(ended.status, 2) << line;
    EXPECT_THAT(ended.err,
                AllOf(HasSubstr("S/checks.toml:1:1: "), HasSubstr("is outside the sketch's folder")))
        << line;
  }
}

TEST_F(Untrusted, ChecksForAllThatNameNoMapAreReportedAsThoseAPupilCanChoose) {
  folder_.write("S/S.ino", empty_sketch(""));
  const std::string begin = "[[check]]\nname = \"a\"\ngoal = \"none\"\nfor = \"10ms\"\n";
  const auto warning = [&](const std::string& lines) {
    folder_.write("class.toml", begin + lines);
    return robosim({"test", "--untrusted", "--checks", "class.toml", "./S"}).err;
  };
  EXPECT_THAT(warning(""),
              HasSubstr("class.toml: check \"a\" has no map and no robot: files in a sketch's folder"));
  EXPECT_THAT(warning("map = \"oval\"\n"), HasSubstr("has no robot"));
  EXPECT_THAT(warning("map = \"oval\"\nrobot = \"uno5\"\n"), Not(HasSubstr("has no")));
}

TEST_F(Untrusted, ASketchsOwnChecksTakeNoMoreThanAnHourOfSimulatedTimeTogether) {
  folder_.write("S/S.ino", empty_sketch(""));
  const auto check = [](const std::string& name, const std::string& times) {
    return "[[check]]\nname = \"" + name + "\"\nmap = \"oval\"\nrobot = \"uno5\"\ngoal = \"none\"\n" + times +
           "\n";
  };
  folder_.write("S/checks.toml", check("a", "seeds = \"1..600200\"\nfor = \"6ms\""));
  const Ended alone = robosim({"test", "--untrusted", "./S"});
  EXPECT_EQ(alone.status, 2);
  EXPECT_THAT(alone.out + alone.err, HasSubstr("got 3601 s up to this check"));

  const std::string some = check("a", "seeds = \"1..2\"\nfor = \"10ms\"");
  folder_.write("S/checks.toml", some + check("b", "for = \"3600s\""));
  EXPECT_EQ(robosim({"test", "--untrusted", "./S"}).status, 2);
  folder_.write("S/checks.toml", some + check("b", "for = \"1s\""));
  EXPECT_EQ(robosim({"test", "--untrusted", "./S"}).status, 0);
}

TEST_F(Untrusted, NoFileThatRobosimFindsByItselfLeadsOutOfTheSketchsFolder) {
  for (const char* link : {"S.ino", "robot.toml", "oval.map", "src", "libraries", "checks.toml",
                           "platformio.ini", "sketch.yaml", "build.options.json"}) {
    SCOPED_TRACE(link);
    std::filesystem::remove_all(folder_ / "S");
    folder_.write("S/T.ino", empty_sketch(""));
    std::filesystem::create_symlink("/etc/passwd", folder_ / "S" / link);
    for (const char* command : {"run", "sweep", "compare", "test"}) {
      const Ended ended = robosim({command, "--untrusted", "./S"});
      EXPECT_EQ(ended.status, 2);
      EXPECT_THAT(ended.err, HasSubstr(std::string("S/") + link + ": a link to /etc/passwd, outside"));
    }
  }
}

TEST_F(Untrusted, NoFolderThatAProjectNamesIsOutsideOfTheSketchsFolder) {
  folder_.write("S/src/main.cpp", "#include <Arduino.h>\nvoid setup() {}\nvoid loop() {}\n");
  folder_.write("shared/main.cpp", "#include <Arduino.h>\nvoid setup() {}\nvoid loop() {}\n");
  const std::string environment = "[env:uno]\nplatform = atmelavr\nboard = uno\n";
  for (const char* line : {"[platformio]\nsrc_dir = ../shared\n", "[platformio]\ninclude_dir = ../shared\n",
                           "lib_extra_dirs = ../shared\n"}) {
    folder_.write("S/platformio.ini", environment + line);
    std::vector<std::string> words{"run", "./S", "--map", "oval", "--goal", "none", "--for", "10ms"};
    EXPECT_EQ(robosim(words).status, 0) << "allowed without --untrusted: " << line;
    words.emplace_back("--untrusted");
    const Ended ended = robosim(words);
    EXPECT_EQ(ended.status, 2) << line;
    EXPECT_THAT(ended.err, HasSubstr("is outside of the sketch's folder; --untrusted does not follow it"))
        << line;
  }
}

TEST_F(Untrusted, ARobotOfTheSketchsIsBasedOnNothingOutsideOfItsFolder) {
  folder_.write("S/S.ino", empty_sketch(""));
  folder_.write("S/robots/base.toml", "base = \"uno5\"\n");
  folder_.write("secret/robot.toml", "hunter2\n");
  const auto with = [&](const std::string& base) {
    folder_.write("S/robot.toml", "base = \"" + base + "\"\n");
    return robosim({"run", "--untrusted", "./S", "--map", "oval", "--goal", "none", "--for", "10ms"});
  };
  EXPECT_EQ(with("uno5").status, 0);
  EXPECT_EQ(with("robots/base.toml").status, 0);
  for (const char* base : {"../secret/robot.toml", "/etc/passwd"}) {
    const Ended ended = with(base);
    EXPECT_EQ(ended.status, 2);
    EXPECT_THAT(ended.err, HasSubstr("S/robot.toml:1:8: base: \"" + std::string(base) +
                                     "\" is outside of the sketch's folder"));
    EXPECT_THAT(ended.err, Not(HasSubstr("hunter2")));
  }
  folder_.write("S/robots/base.toml", "base = \"../../secret/robot.toml\"\n");
  EXPECT_THAT(with("robots/base.toml").err, HasSubstr("S/robots/base.toml:1:8: base: "));
}

TEST_F(Untrusted, AnImageNamesNoFolderOutsideOfItsOwn) {
  folder_.write("S/x.hex", ":00000001FF\n");
  folder_.write("S/build.options.json", "{\"sketchLocation\": \"" + (folder_ / "secret").string() + "\"}");
  const Ended ended = robosim({"run", "--untrusted", "./S/x.hex", "--map", "oval", "--robot", "uno5"});
  EXPECT_EQ(ended.status, 2);
  EXPECT_THAT(ended.err, HasSubstr("refer to " + (folder_ / "secret").string() + " as the sketch's folder"));
}

TEST_F(Untrusted, GoesOnOnlyWhereTheKernelCanConfine) {
  folder_.write("S/S.ino", empty_sketch(""));
  folder_.write("T/T.ino", empty_sketch(""));
  const std::vector<std::string> how{"--map", "oval", "--robot", "uno5", "--goal", "none", "--for", "10ms"};
  const auto with = [&](std::vector<std::string> words) {
    words.insert(words.end(), how.begin(), how.end());
    return words;
  };
  const auto refused = [&](const char* what, std::vector<std::string> words) {
    words.insert(words.begin() + 1, "--untrusted");
    const Ended ended = without(what, words);
    EXPECT_EQ(ended.status, 5) << words[0] << ended.out;
    return ended.err;
  };
  const auto told = [&](const char* what, const std::vector<std::string>& words) {
    const Ended ended = without(what, words);
    EXPECT_EQ(ended.status, 0) << words[0] << ended.err;
    return ended.err;
  };
  const std::string compilers =
      "robosim: compilers are not confined here: the kernel has no Landlock, and user namespaces are not "
      "allowed; a sketch can "
      "make them read any file that you can read\n";
  const std::string runs =
      "robosim: runs on the host are not confined here: the kernel has no filter of system calls "
      "(seccomp); a sketch can do everything that you can do\n";
  EXPECT_EQ(told("walls", with({"run", "./S"})), compilers);
  EXPECT_EQ(told("seccomp", with({"run", "./S"})), runs);
  EXPECT_EQ(told("sandbox", with({"run", "./S"})), compilers + runs);
  EXPECT_EQ(told("sandbox", with({"sweep", "./S", "./T", "--seeds", "1..3"})), compilers + runs) << "once";
  EXPECT_EQ(told("seccomp", with({"run", "./S", "--target", "avr"})), "") << "firmware is only data";

  EXPECT_EQ(refused("walls", with({"run", "./S"})),
            "robosim: --untrusted: compilers cannot be confined here: the kernel has no Landlock, and "
            "user namespaces are not allowed\n");
  EXPECT_THAT(
      refused("seccomp", with({"run", "./S"})),
      StartsWith("robosim: --untrusted: runs on the host cannot be confined here: the kernel has no filter"));
  refused("seccomp", with({"sweep", "./S", "--seeds", "1..3"}));
  refused("seccomp", with({"compare", "./S"}));
  folder_.write(
      "checks.toml",
      "[[check]]\nname = \"a\"\nmap = \"oval\"\nrobot = \"uno5\"\ngoal = \"none\"\nfor = \"10ms\"\n");
  EXPECT_EQ(told("walls", {"test", "./S", "./T", "--checks", "checks.toml"}), compilers) << "once";
  EXPECT_EQ(without("walls", {"test", "--untrusted", "./S", "--checks", "checks.toml"}).status, 5);
  EXPECT_EQ(without("seccomp", {"test", "--untrusted", "./S", "--checks", "checks.toml"}).status, 0)
      << "nothing runs on the host";
}

TEST_F(Untrusted, CompilersSeeNoMoreWhereTheKernelHasNamespacesAndNoLandlock) {
  if (without("landlock", {"run", "PidFollower", "--untrusted", "--for", "10ms"}).status == 5)
    GTEST_SKIP() << "this kernel has no user namespaces";
  write_hostile_ones();
  folder_.write("pupils/peggy/peggy.ino", empty_sketch("#include \"../../secret/secret.h\""));
  folder_.write("pupils/trudy/trudy.ino", empty_sketch("#include <../../../../../../../etc/passwd>"));
  for (const char* name : {"eve", "mallory", "oscar", "peggy", "trudy"}) {
    const std::string sketch = std::string("pupils/") + name;
    for (const char* target : {"host", "avr"}) {
      const Ended ended =
          without("landlock", {"run", "./" + sketch, "--map", "oval", "--robot", "uno5", "--target", target});
      EXPECT_EQ(ended.status, 2) << name << ended.out;
      EXPECT_THAT(ended.err, HasSubstr("is not a readable file of the sketch")) << name;
    }
  }
  folder_.write(
      "S/S.ino",
      "#include \"../common/kp.h\"\n#include <LineKit.h>\nvoid setup() {}\nvoid loop() { kp(); }\n");
  folder_.write("common/kp.h", "inline int kp() { return 3; }\n");
  for (const char* target : {"host", "avr", "stm32"}) {
    if (!what_is_missing(target).empty()) continue;
    const Ended ended = without("landlock", {"run", "./S", "--map", "oval", "--robot", "uno5", "--target",
                                             target, "--goal", "none", "--for", "10ms"});
    EXPECT_EQ(ended.status, 0) << target << ended.err;
    EXPECT_THAT(ended.err, Not(HasSubstr("not confined")));
  }
}

/// Returns the path of a system call in strace's output, or "" if the call failed or has no path.
std::string opened(const std::string& line) {
  if (line.find(" = -1 ") != line.npos || line.find("resumed>") != line.npos) return "";
  const std::size_t begin = line.find('"');
  return begin == line.npos ? "" : line.substr(begin + 1, line.find('"', begin + 1) - begin - 1);
}

TEST_F(Untrusted, ReadsAndWritesNothingOutsideAsStraceSees) {
  const auto strace = build::find_program("strace");
  if (strace.empty()) GTEST_SKIP() << "there is no strace";
  folder_.write("pupils/anna/anna.ino", by_hand(110, true));
  write_hostile_ones();
  std::filesystem::create_directories(folder_ / "tmp");
  std::filesystem::create_directories(folder_ / "home");
  const std::string cache = (folder_ / "home/.cache").string();
  const Ended ended = robosim_command({"-f",
                                       "-qq",
                                       "-s",
                                       "4096",
                                       "-e",
                                       "signal=none",
                                       "-e",
                                       "trace=open,openat,creat,rename,renameat,renameat2,unlink,unlinkat,"
                                       "mkdir,mkdirat,link,linkat,symlink,symlinkat,truncate,socket,connect",
                                       "-o",
                                       "trace",
                                       "-E",
                                       "HOME=" + (folder_ / "home").string(),
                                       "-E",
                                       "XDG_CACHE_HOME=" + cache,
                                       "-E",
                                       "TMPDIR=" + (folder_ / "tmp").string(),
                                       ROBOSIM_COMMAND,
                                       "test",
                                       "--untrusted",
                                       "--checks",
                                       "class.toml",
                                       "pupils/anna/",
                                       "pupils/eve/",
                                       "pupils/mallory/",
                                       "pupils/oscar/"},
                                      folder_.path(), nullptr, "/dev/null", strace.string());
  EXPECT_THAT(ended.out, EndsWith("1 of 4 sketches passed all checks\n")) << ended.err;
  for (const std::string& line : lines_of(read_file(folder_ / "trace"))) {
    EXPECT_THAT(line, Not(HasSubstr("socket(")));
    const std::string path = opened(line);
    EXPECT_THAT(path, AllOf(Not(HasSubstr("secret")), Not(testing::HasSubstr("/etc/passwd")))) << line;
    const bool writes = line.find("O_WRONLY") != line.npos || line.find("O_RDWR") != line.npos ||
                        line.find("open") == line.npos;
    const bool scratch =
        path.starts_with(folder_.path().string()) || path.starts_with("/dev/null") || !path.starts_with("/");
    EXPECT_TRUE(!writes || path.empty() || scratch) << line;
  }
}

}  // namespace untrusted_test
}  // namespace robosim::test
