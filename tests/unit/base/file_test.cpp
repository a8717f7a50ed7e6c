#include "sim/base/file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/base/error.h"
#include "tests/support/temporary_folder.h"

namespace robosim {

TEST(File, WritesAndReadsBack) {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "file";
  write_file(path, std::string_view("a\0b\n", 4));
  EXPECT_EQ(read_file(path), std::string("a\0b\n", 4));
}

TEST(File, SaysWhichFileCannotBeReadAndWhy) {
  try {
    read_file("/nonexistent/x");
    FAIL();
  } catch (const InputError& e) {
    EXPECT_STREQ(e.what(), "/nonexistent/x: cannot be read: No such file or directory");
  }
  EXPECT_THROW(read_file("/"), InputError);
}

TEST(File, HashesBySha256) {  // FIPS 180-2, appendix B.1
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

}  // namespace robosim
