// Numbers as text, as fmt has them: the shortest that are read back to the last bit. Of tables and waves most
// of the time goes into these.
#pragma once

#include <fmt/compile.h>
#include <fmt/format.h>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace robosim::record {

/// No number takes more characters.
inline constexpr std::size_t kLongestNumber = 32;

/// Writes it, and gives where it ends.
inline char* put_number(char* to, double number) {
  // What switches are, mostly.
  if (std::bit_cast<std::uint64_t>(number) == 0) {
    *to = '0';
  } else if (number == 1.0) {
    *to = '1';
  } else {
    return fmt::format_to(to, FMT_COMPILE("{}"), number);
  }
  return to + 1;
}

inline char* put_number(char* to, std::int64_t number) {
  const fmt::format_int text(number);
  std::memcpy(to, text.data(), text.size());
  return to + text.size();
}

}  // namespace robosim::record
