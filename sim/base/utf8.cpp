#include "sim/base/utf8.h"

#include <fmt/format.h>

namespace robosim::grid {
namespace {

struct Decoded {
  char32_t code = 0;
  std::size_t length = 0;  // bytes; 0 = not UTF-8
};

// One character by the table "well-formed UTF-8 byte sequences" of the Unicode standard (3.9, D92).
Decoded decode(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char lead = byte(0);
  const std::size_t length = lead >= 0xC2 && lead < 0xE0    ? 2
                             : (lead & 0xF0) == 0xE0        ? 3
                             : lead >= 0xF0 && lead <= 0xF4 ? 4
                                                            : 0;
  if (length == 0 || text.size() < length) return {};
  char32_t code = lead & (0x7F >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return {};
    code = code << 6 | (byte(i) & 0x3F);
  }
  const bool overlong = (length == 3 && code < 0x800) || (length == 4 && code < 0x10000);
  const bool surrogate = code >= 0xD800 && code < 0xE000;
  if (overlong || surrogate || code > 0x10FFFF) return {};
  return {code, length};
}

}  // namespace

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
  const Decoded decoded = decode(text.substr(at));
  if (decoded.length == 0) return fmt::format("the byte 0x{:02X}, which is not UTF-8", c);
  if (decoded.code == 0xFEFF) return "a byte order mark (U+FEFF); save the file as UTF-8 without it";
  if (decoded.code < 0xA0)
    return fmt::format("the control character U+{:04X}", static_cast<unsigned>(decoded.code));
  return fmt::format("`{}` (U+{:04X})", text.substr(at, decoded.length), static_cast<unsigned>(decoded.code));
}

}  // namespace robosim::grid
