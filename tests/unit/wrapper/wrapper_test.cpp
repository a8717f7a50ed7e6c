// Tests the wrapper script `robosim` in a separate checkout. Test scripts replace the tools that the wrapper
// calls, and record these calls.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "sim/base/file.h"
#include "tests/support/temporary_folder.h"

namespace wrapper_test {

namespace fs = std::filesystem;
using robosim::read_file;
using robosim::write_file;
using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

struct Result {
  int status;
  std::string out;
  std::string err;
};

class Wrapper : public testing::Test {
 protected:
  Wrapper() {
    const fs::path source = ROBOSIM_SOURCE_DIR;
    for (const char* part : {"checkout/toolchain", "checkout/hal", "checkout/sim", "bin", "elsewhere"})
      fs::create_directories(folder_ / part);
    for (const char* file : {"robosim", "CMakeLists.txt", "CMakePresets.json", "toolchain/packages.sh",
                             "toolchain/run_tests.sh"})
      fs::copy(source / file, checkout() / file);
    write_file(checkout() / "toolchain/packages.txt",
               "[host]\nplenty\nscarce  # why\n[test]\ncheck-kit\n[avr]\nchip\n[stm32]\narm-kit\n");
    tool("dpkg-query", "printf '%s installed\\n' plenty check-kit chip arm-kit $(cat have 2>/dev/null)");
    tool("sudo", "exec \"$@\"");
    tool("apt-get", "case \" $* \" in *' update '*) echo Hit:1;; *) echo scarce >have;; esac");
    tool("apt-cache", "shift; for name; do printf '%s:\\n  Candidate: 1.0\\n' $name; done");
    tool("ctest", "pwd");
    tool("cmake", R"(
      case $1 in
        --version) echo 'cmake version 3.25.1' ;;
        --preset) mkdir -p build/$2; printf 'build robosim-%s: phony\n' avr stm32 serve campaign >build/$2/build.ninja
                  echo "CMAKE_HOME_DIRECTORY:INTERNAL=$PWD" >build/$2/CMakeCache.txt
                  echo 'ROBOSIM_TESTS:BOOL='${3#*=} >>build/$2/CMakeCache.txt ;;
        --build) echo compiling
                 printf '#!/bin/sh\npwd\nprintf "<%%s>" "$@"\nexit 4\n' >$2/robosim; chmod +x $2/robosim
                 mkdir -p $2/libexec
                 for program in avr stm32 serve campaign; do
                   case "$*" in *robosim-$program*) cp $2/robosim $2/libexec/robosim-$program ;; esac
                 done ;;
      esac)");
    write_file(folder_ / "have", "scarce\n");
  }
  ~Wrapper() override {
    std::error_code error;
    fs::remove_all(folder_, error);
  }

  fs::path checkout() const { return folder_ / "checkout"; }

  // Replaces a tool with a script, which appends its arguments to the file `calls` and then runs `body`.
  void tool(const std::string& name, const std::string& body) const {
    const fs::path file = folder_ / "bin" / name;
    const std::string note = "echo \"" + name + " $*\" >>'" + folder_.string() + "/calls'\n";
    // cmake and ctest stay in the caller's folder. The other tools store their state in `folder_`.
    const std::string place = name == "cmake" || name == "ctest" ? "" : "cd '" + folder_.string() + "'\n";
    write_file(file, "#!/bin/sh\n" + note + place + body + "\n");
    fs::permissions(file, fs::perms::owner_all);
  }

  // Runs a command line in a folder, without a terminal.
  Result run(const std::string& command, const std::string& folder = "elsewhere") const {
    const std::string line = "cd '" + (folder_ / folder).string() + "' && env -i PATH='" +
                             (folder_ / "bin").string() + ":/usr/bin:/bin' " + command +
                             " </dev/null >../out 2>../err";
    const int status = std::system(line.c_str());
    return {WEXITSTATUS(status), read_file(folder_ / "out"), read_file(folder_ / "err")};
  }

  // Returns the recorded calls since the previous query.
  std::string calls() const {
    const fs::path file = folder_ / "calls";
    if (!fs::exists(file)) return "";
    const std::string content = read_file(file);
    fs::remove(file);
    return content;
  }

  const robosim::test::TemporaryFolder temporary_;
  const fs::path folder_ = temporary_.path();
};

