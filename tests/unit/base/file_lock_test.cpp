#include "sim/base/file_lock.h"

#include <gmock/gmock.h>

#include <csignal>

#include "sim/base/child.h"
#include "sim/base/error.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_folder.h"

namespace robosim::file_lock_test {

namespace fs = std::filesystem;

TEST(FileLock, HoldsAgainstOtherProcessesAndOtherNamesOfTheFile) {
  const test::TemporaryFolder folder;
  const FileLock claim(folder.path() / "a.csv");
  const auto is_refused = [&](const fs::path& name) {
    return Child([&] {
             try {
               const FileLock second(name);
               return 0;
             } catch (const InputError&) {
               return 7;
             }
           })
               .wait()
               .status == 7;
  };
  EXPECT_TRUE(is_refused(folder.path() / "a.csv"));
  fs::create_directory(folder.path() / "b");
  EXPECT_TRUE(is_refused(folder.path() / "b/../a.csv"));
  fs::create_directory_symlink(folder.path(), folder.path() / "c");
  EXPECT_TRUE(is_refused(folder.path() / "c/a.csv"));
  EXPECT_FALSE(is_refused(folder.path() / "d.csv"));
}

TEST(FileLock, EndsWithItsProcessAndLeavesNothingBehind) {
  const test::TemporaryFolder folder;
  const fs::path file = folder.path() / "a.csv";
  Child([&] {
    const FileLock claim(file);
    ::raise(SIGKILL);
    return 0;
  }).wait();
  EXPECT_NO_THROW(FileLock{file});
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(FileLock, IsRefusedWhereTheFileCannotBeWritten) {
  const test::TemporaryFolder folder;
  const auto refusal = [](const fs::path& file) -> std::string {
    return test::refusal([&] { const FileLock claim(file); }, "");
  };
  EXPECT_THAT(refusal(folder.path() / "none/a.csv"),
              testing::HasSubstr("none does not exist; create it first"));
  EXPECT_THAT(refusal(folder.path()), testing::HasSubstr("expected the name of a file, got a folder"));
  EXPECT_EQ(refusal(folder.path() / "a.csv"), "");
}

TEST(FileLock, IsNotNeededForADevice) {
  const FileLock first("/dev/null");
  EXPECT_NO_THROW(FileLock("/dev/null"));
}

}  // namespace robosim::file_lock_test
