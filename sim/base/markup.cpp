#include "sim/base/markup.h"

#include "sim/base/utf8.h"

namespace robosim {

std::string markup_text(std::string_view text) {
  constexpr const char* kReplacement = "\xEF\xBF\xBD";
  std::string markup;
  while (!text.empty()) {
    const char c = text[0];
    const auto [code, length] = first_character(text);
    if (length != 1) {
      const bool is_allowed = length > 0 && code != 0xFFFE && code != 0xFFFF;
      markup += is_allowed ? text.substr(0, length) : std::string_view(kReplacement);
      text.remove_prefix(length > 0 ? length : 1);
      continue;
    }
    text.remove_prefix(1);
    switch (c) {
      case '&':
        markup += "&amp;";
        break;
      case '<':
        markup += "&lt;";
        break;
      case '>':
        markup += "&gt;";
        break;
      case '"':
        markup += "&quot;";
        break;
      case '\n':
        markup += "&#10;";
        break;
      default:
        if (static_cast<unsigned char>(c) < 0x20 && c != '\t')
          markup += kReplacement;
        else
          markup += c;
    }
  }
  return markup;
}

}  // namespace robosim
