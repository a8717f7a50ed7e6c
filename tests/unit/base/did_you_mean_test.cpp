#include "sim/base/did_you_mean.h"

#include <gtest/gtest.h>

namespace robosim::did_you_mean_test {

TEST(Nearest, ForgivesOneSlipInAShortWordAndMoreInALongOne) {
  const std::vector<std::string> names{"oval", "figure8", "PidFollower"};
  EXPECT_EQ(nearest("ovla", names), "oval");
  EXPECT_EQ(nearest("OVAL", names), "oval");
  EXPECT_EQ(nearest("figur8", names), "figure8");
  EXPECT_EQ(nearest("pidfolower", names), "PidFollower");
  EXPECT_EQ(nearest("figu", names), "figure8");
  EXPECT_EQ(nearest("of", {"on", "off"}), "off")
      << "of two equally similar names, the one with the same beginning";
  EXPECT_EQ(nearest("square", names), std::nullopt);
  EXPECT_EQ(nearest("", names), std::nullopt);
}

TEST(Nearest, FillsInTheParameterOfAForm) {
  const std::vector<std::string> goals{"tour", "laps:N", "station:NAME", "line-maze", "line-maze:N"};
  EXPECT_EQ(nearest("lap:3", goals), "laps:3");
  EXPECT_EQ(nearest("laps", goals), "laps:N");
  EXPECT_EQ(nearest("statoin:dock", goals), "station:dock");
  EXPECT_EQ(nearest("line-maz", goals), "line-maze");
  EXPECT_EQ(nearest("laps:x", goals), std::nullopt) << "the word is right, its parameter is not";
}

TEST(ExpectedOneOf, NamesWhatIsAllowedAndWhatWasMeant) {
  EXPECT_EQ(expected_one_of("ovla", {"oval", "tight"}),
            "expected oval or tight, got “ovla”; did you mean oval?");
  EXPECT_EQ(expected_one_of("moon", {"oval", "tight"}), "expected oval or tight, got “moon”");
}

TEST(UnknownName, ListsWhatThereIs) {
  EXPECT_EQ(unknown_name("map", "x", {"d", "oval"}), "there is no map “x”; there are d and oval")
      << "a different single letter is not a typing error";
  EXPECT_EQ(unknown_name("map", "ova", {"d", "oval"}),
            "there is no map “ova”; did you mean oval? There are d and oval");
  EXPECT_EQ(unknown_name("map", "moon", {"oval"}), "there is no map “moon”; there is oval");
  EXPECT_EQ(unknown_name("map", "moon", {}), "there is no map “moon”; there are none");
}

}  // namespace robosim::did_you_mean_test
