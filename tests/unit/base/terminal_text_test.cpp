#include "sim/base/terminal_text.h"

#include <gtest/gtest.h>

#include <string>

namespace robosim::terminal_text_test {

TEST(TerminalText, ShowsWhatATerminalWouldCarryOut) {
  EXPECT_EQ(for_terminal("\x1b]0;title\x07\x1b[2J"), "\\x1b]0;title\\x07\\x1b[2J");
  EXPECT_EQ(for_terminal("reached\rlost"), "reached\\x0dlost")
      << "a carriage return would overwrite the line";
  EXPECT_EQ(for_terminal("a\bb\x7f\x0c"), "a\\x08b\\x7f\\x0c");
  EXPECT_EQ(for_terminal("\xC2\x9B"
                         "31m"),
            "\\x9b31m")
      << "the eight-bit form of `ESC [`";
  EXPECT_EQ(for_terminal("\x9B"
                         "31m"),
            "\\x9b31m")
      << "the eight-bit form in Latin-1";
  EXPECT_EQ(for_terminal("\u202Etxt.oni\u2069"), "\\u202etxt.oni\\u2069");
  EXPECT_EQ(for_terminal(std::string("a\0b", 3)), "a\\x00b");
}

TEST(TerminalText, KeepsTextOfAnyLanguageWithItsLines) {
  const std::string text = "größe\tλ 速度 😀\n  next\n";
  EXPECT_EQ(for_terminal(text), text);
  EXPECT_EQ(for_terminal("one\r\ntwo\r\n"), "one\ntwo\n");
}

TEST(TerminalText, WritesANameInOneLine) {
  EXPECT_EQ(in_one_line("a\nrobosim: reached\t.ino\r\n"), "a\\x0arobosim: reached\\x09.ino\\x0d\\x0a");
}

TEST(TerminalText, TakesPiecesThatCutACharacterInTwo) {
  const std::string text = "\u20AC\r\n\x1b[31m\u0085\xE2\x82 \r";
  const std::string all = for_terminal(text);
  for (std::size_t cut = 0; cut <= text.size(); ++cut) {
    TerminalText pieces;
    std::string shown = pieces.add(text.substr(0, cut));
    shown += pieces.add(text.substr(cut));
    EXPECT_EQ(shown + pieces.finish(), all) << cut;
  }
}

}  // namespace robosim::terminal_text_test
