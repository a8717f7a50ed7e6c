// In place of this folder's tests where Robosim was built without the emulator.

#include <gtest/gtest.h>

#include "tests/support/require_target.h"

namespace robosim::exec {
namespace {

TEST(AvrExecutor, NeedsLibsimavr) {
  const char* const sentence =
      "the target avr was left out: the Debian packages libsimavr-dev and libdw-dev are missing";
  if (test::is_required("avr")) FAIL() << sentence;
  GTEST_SKIP() << sentence;
}

}  // namespace
}  // namespace robosim::exec