TEST_F(Wrapper, HandsItsArgumentsToTheBuiltCommandInTheUsersFolder) {
  fs::create_symlink(checkout() / "robosim", folder_ / "link");
  const Result result = run("../link run 'my sketch' --json");
  EXPECT_EQ(result.out, (folder_ / "elsewhere").string() + "\n<run><my sketch><--json>");
  EXPECT_EQ(result.err, "");
  EXPECT_EQ(result.status, 4) << "the command's own status";
}

TEST_F(Wrapper, NamesThePackageThatTheSystemDoesNotHave) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root installs without a terminal";
  fs::remove(folder_ / "have");
  for (const char* answer : {"printf 'scarce:\\n  Candidate: (none)\\n'", ":"}) {
    tool("apt-cache", answer);
    const Result result = run("../checkout/robosim run");
    EXPECT_EQ(result.status, 5);
    EXPECT_THAT(result.err,
                AllOf(HasSubstr("robosim: no package scarce in "), HasSubstr("expected Debian 12")));
    EXPECT_THAT(calls(), Not(HasSubstr(" install "))) << "nothing is installed";
  }
}

TEST_F(Wrapper, BuildsOnlyWhatACommandNeedsAndOnlyOnce) {
  run("../checkout/robosim");
  EXPECT_THAT(calls(), testing::AllOf(HasSubstr("cmake --preset release -DROBOSIM_TESTS=OFF\n"),
                                      testing::ContainsRegex("cmake --build .*/build/release -j [1-9][0-9]* "
                                                             "--target robosim robosim-host\n")));
  run("../checkout/robosim");
  EXPECT_EQ(calls(), "");
}

TEST_F(Wrapper, BuildsAgainAfterAChange) {
  run("../checkout/robosim");
  calls();
  write_file(checkout() / "sim/new.cpp", "");
  fs::last_write_time(checkout() / "sim/new.cpp", fs::file_time_type::clock::now() + std::chrono::hours(1));
  run("../checkout/robosim");
  EXPECT_THAT(calls(), HasSubstr("cmake --build"));
}

TEST_F(Wrapper, ConfiguresAMovedCheckoutAfreshAndSaysSo) {
  EXPECT_EQ(run("../checkout/robosim").err, "");
  calls();
  fs::rename(checkout(), folder_ / "moved");
  EXPECT_EQ(run("../moved/robosim").err, "robosim: this checkout was built in " + checkout().string() +
                                             "; building it again here takes a few minutes\n");
  EXPECT_THAT(calls(), HasSubstr("cmake --preset release"));
  EXPECT_EQ(run("../moved/robosim").err, "") << "built";
}

TEST_F(Wrapper, BuildsTheChipsRunnerOnceItIsWantedAndKeepsItUpToDate) {
  run("../checkout/robosim run X --target host");
  EXPECT_THAT(calls(), Not(HasSubstr("chip")));
  run("../checkout/robosim run X --target avr");
  const std::string asked = calls();
  EXPECT_THAT(asked, testing::ContainsRegex("dpkg-query .* plenty scarce chip\n"));
  EXPECT_THAT(asked, HasSubstr("cmake --preset release"));
  EXPECT_THAT(asked, HasSubstr("--target robosim robosim-host robosim-avr\n"));
  run("../checkout/robosim run X --target=avr");
  EXPECT_EQ(calls(), "");
  write_file(checkout() / "sim/new.cpp", "");
  fs::last_write_time(checkout() / "sim/new.cpp", fs::file_time_type::clock::now() + std::chrono::hours(1));
  run("../checkout/robosim");
  EXPECT_THAT(calls(), HasSubstr("--target robosim robosim-host robosim-avr\n"));
}

TEST_F(Wrapper, BuildsTheChipsRunnerThatOneOfSeveralRobotsWants) {
  run("../checkout/robosim run A=X B=X --target B=avr");
  EXPECT_THAT(calls(), HasSubstr("--target robosim robosim-host robosim-avr\n"));
}

