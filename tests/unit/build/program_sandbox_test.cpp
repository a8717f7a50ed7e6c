// Tests the compiler's sandbox, in which an untrusted sketch cannot make the compiler read files outside of
// the sketch's folder.
#include "sim/base/program_sandbox.h"

#include <gmock/gmock.h>

#include "sim/build/process.h"
#include "tests/unit/build/fixture.h"

namespace robosim::build {
namespace program_sandbox_test {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

class WallsTest : public SketchTest {
 protected:
  void SetUp() override {
    if (!ProgramSandbox::missing().empty()) GTEST_SKIP() << ProgramSandbox::missing();
    write("secret/secret.txt", "const int secret = 1;\n");
  }
  std::string in_a_shell(const std::string& script) const {
    std::filesystem::create_directories(folder_ / "seen");
    std::filesystem::create_directories(folder_ / "scratch");
    write("seen/seen.txt", "seen\n");
    const ProgramSandbox walls({folder_ / "seen"}, folder_ / "scratch");
    return run(Command{{"/bin/sh", "-c", script}, folder_ / "scratch", {}, {}, &walls}).output;
  }
};

TEST_F(WallsTest, ShowWhatTheyShallAndLetTheScratchFolderBeWritten) {
  EXPECT_EQ(in_a_shell("cat ../seen/seen.txt && echo new >file && cat file && echo $TMPDIR"),
            "seen\nnew\n" + (folder_ / "scratch").string() + "\n");
}

TEST_F(WallsTest, HideAllElseAndLetNothingElseBeWritten) {
  for (const char* script :
       {"cat /etc/passwd", "cat ../secret/secret.txt", "ls ../secret", "echo >../seen/seen.txt",
        "rm ../seen/seen.txt", "ln -s /etc/passwd link && cat link"})
    EXPECT_THAT(in_a_shell(script), HasSubstr("ermission denied")) << script;
}

TEST_F(WallsTest, LetProgramsReachNeitherTheNetworkNorOtherProcesses) {
  const auto in_bash = [&](const std::string& script) {
    return in_a_shell("exec /bin/bash -c '" + script + "' 2>&1");
  };
  EXPECT_THAT(in_bash("exec 3<>/dev/tcp/127.0.0.1/1"), HasSubstr("socket: Operation not permitted"));
  EXPECT_THAT(in_bash("kill -0 $PPID"), HasSubstr("Operation not permitted"));
  EXPECT_THAT(in_bash("unshare -r true"), HasSubstr("Operation not permitted"));
}

TEST_F(WallsTest, OfNamespacesLeaveNothingToRootToOpenThemWith) {
  if (!NamespaceSandbox::possible()) GTEST_SKIP() << "user namespaces are not allowed here";
  std::filesystem::create_directories(folder_ / "scratch");
  const NamespaceSandbox walls({"/usr", "/bin", "/lib", "/lib64"}, {folder_ / "scratch", "/dev/null"});
  const auto status_of = [&](const char* script) {
    return Child([&] {
             if (walls.enter()) ::execl("/bin/sh", "sh", "-c", script, nullptr);
             return 99;
           })
        .wait()
        .status;
  };
  EXPECT_EQ(status_of("test -x /usr/bin/env"), 0);
  EXPECT_EQ(status_of("/usr/sbin/chroot / /bin/true 2>/dev/null"), 125)
      << "without a capability, chroot fails";
}

TEST_F(WallsTest, LimitTimeAndMemoryOfCompilers) {
  EXPECT_EQ(in_a_shell("ulimit -t; ulimit -c; ulimit -d"), "30\n0\n221184\n");
}

TEST_F(WallsTest, MakeAnIncludeOfAFileFromOutsideOneSentence) {
  write("Reader/Reader.ino", "#include \"/etc/passwd\"\nvoid setup() {}\nvoid loop() {}\n");
  EXPECT_EQ(
      error_of("Reader"),
      "Reader.ino:1:10: /etc/passwd is not a readable file of the sketch, its project, its libraries or "
      "the core: compilers see no other files of this machine. --libraries DIR names a folder of code "
      "that sketches share");
}

TEST_F(WallsTest, MakeAnIncludeOfAFileThatDoesNotExistTheSameSentence) {
  for (const char* name : {"/etc/no-such-file", "../../../../no-such-file", "/no-such-folder/a.h"}) {
    write("Reader/Reader.ino", std::string("#include \"") + name + "\"\nvoid setup() {}\nvoid loop() {}\n");
    EXPECT_THAT(error_of("Reader"), StartsWith(std::string("Reader.ino:1:10: ") + name +
                                               " is not a readable file of the sketch"));
  }
  write("Linked/Linked.ino", "#include \"link.h\"\nvoid setup() {}\nvoid loop() {}\n");
  std::filesystem::create_symlink("/etc/no-such-file", folder_ / "Linked/link.h");
  EXPECT_THAT(error_of("Linked"), StartsWith("Linked.ino:1:10: link.h is not a readable file of the sketch"));
}

TEST_F(WallsTest, HoldForLinksInTheSketchToo) {
  write("Linked/Linked.ino", "#include \"link.h\"\nvoid setup() {}\nvoid loop() {}\n");
  std::filesystem::create_symlink(folder_ / "secret/secret.txt", folder_ / "Linked/link.h");
  EXPECT_THAT(error_of("Linked"), StartsWith("Linked.ino:1:10: link.h is not a readable file of the sketch"));
}

TEST_F(WallsTest, HoldForTheAssembler) {
  for (const char* word : {".incbin", ".include"}) {
    write("Taker/Taker.ino",
          std::string("void setup() {}\nasm(\"") + word + " \\\"/etc/passwd\\\"\");\nvoid loop() {}\n");
    EXPECT_THAT(error_of("Taker"),
                AllOf(StartsWith("asm() names a file: /etc/passwd is not a readable file of the sketch")))
        << word;
  }
}

}  // namespace program_sandbox_test
}  // namespace robosim::build
