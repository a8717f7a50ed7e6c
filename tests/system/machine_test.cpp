// Tests that messages name the right cause: a feature that the machine lacks, a closed stream, or a path that
// is not a file.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cstdlib>

#include "tests/support/require_target.h"
#include "tests/system/command.h"

namespace robosim::test {
namespace machine_test {

using ::testing::AllOf;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;

/// Runs `robosim WORDS` after other commands in a shell, in a folder with the sketch S.
class Machine : public ::testing::Test {
 protected:
  void SetUp() override { folder_.write("S/S.ino", "void setup() {}\nvoid loop() {}\n"); }

  Ended after(const std::string& before, const std::string& words) const {
    return robosim_command({"-c", before + " " + ROBOSIM_COMMAND + " " + words}, folder_.path(), nullptr,
                           "/dev/null", "/bin/bash");
  }
  const std::string run_ = "run ./S --map oval --robot uno5 --goal none --for 10ms";
  Folder folder_;
};

TEST_F(Machine, WithAStandardErrorThatIsClosedOrFullEndsWithTheSameStatus) {
  EXPECT_EQ(after("", "run ./S --map oval --robot nosuch 2>&-").status, 2);
  EXPECT_EQ(after("", "run ./S --map oval --robot nosuch 2>/dev/full").status, 2);
  EXPECT_EQ(after("", run_ + " 2>&-").status, 0);
  const Ended silent = after("", run_ + " >&-");
  EXPECT_EQ(silent.status, 2);
  EXPECT_THAT(silent.err, HasSubstr("cannot write to standard output"));
}

TEST_F(Machine, WithTooFewFilesIsToldSo) {
  const Ended ended = after("ulimit -n 6;", run_);
  EXPECT_EQ(ended.status, 5);
  EXPECT_EQ(
      ended.err,
      "robosim: too many files are open: at most 6 are allowed here; raise the limit with ulimit -n 256\n");
}

TEST_F(Machine, WithTooLowALimitOnFilesIsToldSo) {
  const auto limited = [&] { return after("ulimit -f 100;", run_); };
  const Ended ended = limited();
  EXPECT_EQ(ended.status, 5);
  EXPECT_THAT(ended.err, HasSubstr("the file is too large: at most 102400 bytes are allowed here; raise the "
                                   "limit with ulimit -f unlimited"));
  EXPECT_EQ(after("", run_).status, 0);
  const Ended built = limited();
  EXPECT_EQ(built.status, 5);
  EXPECT_EQ(built.err,
            "robosim: the file is too large: at most 102400 bytes are allowed here; raise the limit with "
            "ulimit -f unlimited\n");
}

TEST_F(Machine, WithASmallStackRunsWhatItHasBuilt) {
  EXPECT_EQ(after("", run_).status, 0);
  const Ended ended = after("ulimit -s 64;", run_);
  EXPECT_EQ(ended.status, 0) << ended.err;
}

TEST_F(Machine, WithoutDevNullIsToldSo) {
  const std::string without = "mkdir -p dev; unshare -mr bash -c 'mount --bind dev /dev && exec \"$@\"' -";
  if (after(without, "--version").status != 0) GTEST_SKIP() << "no mount can be made here";
  for (int time = 0; time < 2; ++time) {
    const Ended ended = after(without, run_);
    EXPECT_EQ(ended.status, 5);
    EXPECT_THAT(ended.err, HasSubstr("/dev/null is missing or cannot be opened"));
    EXPECT_EQ(after("", run_).status, 0) << "this run builds the image for the next round";
  }
}

TEST_F(Machine, WithoutAnAssemblerIsToldSo) {
  for (const char* tool :
       {"arduino-ctags", "g++", "gcc", "nm", "objcopy", "x86_64-linux-gnu-g++", "x86_64-linux-gnu-gcc"}) {
    const std::string path = "/usr/bin/" + std::string(tool);
    if (std::filesystem::exists(path)) {
      std::filesystem::create_directories(folder_ / "bin");
      std::filesystem::create_symlink(path, folder_ / (std::string("bin/") + tool));
    }
  }
  const Ended ended = after("PATH=$PWD/bin", run_);
  EXPECT_EQ(ended.status, 5) << ended.err;
  EXPECT_THAT(ended.err, HasSubstr("failed: as is missing: sudo apt install binutils"));
}

TEST_F(Machine, CompilesWhateverFolderForTemporaryFilesIsSet) {
  for (const char* folder : {"/nonexistent", "/tmp", "."}) {
    folder_.write("S/S.ino", std::string("// ") + folder + "\nvoid setup() {}\nvoid loop() {}\n");
    const Ended ended = after(std::string("TMPDIR=") + folder, run_);
    EXPECT_EQ(ended.status, 0) << folder << ": " << ended.err;
  }
}

TEST_F(Machine, ReadsNoDeviceAndNoPipeWhateverItIsGivenFor) {
  ASSERT_EQ(::mkfifo((folder_ / "pipe").c_str(), 0600), 0);
  for (const char* place : {"/dev/zero", "./pipe"}) {
    const std::string file = place;
    for (const std::string& words :
         {"run ./S --map oval --robot " + file, "run ./S --robot uno5 --map " + file,
          "run ./S --map oval --robot uno5 --script " + file, "test ./S --checks " + file}) {
      const Ended ended = after("", words);
      EXPECT_EQ(ended.status, 2) << words;
      EXPECT_THAT(ended.err, HasSubstr(file + ": cannot be read: expected a file, got a ")) << words;
    }
    EXPECT_EQ(after("", "run " + file + " --map oval --robot uno5").status, 2);
  }
}

// A program for a chip can claim that parts of its debug information are in another file.
TEST_F(Machine, OpensNoOtherFileForTheDebugInformationOfAProgram) {
  ROBOSIM_NEEDS_TARGET("avr");
  ASSERT_EQ(::mkfifo((folder_ / "pipe").c_str(), 0600), 0);
  folder_.write("S/x.S",
                ".section .gnu_debugaltlink,\"\",@progbits\n.asciz \"" + (folder_ / "pipe").string() +
                    "\"\n.skip 20\n"
                    ".section .debug_abbrev,\"\",@progbits\n.Labbrev:\n"
                    ".uleb128 1, 0x11\n.byte 1\n.uleb128 0x11, 1, 0x12, 6, 0, 0\n"
                    ".uleb128 2, 0x2e\n.byte 0\n.uleb128 3, 0x1f21, 0x11, 1, 0x12, 6, 0, 0, 0\n"
                    ".section .debug_info,\"\",@progbits\n.long 1f-0f\n0: .short 4\n.long .Labbrev\n.byte 4\n"
                    ".uleb128 1\n.long 0, 0x7fff\n"
                    ".uleb128 2\n.long 0, 0, 0x7fff\n.byte 0\n1:\n");
  const Ended ended = after("", run_ + " --target avr");
  EXPECT_EQ(ended.status, 0) << ended.err;
}

TEST_F(Machine, SaysThatANameIsNotUtf8) {
  const Ended ended = after("cp -r S $'r\\xff.toml';", "run ./S --map oval --robot $'./r\\xff.toml'");
  EXPECT_EQ(ended.status, 2);
  EXPECT_THAT(ended.err, EndsWith("cannot be used: the name of a file must be UTF-8\n"));
}

TEST_F(Machine, WithAFullDiskStillGivesTheVerdictOfARunThatItCannotRecord) {
  const Ended ended = after("ln -s /dev/full full.csv;", run_ + " --record full.csv");
  EXPECT_EQ(ended.status, 2);
  EXPECT_THAT(ended.out, HasSubstr("without a failure"));
  EXPECT_THAT(ended.err, EndsWith("full.csv: cannot be written: No space left on device\n"));
}

TEST_F(Machine, RefusesASecondWriterOfARecording) {
  const Ended ended = after("", run_ + " --record a.csv --record ./a.csv");
  EXPECT_EQ(ended.status, 2);
  EXPECT_THAT(ended.err, HasSubstr("a.csv: this file is already being written"));
}

}  // namespace machine_test
}  // namespace robosim::test
