// Replaces this folder's tests if Robosim is built without libdw, and therefore without target avr.

#include <gtest/gtest.h>

#include "tests/support/require_target.h"

namespace robosim::exec::missing_test {

TEST(AvrExecutor, NeedsLibdw) {
  const char* const sentence = "the target avr was left out: the Debian package libdw-dev is missing";
  if (test::is_required("avr")) FAIL() << sentence;
  GTEST_SKIP() << sentence;
}

}  // namespace robosim::exec::missing_test