TEST_F(Wrapper, BuildsTheChipsRunnerThatAFileOfRobotsWants) {
  write_file(checkout() / "robots.toml", "[[agent]]\ntarget = \"avr\"\n");
  run("../checkout/robosim run " + (checkout() / "robots.toml").string());
  EXPECT_THAT(calls(), HasSubstr("--target robosim robosim-host robosim-avr\n"));
}

TEST_F(Wrapper, BuildsTheChipsRunnerThatTheRobotsOfACheckWant) {
  fs::create_directories(folder_ / "elsewhere/my/two");
  write_file(folder_ / "elsewhere/my/checks.toml", "[[check]]\nname = 'x'\nfleet = \"two/robots.toml\"\n");
  write_file(folder_ / "elsewhere/my/two/robots.toml", "[[agent]]\ntarget = \"avr\"\n");
  run("../checkout/robosim test ./my");
  EXPECT_THAT(calls(), HasSubstr("--target robosim robosim-host robosim-avr\n"));
}

TEST_F(Wrapper, BuildsTheServerOnceItIsWantedAndKeepsItUpToDate) {
  run("../checkout/robosim");
  EXPECT_THAT(calls(), Not(HasSubstr("robosim-serve")));
  run("../checkout/robosim serve");
  EXPECT_THAT(calls(), HasSubstr("--target robosim robosim-host robosim-serve\n"));
  run("../checkout/robosim serve");
  EXPECT_EQ(calls(), "");
  write_file(checkout() / "sim/new.cpp", "");
  fs::last_write_time(checkout() / "sim/new.cpp", fs::file_time_type::clock::now() + std::chrono::hours(1));
  run("../checkout/robosim");
  EXPECT_THAT(calls(), HasSubstr("--target robosim robosim-host robosim-serve\n"));
}

TEST_F(Wrapper, BuildsTheProgramForManyRunsOnceItIsWanted) {
  run("../checkout/robosim run X");
  run("../checkout/robosim map show oval");
  EXPECT_THAT(calls(), Not(HasSubstr("robosim-campaign")));
  run("../checkout/robosim sweep X");
  EXPECT_THAT(calls(), HasSubstr("--target robosim robosim-host robosim-campaign\n"));
  run("../checkout/robosim map import x.png");
  EXPECT_EQ(calls(), "");
}

TEST_F(Wrapper, TellsTheCommandWhereItIsForAServersRuns) {
  tool("cmake", R"(
      case $1 in
        --version) echo 'cmake version 3.25.1' ;;
        --preset) mkdir -p build/$2; echo >build/$2/build.ninja
                  echo "CMAKE_HOME_DIRECTORY:INTERNAL=$PWD" >build/$2/CMakeCache.txt ;;
        --build) printf '#!/bin/sh\nprintf "$ROBOSIM_WRAPPER"\n' >$2/robosim; chmod +x $2/robosim ;;
      esac)");
  EXPECT_EQ(run("../checkout/robosim run X").out, (checkout() / "robosim").string());
}

TEST_F(Wrapper, BuildsTheChipsRunnerForAFinishedProgramToo) {
  run("../checkout/robosim run my/made.elf");
  EXPECT_THAT(calls(), HasSubstr("--target robosim robosim-host robosim-avr\n"));
}

TEST_F(Wrapper, BuildsTheOtherChipsRunnerWhereThatIsWanted) {
  run("../checkout/robosim run X --target stm32");
  const std::string asked = calls();
  EXPECT_THAT(asked, testing::ContainsRegex("dpkg-query .* plenty scarce arm-kit\n"));
  EXPECT_THAT(asked, HasSubstr("--target robosim robosim-host robosim-stm32\n"));
  std::string elf(52, '\0');
  elf[18] = 40;
  write_file(folder_ / "elsewhere/made.elf", elf);
  run("../checkout/robosim run made.elf");
  EXPECT_EQ(calls(), "");
  run("../checkout/robosim run X --target avr");
  EXPECT_THAT(calls(), HasSubstr("--target robosim robosim-host robosim-avr robosim-stm32\n"));
}

