#include "sim/view/terminal/frame.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/unit/terminal/terminal_looks.h"

namespace robosim::terminal {
namespace frame_test {

TEST(Frame, TextIsCutAtTheEdgeAndLinesLoseTheirTrailingBlanks) {
  Frame frame(5, 2);
  EXPECT_EQ(frame.put(3, 0, "abc"), 6);
  frame.put(0, 1, "x  ");
  EXPECT_EQ(to_text(frame, kPlain), "   ab\nx\n");
}

TEST(Frame, ColoursAreWrittenOnlyWhereWantedAndSwitchedOffAtTheEndOfALine) {
  Frame frame(4, 1);
  frame.put(0, 0, "a", Ink::good);
  frame.put(1, 0, "b", Ink::good);
  EXPECT_EQ(to_text(frame, kPlain), "ab\n");
  EXPECT_EQ(to_text(frame, kColour), "\033[0;1;32mab\033[0m\n");
}

TEST(Frame, AsciiReplacesWhatATerminalWithoutUtf8CannotShow) {
  Frame frame(12, 1);
  frame.put(0, 0, "⣿░·→↑←↓×“é");
  EXPECT_EQ(to_text(frame, kAscii), "*#.>^<vx\"?\n");
}

TEST(Frame, NoControlCharacterOfASketchReachesTheTerminal) {
  Frame frame(20, 1);
  frame.put(0, 0, "a\033[2Jb\x07\tc\xff\xc3");
  EXPECT_EQ(to_text(frame, kPlain), "a?[2Jb? c??\n");
}

TEST(Frame, WideAndCombiningCharactersCountAsOneColumn) { EXPECT_EQ(printable("日é\u0301ж"), U"?é?ж"); }

TEST(Changes, OnlyWhatDiffersIsWritten) {
  Frame before(10, 3), after(10, 3);
  before.put(0, 1, "abcdef");
  after.put(0, 1, "abXYef");
  EXPECT_EQ(changes(before, after, kPlain), "\033[2;3HXY");
  EXPECT_EQ(changes(after, after, kPlain), "");
}

TEST(Changes, ADisappearingCharacterIsOverwrittenByABlank) {
  Frame before(4, 1), after(4, 1);
  before.put(1, 0, "a");
  EXPECT_EQ(changes(before, after, kPlain), "\033[1;2H ");
}

TEST(Changes, AnotherSizeDrawsEverythingAfresh) {
  Frame after(3, 2);
  after.put(1, 1, "a", Ink::bad);
  EXPECT_EQ(changes(Frame(2, 2), after, kColour), "\033[0m\033[2J\033[2;2H\033[0;1;31ma\033[0m");
}

TEST(Look, FollowsTheLocaleInItsOrderOfPrecedenceAndNoColor) {
  for (const char* name : {"LC_ALL", "LC_CTYPE", "LANG", "NO_COLOR"}) ::unsetenv(name);
  ::setenv("TERM", "xterm", 1);
  EXPECT_FALSE(look_from_environment(true).utf8);
  ::setenv("LANG", "de_DE.UTF-8", 1);
  EXPECT_TRUE(look_from_environment(true).utf8);
  ::setenv("LC_ALL", "C", 1);
  EXPECT_FALSE(look_from_environment(true).utf8);
  ::setenv("LC_ALL", "C.utf8", 1);
  EXPECT_TRUE(look_from_environment(true).utf8);
  EXPECT_TRUE(look_from_environment(true).colour);
  EXPECT_FALSE(look_from_environment(false).colour);
  ::setenv("NO_COLOR", "1", 1);
  EXPECT_FALSE(look_from_environment(true).colour);
  ::unsetenv("NO_COLOR");
  ::setenv("TERM", "dumb", 1);
  EXPECT_FALSE(look_from_environment(true).colour);
}

}  // namespace frame_test
}  // namespace robosim::terminal
