#include "sim/base/base64.h"

#include <gtest/gtest.h>

#include "sim/base/error.h"

namespace robosim::base64_test {

TEST(Base64, IsReadAsItWasWritten) {
  std::string bytes;
  for (int i = 0; i < 256; ++i) {
    bytes += static_cast<char>(i);
    EXPECT_EQ(from_base64(base64(bytes)), bytes);
  }
  EXPECT_EQ(base64("Man"), "TWFu");
  for (const char* bad : {"TW u", "T", "TWFuT", "TWF\xff"}) EXPECT_THROW(from_base64(bad), InputError) << bad;
}

TEST(Base64, IsTheSamePieceByPiece) {
  const std::string bytes = "any carnal pleas\xFF\0ure.";
  for (std::size_t first = 0; first <= bytes.size(); ++first) {
    for (std::size_t second = first; second <= bytes.size(); ++second) {
      std::string text(100, '?');
      Base64 writer;
      char* to = writer.put(text.data(), std::string_view(bytes).substr(0, first));
      to = writer.put(to, std::string_view(bytes).substr(first, second - first));
      to = writer.finish(writer.put(to, std::string_view(bytes).substr(second)));
      text.resize(static_cast<std::size_t>(to - text.data()));
      EXPECT_EQ(text, base64(bytes)) << first << ", " << second;
    }
  }
}

}  // namespace robosim::base64_test