TEST_F(Wrapper, BuildsTheRunnersOfAllTargetsThatACommandNames) {
  run("../checkout/robosim sweep X --map oval --target host avr stm32 --seeds 1..3");
  EXPECT_THAT(calls(),
              AllOf(HasSubstr("robosim-avr"), HasSubstr("robosim-host robosim-avr robosim-stm32\n")));
}

TEST_F(Wrapper, BuildsTheRunnersThatACompareIsFor) {
  run("../checkout/robosim compare X --target host,stm32");
  EXPECT_THAT(calls(), AllOf(HasSubstr("robosim-stm32"), Not(HasSubstr("robosim-avr"))));
  run("../checkout/robosim compare X --map avr");
  EXPECT_THAT(calls(), HasSubstr("robosim-avr")) << "compare without --target uses all targets";
}

TEST_F(Wrapper, BuildsTheRunnerOfAChipForAHunt) {
  run("../checkout/robosim hunt X --target host");
  EXPECT_THAT(calls(), Not(HasSubstr("robosim-avr")));
  run("../checkout/robosim hunt X");
  EXPECT_THAT(calls(), HasSubstr("robosim-avr")) << "most boards have an AVR";
}

TEST_F(Wrapper, BuildsAndRunsTheTests) {
  run("../checkout/robosim");
  calls();
  const Result result = run("../checkout/robosim test -N -R Golden", "checkout");
  EXPECT_EQ(result.out, checkout().string() + "\n");
  const std::string asked = calls();
  EXPECT_THAT(asked, HasSubstr(" plenty scarce check-kit chip arm-kit\n"));
  EXPECT_THAT(asked, HasSubstr("cmake --preset release -DROBOSIM_TESTS=ON\n"));
  EXPECT_THAT(asked, Not(HasSubstr("--target")));
  EXPECT_THAT(asked, testing::ContainsRegex("ctest --preset release -j [0-9]+ -N -R Golden\n"));
}

// The script prints output as ctest -V does. The output of two tests is mixed, and a failed test's output
// contains lines like ctest's own.
constexpr const char* kFourTests = R"(cat <<'END'
Test project here
test 1
    Start 1: Line.IsFollowed

1: Test command: line_test
1: Working Directory: there
1: Test timeout computed to be: 300
test 2
    Start 2: On/Line.IsLost/avr

2: Test command: line_test
1: followed
2: line_test.cpp:7: Failure
2: 2/4 Test #4: Line.IsBlack ... Passed 0.01 sec
1/4 Test #1: Line.IsFollowed ..........   Passed    0.01 sec
test 3
    Start 3: Line.IsOnAChip

3: [ RUN      ] Line.IsOnAChip
3: line_test.cpp:9: Skipped
3: the host has no chip's memory
3:
3: [  SKIPPED ] Line.IsOnAChip (0 ms)
2/4 Test #2: On/Line.IsLost/avr .......***Failed    0.02 sec
line_test.cpp:7: Failure
2/4 Test #4: Line.IsBlack ... Passed 0.01 sec

3/4 Test #3: Line.IsOnAChip ...........***Skipped   0.01 sec
    Start 4: Line.IsStraight
4: going
4/4 Test #4: Line.IsStraight ..........***Exception: SegFault  0.01 sec

50% tests passed, 2 tests failed out of 4
END
exit 8)";

TEST_F(Wrapper, SumsUpTheTestsAndShowsEachFailureWithTheCommandThatRepeatsIt) {
  tool("ctest", kFourTests);
  const Result result = run("ROBOSIM_PRESET=ci ../checkout/robosim test", "checkout");
  EXPECT_EQ(result.status, 8) << "ctest's own status";
  EXPECT_THAT(result.out, HasSubstr("FAILED  On/Line.IsLost/avr  (Failed 0.02 sec)\n"
                                    "line_test.cpp:7: Failure\n"
                                    "2/4 Test #4: Line.IsBlack ... Passed 0.01 sec\n"
                                    "repeat:  ROBOSIM_PRESET=ci ./robosim test -R '^On/Line.IsLost/avr$'\n"));
  EXPECT_THAT(result.out, HasSubstr("FAILED  Line.IsStraight  (Exception: SegFault 0.01 sec)\ngoing\n"));
  EXPECT_THAT(result.out, testing::ContainsRegex("1 passed, 2 failed, 1 skipped, in [0-9]+ s\n"
                                                 "  1 skipped: the host has no chip's memory\n"));
  EXPECT_THAT(result.out, EndsWith("complete output:  build/ci/tests.log\n"));
  EXPECT_THAT(read_file(checkout() / "build/ci/tests.log"), HasSubstr("1: followed\n"));
}

