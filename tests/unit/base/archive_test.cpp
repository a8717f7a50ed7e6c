#include "sim/base/archive.h"

#include <gmock/gmock.h>

#include "sim/base/error.h"

namespace robosim::archive_test {

TEST(Bundle, GivesBackWhatWasPackedWhateverItHolds) {
  const std::string bytes("a 3\n\0\xff", 6);
  const auto files = unpack(pack({{"one", bytes}, {"with space", ""}, {"one", "again"}}));
  ASSERT_EQ(files.size(), 3u);
  EXPECT_EQ(files[0].name, "one");
  EXPECT_EQ(files[0].content, bytes);
  EXPECT_EQ(files[1].name, "with space");
  EXPECT_EQ(files[1].content, "");
  EXPECT_EQ(files[2].content, "again");
  EXPECT_TRUE(unpack("").empty());
}

TEST(Bundle, RefusesWhatIsCutShortOrNone) {
  EXPECT_THROW(unpack("one 4\nabc"), InputError);
  EXPECT_THROW(unpack("one 4"), InputError);
  EXPECT_THROW(unpack("one\nabc"), InputError);
  EXPECT_THROW(unpack("one -1\nabc"), InputError);
}

}  // namespace robosim::archive_test
