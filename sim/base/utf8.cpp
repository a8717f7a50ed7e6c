#include "sim/base/utf8.h"

#include <fmt/format.h>

#include <algorithm>

namespace robosim {
namespace {

bool continues(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

}  // namespace

// Decodes one character with the table "well-formed UTF-8 byte sequences" of the Unicode standard (3.9, D92).
Utf8Character first_character(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char lead = byte(0);
  if (lead < 0x80) return {lead, 1};
  const std::size_t length = lead >= 0xC2 && lead < 0xE0    ? 2
                             : (lead & 0xF0) == 0xE0        ? 3
                             : lead >= 0xF0 && lead <= 0xF4 ? 4
                                                            : 0;
  if (length == 0 || text.size() < length) return {};
  char32_t code = lead & (0x7F >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if (!continues(text[i])) return {};
    code = code << 6 | (byte(i) & 0x3F);
  }
  const bool overlong = (length == 3 && code < 0x800) || (length == 4 && code < 0x10000);
  const bool surrogate = code >= 0xD800 && code < 0xE000;
  if (overlong || surrogate || code > 0x10FFFF) return {};
  return {code, length};
}

bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    const std::size_t length = first_character(text).length;
    if (length == 0) return false;
    text.remove_prefix(length);
  }
  return true;
}

std::size_t count_characters(std::string_view text) {
  return text.size() - static_cast<std::size_t>(std::count_if(text.begin(), text.end(), continues));
}

void erase_last_character(std::string& text) {
  while (!text.empty() && continues(text.back())) text.pop_back();
  if (!text.empty()) text.pop_back();
}

void append_utf8(std::string& text, char32_t code) {
  const auto tail = [&](int shift) { text += static_cast<char>(0x80 | (code >> shift & 0x3F)); };
  if (code < 0x80) {
    text += static_cast<char>(code);
  } else if (code < 0x800) {
    text += static_cast<char>(0xC0 | code >> 6);
    tail(0);
  } else if (code < 0x10000) {
    text += static_cast<char>(0xE0 | code >> 12);
    tail(6);
    tail(0);
  } else {
    text += static_cast<char>(0xF0 | code >> 18);
    tail(12);
    tail(6);
    tail(0);
  }
}

std::string describe_character(std::string_view text, std::size_t at) {
  const auto c = static_cast<unsigned char>(text[at]);
  switch (c) {
    case '\0':
      return "a NUL byte, as binary and UTF-16 files have";
    case '\t':
      return "a tab";
    case '\r':
      return "a carriage return (CR) inside a row; rows end with LF or CRLF";
    case '`':
      return "a backtick";
    default:
      break;
  }
  if (c < 0x20 || c == 0x7F) return fmt::format("the control character 0x{:02X}", c);
  if (c < 0x80) return fmt::format("`{}`", text[at]);
  const Utf8Character decoded = first_character(text.substr(at));
  if (decoded.length == 0) return fmt::format("the byte 0x{:02X}, which is not UTF-8", c);
  if (decoded.code == 0xFEFF) return "a byte order mark (U+FEFF); save the file as UTF-8 without it";
  if (decoded.code < 0xA0)
    return fmt::format("the control character U+{:04X}", static_cast<unsigned>(decoded.code));
  return fmt::format("`{}` (U+{:04X})", text.substr(at, decoded.length), static_cast<unsigned>(decoded.code));
}

}  // namespace robosim