TEST_F(Wrapper, TellsOfTheTestsProgressInALineForEachTenth) {
  tool("ctest", "for i in $(seq 200); do echo \"$i/200 Test #$i: A.Test ...   Passed  0.01 sec\"; done");
  const Result result = run("../checkout/robosim test", "checkout");
  EXPECT_EQ(result.status, 0);
  EXPECT_THAT(result.out, StartsWith("  20 of 200  ·  0 failed  ·  "));
  EXPECT_EQ(std::count(result.out.begin(), result.out.end(), '\n'), 9 + 2) << result.out;
}

TEST_F(Wrapper, SumsUpWhatWasTestedUntilItWasInterrupted) {
  tool("ctest", "echo '1/9 Test #1: A.Test ...***Failed  0.01 sec'; kill -INT $PPID");
  const Result result = run("../checkout/robosim test", "checkout");
  EXPECT_EQ(result.status, 130);
  EXPECT_THAT(result.out, AllOf(HasSubstr("FAILED  A.Test"), HasSubstr("interrupted\n0 passed, 1 failed, ")));
}

TEST_F(Wrapper, ShowsWhatCtestSaysWhereItRunsNoTest) {
  tool("ctest", "echo 'No tests were found!!!'; exit 8");
  const Result result = run("../checkout/robosim test -R Nothing", "checkout");
  EXPECT_EQ(result.status, 8);
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(result.err, "No tests were found!!!\n");
}

TEST_F(Wrapper, LeavesTestToTheCommandWhereTheUserHasChecks) {
  write_file(folder_ / "elsewhere/checks.toml", "");
  EXPECT_THAT(run("../checkout/robosim test").out, EndsWith("<test>"));
}

TEST_F(Wrapper, LeavesTestToTheCommandOutsideOfTheCheckout) {
  EXPECT_THAT(run("../checkout/robosim test").out, EndsWith("<test>"));
  EXPECT_THAT(calls(), Not(HasSubstr("ctest")));
  fs::create_directories(checkout() / "docs");
  run("../../checkout/robosim test", "checkout/docs");
  EXPECT_THAT(calls(), HasSubstr("ctest"));
}

TEST_F(Wrapper, LeavesTestToTheCommandWhereTheUserNamesSketchesOrChecks) {
  fs::create_directories(folder_ / "elsewhere/pupils/anna");
  EXPECT_THAT(run("../checkout/robosim test pupils/*/").out, EndsWith("<test><pupils/anna/>"));
  EXPECT_THAT(run("../checkout/robosim test --checks class.toml X").out,
              EndsWith("<test><--checks><class.toml><X>"));
  EXPECT_THAT(run("../checkout/robosim test pupils").out, EndsWith("<test><pupils>"));
  EXPECT_THAT(run("../checkout/robosim test ./nothing").out, EndsWith("<test><./nothing>"));
  EXPECT_THAT(run("../checkout/robosim test PidFollower").out, EndsWith("<test><PidFollower>"));
  EXPECT_THAT(run("../checkout/robosim test --untrusted pupils").out,
              EndsWith("<test><--untrusted><pupils>"));
  EXPECT_THAT(run("../checkout/robosim test --jobs=2 pupils").out, EndsWith("<test><--jobs=2><pupils>"));
  EXPECT_THAT(calls(), Not(testing::AnyOf(HasSubstr("ctest"), HasSubstr("robosim-avr"))));
}

TEST_F(Wrapper, TakesTheValueOfAnOptionOfCtestForNoSketch) {
  fs::create_directories(checkout() / "grid");
  for (const char* words : {"-R grid", "-V -R grid", "-R 'grid/.*' -E grid", "--tests-regex grid -j 2",
                            "-j -R grid", "--rerun-failed", "--repeat until-fail:2 -R=grid", "-Lgrid"}) {
    run(std::string("../checkout/robosim test ") + words, "checkout");
    EXPECT_THAT(calls(), HasSubstr("ctest --preset release")) << words;
  }
}

