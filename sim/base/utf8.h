// Decodes and counts characters in UTF-8 text.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace robosim {

/// The bytes that some editors insert before a text to mark it as UTF-8.
inline constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
/// Returns the text without its byte order mark, if it begins with one.
inline std::string_view without_byte_order_mark(std::string_view text) {
  return text.starts_with(kByteOrderMark) ? text.substr(kByteOrderMark.size()) : text;
}

/// The first character of a text.
struct Utf8Character {
  char32_t code = 0;
  std::size_t length = 0;  ///< in bytes; 0 = the text does not start with UTF-8
};

/// Returns the first character of `text`, which must not be empty. Only well-formed UTF-8 (Unicode standard)
/// counts as a character.
Utf8Character first_character(std::string_view text);

/// Returns whether the whole text is well-formed.
bool is_utf8(std::string_view text);

/// Returns the number of characters of UTF-8 text.
std::size_t count_characters(std::string_view text);

/// Removes the last character, which may be several bytes.
void erase_last_character(std::string& text);

void append_utf8(std::string& text, char32_t code);

/// Names the character at text[at] for messages: "`é` (U+00E9)", "a tab", "a NUL byte", "the byte 0xE9, which
/// is not UTF-8".
std::string describe_character(std::string_view text, std::size_t at);

}  // namespace robosim
