#include "sim/base/csv.h"

#include <gmock/gmock.h>

namespace robosim::csv_test {

using testing::ElementsAre;
using testing::Optional;

TEST(Csv, AFieldIsQuotedOnlyWhereItMustBe) {
  EXPECT_EQ(csv_field("plain text"), "plain text");
  EXPECT_EQ(csv_field("a,b"), "\"a,b\"");
  EXPECT_EQ(csv_field("a \"word\""), "\"a \"\"word\"\"\"");
  EXPECT_EQ(csv_field("two\nlines"), "\"two\nlines\"");
  EXPECT_EQ(csv_field(""), "");
}

TEST(Csv, ARowGivesItsFieldsBack) {
  EXPECT_THAT(csv_fields("1,\"a,b\",,\"a \"\"word\"\"\""),
              Optional(ElementsAre("1", "a,b", "", "a \"word\"")));
  EXPECT_THAT(csv_fields(""), Optional(ElementsAre("")));
  EXPECT_EQ(csv_fields("1,\"open"), std::nullopt);
}

}  // namespace robosim::csv_test
