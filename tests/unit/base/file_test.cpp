#include "sim/base/file.h"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include <functional>

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

std::string error_of(const std::function<void()>& what) {
  try {
    what();
  } catch (const InputError& e) {
    return e.what();
  }
  return "no error";
}

TEST(File, ThatMayNeverEndOrNeverBeginIsNotRead) {
  const test::TemporaryFolder folder;
  const std::string pipe = (folder.path() / "pipe").string();
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(error_of([&] { read_file(pipe); }), pipe + ": cannot be read: expected a file, got a pipe");
  EXPECT_EQ(error_of([&] { sha256_of_file("/dev/zero"); }),
            "/dev/zero: cannot be read: expected a file, got a device");
}

TEST(File, IsReadUpToALimit) {
  const test::TemporaryFolder folder;
  const std::string file = (folder.path() / "file").string();
  write_file(file, std::string(2048, 'x'));
  EXPECT_EQ(read_file(file, 2048).size(), 2048u);
  EXPECT_EQ(error_of([&] { read_file(file, 2047); }),
            file + ": the file is too large: expected at most 1 KiB");
}

TEST(File, ThatIsADeviceIsWrittenAndNotReplaced) {
  write_file("/dev/null", "gone");
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
  EXPECT_EQ(error_of([] { write_file("/dev/full", "x"); }),
            "/dev/full: cannot be written: No space left on device");
}

TEST(File, HashesBySha256) {  // FIPS 180-2, appendix B.1
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

}  // namespace robosim
