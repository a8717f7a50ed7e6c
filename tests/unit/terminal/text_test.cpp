#include "sim/view/terminal/text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace robosim::terminal {
namespace text_test {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(Text, WrapsBetweenWordsAndKeepsALongWordWhole) {
  EXPECT_THAT(wrap("one two three", 7), ElementsAre("one two", "three"));
  EXPECT_THAT(wrap("a incomprehensible b", 4), ElementsAre("a", "incomprehensible", "b"));
  EXPECT_THAT(wrap("“é” “é”", 7), ElementsAre("“é” “é”"));
  EXPECT_THAT(wrap("", 7), IsEmpty());
}

TEST(Text, LastLinesLoseCarriageReturnsAndTheFinalLineFeed) {
  EXPECT_THAT(last_lines("a\r\nb\r\nc\r\n", 2), ElementsAre("b", "c"));
  EXPECT_THAT(last_lines("a\nb", 5), ElementsAre("a", "b"));
  EXPECT_THAT(last_lines("a\n\n", 2), ElementsAre("a", ""));
  EXPECT_THAT(last_lines("", 2), IsEmpty());
}

TEST(Text, ABarFillsInEighths) {
  EXPECT_EQ(bar(0.0, 3, true), U"   ");
  EXPECT_EQ(bar(0.5, 3, true), U"█▌ ");
  EXPECT_EQ(bar(1.0, 3, true), U"███");
  EXPECT_EQ(bar(7.0, 3, true), U"███");
  EXPECT_EQ(bar(-1.0, 2, true), U"  ");
  EXPECT_EQ(bar(0.5, 4, false), U"##  ");
}

TEST(Text, TimesReadAsPeopleSayThem) {
  EXPECT_EQ(time_text(12.344), "12.34 s");
  EXPECT_EQ(time_text(119.96), "2 min 0.0 s");
  EXPECT_EQ(time_text(600), "10 min 0.0 s");
}

}  // namespace text_test
}  // namespace robosim::terminal
