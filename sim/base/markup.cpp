#include "sim/base/markup.h"

namespace robosim {

std::string markup_text(std::string_view text) {
  std::string markup;
  for (const char c : text) {
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
          markup += "\xEF\xBF\xBD";
        else
          markup += c;
    }
  }
  return markup;
}

}  // namespace robosim
