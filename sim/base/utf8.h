// Characters in UTF-8 text.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace robosim {

/// A character at the beginning of a text.
struct Utf8Character {
  char32_t code = 0;
  std::size_t length = 0;  ///< in bytes; 0 = the text does not begin with UTF-8
};

/// Of a text that is not empty. Only what the Unicode standard calls well-formed is a character.
Utf8Character first_character(std::string_view text);

/// Whether all of it is.
bool is_utf8(std::string_view text);

/// The number of characters of UTF-8 text.
std::size_t count_characters(std::string_view text);

/// Takes off the last character, which may be several bytes.
void erase_last_character(std::string& text);

void append_utf8(std::string& text, char32_t code);

/// The character at text[at], as messages name it: "`é` (U+00E9)", "a tab", "a NUL byte", "the byte 0xE9,
/// which is not UTF-8".
std::string describe_character(std::string_view text, std::size_t at);

}  // namespace robosim
