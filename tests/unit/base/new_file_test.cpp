#include "sim/base/new_file.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <string>
#include <vector>

#include "sim/base/error.h"
#include "sim/base/file.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_folder.h"

namespace robosim::new_file_test {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

// A text that is longer than the write buffer in memory.
const std::string kLong(300'000, 'x');

std::vector<std::string> names_in(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename());
  return names;
}

TEST(NewFile, TakesThePlaceOfAnotherWhenItIsWhole) {
  const test::TemporaryFolder folder;
  const fs::path path = folder.path() / "file";
  for (const std::string& content : {kLong + "1", std::string("short"), kLong + "2", kLong + "3"}) {
    const std::string before = fs::exists(path) ? read_file(path) : "";
    NewFile file(path);
    file.add(content);
    EXPECT_EQ(fs::exists(path) ? read_file(path) : "", before);
    file.finish();
    EXPECT_EQ(read_file(path), content);
    EXPECT_THAT(names_in(folder.path()), ElementsAre("file"));
  }
}

TEST(NewFile, ReplacesALinkAndNotWhatItNames) {
  const test::TemporaryFolder folder;
  const fs::path path = folder.path() / "link", other = folder.path() / "other";
  write_file(other, "other");
  fs::create_symlink("other", path);
  NewFile file(path);
  file.add(kLong);
  file.finish();
  EXPECT_FALSE(fs::is_symlink(path));
  EXPECT_EQ(read_file(path), kLong);
  EXPECT_EQ(read_file(other), "other");
}

TEST(NewFile, LeavesAFolderThatHasItsNameMeanwhile) {
  const test::TemporaryFolder folder;
  const fs::path path = folder.path() / "file";
  NewFile file(path);
  file.add(kLong);
  fs::create_directory(path);
  write_file(path / "inside", "kept");
  EXPECT_THAT(test::refusal([&] { file.finish(); }), HasSubstr("cannot be written: Is a directory"));
  EXPECT_EQ(read_file(path / "inside"), "kept");
  EXPECT_THAT(names_in(folder.path()), ElementsAre("file"));
}

}  // namespace robosim::new_file_test
