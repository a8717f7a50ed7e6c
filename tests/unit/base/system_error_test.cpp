#include "sim/base/system_error.h"

#include <gmock/gmock.h>

#include <cerrno>
#include <new>
#include <system_error>

namespace robosim::system_error_test {

using ::testing::HasSubstr;

TEST(MachineFault, IsWhatAMachineHasTooLittleOf) {
  const auto fault = [](int error) {
    return system_error_of(std::system_error(error, std::generic_category(), "no pipe"));
  };
  EXPECT_THAT(fault(EMFILE), HasSubstr("too many files are open: at most "));
  EXPECT_EQ(fault(ENOSPC), "there is no room left on the disk");
  EXPECT_EQ(fault(EAGAIN), "cannot start more processes; raise the limit with ulimit -u");
  EXPECT_EQ(system_error_of(std::bad_alloc()), "there is not enough memory");
  EXPECT_EQ(fault(ENOENT), "");
  EXPECT_EQ(system_error_of(std::runtime_error("x")), "");
}

TEST(MachineFault, IsToldFromWhatIsWrongWithASketch) {
  const auto fault = [](const char* output) { return system_error_of("the compiler", output); };
  EXPECT_EQ(
      fault("x\nx86_64-linux-gnu-gcc: fatal error: cannot execute 'as': execvp: No such file or directory\n"),
      "the compiler failed: as is missing: sudo apt install binutils");
  EXPECT_EQ(fault("collect2: fatal error: cannot find 'ld'\n"),
            "the compiler failed: ld is missing: sudo apt install binutils");
  EXPECT_EQ(fault("/usr/bin/ld.bfd: core.o: final close failed: No space left on device"),
            "the compiler failed: there is no room left on the disk");
  EXPECT_THAT(fault("cannot find -lgcc: Too many open files"), HasSubstr("too many files are open"));
  EXPECT_THAT(fault("arduino-ctags: cannot open temporary file : No such file or directory"),
              HasSubstr("cannot create a temporary file in "));
  EXPECT_EQ(fault("g++: fatal error: Killed signal terminated program cc1plus"),
            "the compiler failed: there is not enough memory");
  EXPECT_EQ(
      fault("S.ino:1:2: error: #error No space left on device\n    1 | #error No space left on device\n"),
      "");
  for (const char* forged :
       {"S.ino:1:2: error: call to 'f' declared with attribute error: No space left on device",
        "S.ino:1:2: warning: Too many open files [-Wdeprecated]",
        "S.ino:1:10: fatal error: Too many open files: No such file or directory",
        "{standard input}:7: Error: No space left on device"})
    EXPECT_EQ(fault(forged), "") << forged;
  EXPECT_EQ(fault("S.ino:1:2: fatal error: error writing to /tmp/x.s: No space left on device"),
            "the compiler failed: there is no room left on the disk");
  EXPECT_EQ(fault("S.ino:1:2: error: expected ';' before '}' token\n"), "");
  // The first output quotes a source line as gcc 5 for the AVR does. The second output contains text from
  // the sketch.
  EXPECT_EQ(fault("S.ino:1:1: error: static assertion failed: cannot execute 'ld'\n static_assert(false, "
                  "\"cannot execute "
                  "'ld'\");\n ^\n"),
            "");
  EXPECT_EQ(fault("S.ino:1:9: note: #pragma message: Cannot allocate memory\n"), "");
  EXPECT_EQ(fault("  avr-g++: fatal error: cannot execute 'as': execvp: No such file or directory\n"),
            "the compiler failed: as is missing: sudo apt install binutils");
}

}  // namespace robosim::system_error_test
