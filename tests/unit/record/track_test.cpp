#include "sim/record/track.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/base/error.h"

namespace robosim::record {
namespace track_test {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

std::string refusal_of_table(const std::string& table) {
  try {
    track_of_table(table, "log.csv");
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(ATableOfARealRobot, MayHaveAnyUnitsSeparatorsAndColumns) {
  const Track track =
      track_of_table("# my robot\nvolts;X_m;t_ms;y_cm\r\n7,4;0.5;100;2\n7,3;0,6;200;3\n", "log.csv");
  EXPECT_THAT(track.t_s, ElementsAre(0.1, 0.2));
  EXPECT_THAT(track.x_mm, ElementsAre(500, 600));
  EXPECT_THAT(track.y_mm, ElementsAre(20, 30));
  EXPECT_EQ(track.what, "a log of 0.10 s");
  const Track bare = track_of_table("t,x,y\n0,1,2\n1,2,3\n", "log.csv");
  EXPECT_THAT(bare.x_mm, ElementsAre(1, 2));
  EXPECT_EQ(bare.what, "a log of 1.00 s, x and y read as mm");
}

TEST(ATableOfARealRobot, IsRefusedWithItsLine) {
  EXPECT_THAT(refusal_of_table("a,b\n1,2\n"),
              AllOf(StartsWith("log.csv:1"), HasSubstr("the log's columns: expected time, x and y"),
                    HasSubstr("“a,b”")));
  EXPECT_THAT(refusal_of_table("t,x,y\n0,1,2\n1,,2\n"),
              AllOf(StartsWith("log.csv:3"), HasSubstr("time, x and y: expected numbers")));
  EXPECT_THAT(refusal_of_table("t,x,y\n1,1,2\n0.5,1,2\n"),
              AllOf(StartsWith("log.csv:3"), HasSubstr("goes backwards")));
  EXPECT_THAT(refusal_of_table("t,x,y\n1,1,2\n"), HasSubstr("at least two rows"));
  EXPECT_THAT(refusal_of_table(""), HasSubstr("at least two rows"));
  EXPECT_THAT(refusal_of_table("t,x,y\n0,nan,2\n1,1,2\n"), HasSubstr("time, x and y: expected numbers"));
}

TEST(TwoTracks, AreHeldAgainstEachOtherAtEqualTimes) {
  const Track one{"", {0, 1, 2, 3}, {0, 100, 200, 300}, {0, 0, 0, 0}};
  const Track other{"", {0, 2, 4}, {0, 200, 400}, {0, 0, 80}};  // is straight until 2 s, then turns away
  const Apart a = apart(one, other);
  EXPECT_EQ(a.from_1mm_s, 3.0);
  EXPECT_EQ(a.most_mm, 40.0);
  EXPECT_EQ(a.most_s, 3.0);
  EXPECT_EQ(a.mean_mm, 10.0);
  EXPECT_EQ(a.until_s, 3.0);
  EXPECT_LT(apart(one, one).from_1mm_s, 0.0) << "never";
  EXPECT_THROW(apart(one, Track{"", {7, 8}, {0, 0}, {0, 0}}), InputError);
}

}  // namespace track_test
}  // namespace robosim::record
