#include "hal/board/board_spec.h"

#include <gtest/gtest.h>

namespace robosim {

TEST(BoardSpec, FindsPinsByEveryNamePeopleUse) {
  const BoardSpec& uno = *find_board("uno");
  EXPECT_EQ(find_pin(uno, "5"), 5);
  EXPECT_EQ(find_pin(uno, "D5"), 5);
  EXPECT_EQ(find_pin(uno, "a0"), 14);
  EXPECT_EQ(find_pin(uno, "PB5"), 13);
  EXPECT_EQ(find_pin(uno, "14"), 14);
  EXPECT_EQ(find_pin(uno, "20"), kNoPin);
  EXPECT_EQ(find_pin(uno, "A6"), kNoPin);
  EXPECT_EQ(find_pin(uno, ""), kNoPin);
  EXPECT_EQ(find_pin(*find_board("nano"), "A6"), 20);
}

TEST(BoardSpec, KnowsNoOtherBoards) { EXPECT_EQ(find_board("mega"), nullptr); }

}  // namespace robosim
