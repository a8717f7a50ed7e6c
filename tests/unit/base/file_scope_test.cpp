#include "sim/base/file_scope.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <functional>
#include <thread>

#include "sim/base/file.h"
#include "tests/support/temporary_folder.h"

namespace robosim::file_scope_test {

namespace fs = std::filesystem;

class FileScope : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(inside_ / "team/deep");
    fs::create_directories(outside_);
    write_file(inside_ / "team/robot.toml", "robot");
    write_file(outside_ / "secret", "secret");
  }
  /// Returns the text of the file `name`, opened through a handle on `inside_`. Returns "" if the path leads
  /// outside, or the system's message for another error.
  std::string read(const std::string& name) const {
    const HeldFolder folder(inside_);
    const Descriptor file = folder.open(name, O_RDONLY);
    if (file.is_open()) return read_file(file, name, 100);
    return errno == EXDEV ? "" : std::strerror(errno);
  }

  const test::TemporaryFolder place_;
  const fs::path inside_ = place_.path() / "inside", outside_ = place_.path() / "outside";
};

TEST_F(FileScope, ReadsWhatIsBelowAlsoByDotsAndLinksThatStayBelow) {
  fs::create_symlink("../team", inside_ / "team/up");
  fs::create_symlink(inside_ / "team", inside_ / "absolute");
  for (const char* name : {"team/robot.toml", "./team//deep/../robot.toml", "team/up/robot.toml",
                           "team/up/up/robot.toml", "absolute/robot.toml"})
    EXPECT_EQ(read(name), "robot") << name;
}

TEST_F(FileScope, NeverLeadsOut) {
  fs::create_symlink("../../outside", inside_ / "team/relative");
  fs::create_symlink(outside_, inside_ / "absolute");
  fs::create_symlink("/proc/self/cwd", inside_ / "magic");
  fs::create_symlink("absolute/secret", inside_ / "chain");
  fs::create_symlink(outside_ / "secret", inside_ / "team/file");
  fs::create_symlink(inside_.string() + "/../outside/secret", inside_ / "and-back");
  for (const char* name : {"/etc/passwd", "../outside/secret", "team/../../outside/secret",
                           "team/deep/../../../outside/secret", "team/relative/secret", "absolute/secret",
                           "absolute/../outside/secret", "magic/x", "chain", "team/file", "and-back"})
    EXPECT_EQ(read(name), "") << name;
}

TEST_F(FileScope, EndsALoopOfLinks) {
  fs::create_symlink("b", inside_ / "a");
  fs::create_symlink("a", inside_ / "b");
  EXPECT_EQ(read("a"), std::strerror(ELOOP));
}

TEST_F(FileScope, NeverLeadsOutWhileAnotherProcessSwapsAFolderForALink) {
  fs::create_directory(inside_ / "swapped");
  write_file(inside_ / "swapped/secret", "mine");
  fs::create_symlink(outside_, inside_ / "link");
  const HeldFolder folder(inside_);
  std::atomic<bool> ends{false};
  std::thread other([&] {
    const std::string a = inside_ / "swapped", b = inside_ / "link";
    while (!ends) ::renameat2(AT_FDCWD, a.c_str(), AT_FDCWD, b.c_str(), RENAME_EXCHANGE);
  });
  int read = 0;
  for (int i = 0; i < 20'000; ++i) {
    const Descriptor file = folder.open("swapped/secret", O_RDONLY);
    if (!file.is_open()) continue;
    ++read;
    EXPECT_EQ(read_file(file, "secret", 100), "mine");
  }
  ends = true;
  other.join();
  RecordProperty("read", read);
}

TEST_F(FileScope, RefusesEveryLinkOnTheWayWhereAFileIsToBeWritten) {
  fs::create_symlink("team", inside_ / "link");
  const HeldFolder folder(inside_);
  EXPECT_FALSE(folder.open("link/robot.toml", O_RDONLY, HeldFolder::Links::refused).is_open());
  EXPECT_EQ(errno, ELOOP);
  EXPECT_TRUE(folder.open("team/robot.toml", O_RDONLY, HeldFolder::Links::refused).is_open());
}

/// Restricts the files that this process may open to the file scope `folders`, and runs `holds`. Returns 0 if
/// `holds` returns true, otherwise 1. Must run in a separate process, because a file scope cannot be removed.
int in_scope(const std::vector<fs::path>& folders, const std::function<bool()>& holds) {
  const std::string variable = file_scope_variable(folders);
  ::setenv(kFileScope, variable.substr(variable.find('=') + 1).c_str(), 1);
  return holds() ? 0 : 1;
}

TEST_F(FileScope, HoldsForAllThatTheProcessReads) {
  const fs::path mine = place_.path() / "pages";
  fs::create_directory(mine);
  write_file(mine / "script", "script");
  fs::create_symlink(outside_ / "secret", inside_ / "team/link");
  const auto refused = [](const fs::path& path) {
    try {
      read_file(path);
      return false;
    } catch (const InputError& error) {
      return std::string(error.what()) ==
             "'" + path.string() + "' leads out of the served folder: expected a path inside it";
    }
  };
  EXPECT_EXIT(::_exit(in_scope({inside_, mine},
                               [&] {
                                 return read_file(inside_ / "team/robot.toml") == "robot" &&
                                        read_file(mine / "script") == "script" &&
                                        refused(outside_ / "secret") && refused("/etc/passwd") &&
                                        refused("/proc/self/environ") && refused(inside_ / "team/link") &&
                                        refused(mine / "../outside/secret") &&
                                        refused("/usr/../etc/passwd") && is_in_scope(inside_ / "not there") &&
                                        is_in_scope(inside_) && !is_in_scope(mine) &&
                                        !is_in_scope(place_.path());
                               })),
              testing::ExitedWithCode(0), "");
}

TEST_F(FileScope, HoldsWhereAProcessGivesItsDescriptorsToOthers) {
  const auto reads = [&] { return read_file(inside_ / "team/robot.toml") == "robot"; };
  EXPECT_EXIT(
      ::_exit(in_scope({inside_}, [&] { return reads() && ::close_range(3, ~0u, 0) == 0 && reads(); })),
      testing::ExitedWithCode(0), "");
}

TEST_F(FileScope, ReadsNothingWhereTheServedFolderIsGone) {
  EXPECT_EXIT(::_exit(in_scope({place_.path() / "removed"},
                               [&] {
                                 try {
                                   read_file(place_.path() / "removed/robot.toml");
                                   return false;
                                 } catch (const InputError&) {
                                   return true;
                                 }
                               })),
              testing::ExitedWithCode(0), "");
}

}  // namespace robosim::file_scope_test