TEST_F(Wrapper, BuildsTheChipsRunnerForChecksOnTheChip) {
  fs::create_directories(folder_ / "elsewhere/my");
  write_file(folder_ / "elsewhere/my/checks.toml", "[[check]]\nname = 'x'\ntarget = [\"host\", \"avr\"]\n");
  run("../checkout/robosim test ./my");
  EXPECT_THAT(calls(), HasSubstr("--target robosim robosim-host robosim-avr\n"));
}

TEST_F(Wrapper, WaitsForNoPipeAndNoDeviceInAPupilsFolder) {
  run("../checkout/robosim");
  for (const char* pupil : {"anna", "ben", "cleo"}) fs::create_directories(folder_ / "elsewhere" / pupil);
  ASSERT_EQ(::mkfifo((folder_ / "elsewhere/anna/checks.toml").c_str(), 0600), 0);
  fs::create_symlink("/dev/zero", folder_ / "elsewhere/ben/checks.toml");
  write_file(folder_ / "elsewhere/cleo/checks.toml", "[[check]]\nfleet = \"/dev/zero\"\n");
  ASSERT_EQ(::mkfifo((folder_ / "elsewhere/image.elf").c_str(), 0600), 0);
  for (const char* words : {"test ./anna/", "test ./ben/", "test ./cleo/", "report anna/checks.toml",
                            "run --target avr image.elf"})
    EXPECT_EQ(run(std::string("timeout 20 ../checkout/robosim ") + words).status, 4) << words;
}

TEST_F(Wrapper, InstallsWhatIsMissingAsRootAndOtherwiseSaysHow) {
  fs::remove(folder_ / "have");
  const Result result = run("../checkout/robosim");
  EXPECT_THAT(result.err, HasSubstr("apt-get install --no-install-recommends scarce\n"));
  const std::string asked = calls();
  if (::geteuid() == 0) {
    EXPECT_EQ(result.status, 4);
    EXPECT_THAT(asked, HasSubstr("apt-get install --no-install-recommends scarce -"));
  } else {
    EXPECT_EQ(result.status, 5);
    EXPECT_THAT(asked, Not(testing::AnyOf(HasSubstr("sudo"), HasSubstr("apt-get"))));
  }
  EXPECT_EQ(result.out.find("apt-get"), std::string::npos);
}

TEST_F(Wrapper, NamesThePackagesWhereNoServerAnswers) {
  fs::remove(folder_ / "have");
  tool("apt-get", "echo Err:1");
  const Result result = run("../checkout/robosim run --json");
  EXPECT_EQ(result.status, 5);
  EXPECT_EQ(result.out, "");
  EXPECT_THAT(result.err, HasSubstr("scarce\n"));
  EXPECT_THAT(calls(), Not(testing::AnyOf(HasSubstr("cmake"), HasSubstr("apt-get install"))));
}

TEST_F(Wrapper, ShowsTheEndOfAFailedBuildOnStderr) {
  tool("cmake",
       "case $1 in --version) echo cmake version 3.30.2;; --build) echo 'map.cpp:3: error'; exit 1;; esac");
  const Result result = run("../checkout/robosim run --json");
  EXPECT_EQ(result.status, 3);
  EXPECT_EQ(result.out, "");
  EXPECT_THAT(result.err, StartsWith("map.cpp:3: error\nrobosim: the build failed"));
}

TEST_F(Wrapper, ExplainsAnOldCMakeAndAnUnknownPreset) {
  EXPECT_EQ(run("ROBOSIM_PRESET=fast ../checkout/robosim").err,
            "robosim: ROBOSIM_PRESET: there is no preset 'fast'\n");
  tool("cmake", "echo cmake version 3.9.6");
  const Result result = run("../checkout/robosim");
  EXPECT_EQ(result.status, 5);
  EXPECT_THAT(result.err, HasSubstr("is version 3.9.6, and Robosim needs 3.25 or later"));
}

}  // namespace wrapper_test
