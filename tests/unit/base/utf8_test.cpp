#include "sim/base/utf8.h"

#include <gtest/gtest.h>

namespace robosim::utf8_test {

TEST(Utf8, ACharacterIsWhatTheUnicodeStandardCallsWellFormed) {
  EXPECT_EQ(first_character("A").code, U'A');
  EXPECT_EQ(first_character("é!").code, U'é');
  EXPECT_EQ(first_character("é!").length, 2u);
  EXPECT_EQ(first_character("€").code, U'€');
  EXPECT_EQ(first_character("🤖").code, U'🤖');
  for (const char* bad :
       {"\xC3", "\x80", "\xC0\x80", "\xE0\x80\x80", "\xED\xA0\x80", "\xF4\x90\x80\x80", "\xFF"})
    EXPECT_EQ(first_character(bad).length, 0u);
}

TEST(Utf8, WhatIsAppendedIsReadAgain) {
  for (const char32_t code : {U'A', U'é', U'€', U'🤖'}) {
    std::string text;
    append_utf8(text, code);
    EXPECT_EQ(first_character(text).code, code);
    EXPECT_EQ(first_character(text).length, text.size());
  }
}

TEST(Utf8, CharactersAreCountedAndTakenOffWhole) {
  std::string text = "aé€🤖";
  for (std::size_t left = 4; left > 0; --left) {
    EXPECT_EQ(count_characters(text), left);
    erase_last_character(text);
  }
  EXPECT_EQ(text, "");
  erase_last_character(text);
  EXPECT_EQ(text, "");
}

}  // namespace robosim::utf8_test
