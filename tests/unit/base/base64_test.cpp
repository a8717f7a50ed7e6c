#include "sim/base/base64.h"

#include <gtest/gtest.h>

#include "sim/base/error.h"

namespace robosim {
namespace {

TEST(Base64, IsReadAsItWasWritten) {
  std::string bytes;
  for (int i = 0; i < 256; ++i) {
    bytes += static_cast<char>(i);
    EXPECT_EQ(from_base64(base64(bytes)), bytes);
  }
  EXPECT_EQ(base64("Man"), "TWFu");
  for (const char* bad : {"TW u", "T", "TWFuT", "TWF\xff"}) EXPECT_THROW(from_base64(bad), InputError) << bad;
}

}  // namespace
}  // namespace robosim
