// Shared by the readers of C++ text here: finds where a name, a text or a character ends.
#pragma once

#include <cctype>
#include <string_view>

namespace robosim::build {

inline bool is_of_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

/// Returns where the text or character ends whose quote is at `at`; directly after that quote if it is not
/// closed in its line.
inline std::size_t end_of_quote(std::string_view source, std::size_t at) {
  for (std::size_t i = at + 1; i < source.size() && source[i] != '\n'; ++i) {
    if (source[i] == '\\')
      ++i;
    else if (source[i] == source[at])
      return i + 1;
  }
  return at + 1;
}

}  // namespace robosim::build
