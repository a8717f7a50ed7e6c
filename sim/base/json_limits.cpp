#include "sim/base/json_limits.h"

namespace robosim {

bool is_within_json_limits(std::string_view text) {
  int depth = 0;
  std::size_t values = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_string) {
      if (c == '\\') ++i;
      in_string = c != '"';
      continue;
    }
    if (c == '[' || c == '{') ++depth;
    if (c == ']' || c == '}') --depth;
    in_string = c == '"';
    values += c == '[' || c == '{' || c == ',' || c == ':';
    if (depth > kDeepestJson || values > kMostJsonValues) return false;
  }
  return true;
}

}  // namespace robosim
