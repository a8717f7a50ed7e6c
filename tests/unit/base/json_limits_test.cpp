#include "sim/base/json_limits.h"

#include <gtest/gtest.h>

#include <string>

namespace robosim::json_limits_test {

std::string nested(int depth) {
  const auto count = static_cast<std::size_t>(depth);
  return std::string(count, '[') + std::string(count, ']');
}

TEST(JsonLimits, HoldForDepthAndNumberOfValues) {
  EXPECT_TRUE(is_within_json_limits(nested(kDeepestJson)));
  EXPECT_FALSE(is_within_json_limits(nested(kDeepestJson + 1)));
  EXPECT_FALSE(is_within_json_limits("{\"a\": " + nested(kDeepestJson) + "}"));
  EXPECT_TRUE(is_within_json_limits("[" + std::string(kMostJsonValues - 1, ',') + "]"));
  EXPECT_FALSE(is_within_json_limits("[" + std::string(kMostJsonValues, ',') + "]"));
}

TEST(JsonLimits, DoNotCountWhatIsInStrings) {
  EXPECT_TRUE(is_within_json_limits("[\"" + std::string(100, '[') + "\"]"));
  EXPECT_TRUE(is_within_json_limits("[\"\\\"" + std::string(100, '[') + "\"]")) << "a quote in a string";
  EXPECT_FALSE(is_within_json_limits("[\"\\\\\"," + nested(100) + "]")) << "a backslash at the string's end";
}

}  // namespace robosim::json_limits_test
