#include "sim/base/terminal_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "sim/base/utf8.h"

namespace robosim {
namespace {

constexpr std::size_t kLongestCharacter = 4;  // bytes of UTF-8

bool turns_direction(char32_t c) {
  return c == 0x61C || c == 0x200E || c == 0x200F || (c >= 0x202A && c <= 0x202E) ||
         (c >= 0x2066 && c <= 0x2069);
}

/// Returns whether a character separates lines, or starts a command on some terminals.
bool is_command(char32_t c) {
  return c < 0x20 || (c >= 0x7F && c < 0xA0) || c == 0x2028 || c == 0x2029 || c == 0xFEFF;
}

std::string visible(std::string_view text, std::string_view kept) {
  std::string result;
  result.reserve(text.size());
  while (!text.empty()) {
    const auto [code, length] = first_character(text);
    const std::size_t size = std::max<std::size_t>(length, 1);
    const bool is_line_end = text.starts_with("\r\n") && kept.find('\n') != kept.npos;
    if (length == 0)
      result += fmt::format("\\x{:02x}", static_cast<unsigned char>(text[0]));
    else if (length == 1 && kept.find(text[0]) != kept.npos)
      result += text[0];
    else if (is_command(code) || turns_direction(code))
      result += is_line_end    ? ""
                : code < 0x100 ? fmt::format("\\x{:02x}", static_cast<unsigned>(code))
                               : fmt::format("\\u{:04x}", static_cast<unsigned>(code));
    else
      result += text.substr(0, size);
    text.remove_prefix(size);
  }
  return result;
}

/// Returns the number of bytes at the end that may be the start of a character, or of CR LF.
std::size_t unfinished(std::string_view text) {
  if (text.ends_with('\r')) return 1;
  for (std::size_t size = 1; size < std::min(kLongestCharacter, text.size() + 1); ++size) {
    const auto lead = static_cast<unsigned char>(text[text.size() - size]);
    if ((lead & 0xC0) == 0x80) continue;
    const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : lead >= 0xC0 ? 2 : 1;
    return length > size ? size : 0;
  }
  return 0;
}

}  // namespace

std::string for_terminal(std::string_view text) { return visible(text, "\n\t"); }

std::string in_one_line(std::string_view text) { return visible(text, ""); }

std::string TerminalText::add(std::string_view piece) {
  held_ += piece;
  const std::string all = std::exchange(held_, {});
  const std::string_view whole(all.data(), all.size() - unfinished(all));
  held_ = all.substr(whole.size());
  return for_terminal(whole);
}

std::string TerminalText::finish() { return for_terminal(std::exchange(held_, {})); }

}  // namespace robosim
