#include "sim/runner/known_hash.h"

#include <gtest/gtest.h>

#include "sim/base/error.h"
#include "sim/base/file.h"
#include "tests/support/temporary_folder.h"

namespace robosim::runner::known_hash_test {

TEST(KnownHash, IsThatOfTheFileAsItIsNow) {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "a.so";
  EXPECT_THROW(known_sha256(file), InputError);
  for (const char* content : {"one", "another one", "one"}) {
    write_file(file, content);
    EXPECT_EQ(known_sha256(file), sha256(content));
    EXPECT_EQ(known_sha256(file), sha256(content));
  }
}

TEST(KnownHash, AFileThatHasGoneIsNoLongerKnown) {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "a.so";
  write_file(file, "one");
  known_sha256(file);
  std::filesystem::remove(file);
  EXPECT_THROW(known_sha256(file), InputError);
}

}  // namespace robosim::runner::known_hash_test
