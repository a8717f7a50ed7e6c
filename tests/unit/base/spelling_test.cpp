#include "sim/base/spelling.h"

#include <gtest/gtest.h>

namespace robosim {
namespace {

TEST(Nearest, ForgivesOneSlipInAShortWordAndMoreInALongOne) {
  const std::vector<std::string> names{"oval", "figure8", "PidFollower"};
  EXPECT_EQ(nearest("ovla", names), "oval");
  EXPECT_EQ(nearest("OVAL", names), "oval");
  EXPECT_EQ(nearest("figur8", names), "figure8");
  EXPECT_EQ(nearest("pidfolower", names), "PidFollower");
  EXPECT_EQ(nearest("figu", names), "figure8");
  EXPECT_EQ(nearest("square", names), std::nullopt);
  EXPECT_EQ(nearest("", names), std::nullopt);
}

TEST(UnknownName, ListsWhatThereIs) {
  EXPECT_EQ(unknown_name("map", "x", {"d", "oval"}),
            "there is no map “x”; did you mean d? There are d and oval");
  EXPECT_EQ(unknown_name("map", "moon", {"oval"}), "there is no map “moon”; there is oval");
  EXPECT_EQ(unknown_name("map", "moon", {}), "there is no map “moon”; there are none");
}

}  // namespace
}  // namespace robosim
