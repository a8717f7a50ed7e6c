// Formats numbers as fmt does: as the shortest text that reads back as the same number. These functions take
// most of the time for writing tables and waveforms.
#pragma once

#include <fmt/compile.h>
#include <fmt/format.h>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace robosim::record {

/// The maximum length of a number, in characters.
inline constexpr std::size_t kLongestNumber = 32;

/// Writes a number, and returns the end of its text.
inline char* put_number(char* to, double number) {
  // Most readings of switches are 0.
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

/// Writes the number `steps` / 10^`decimals`, with `decimals` at most 6, without trailing zeros.
inline char* put_decimal(char* to, std::int64_t steps, int decimals) {
  constexpr std::uint64_t kPowers[] = {1, 10, 100, 1000, 10'000, 100'000, 1'000'000};
  auto size = static_cast<std::uint64_t>(steps);
  if (steps < 0) {
    *to++ = '-';
    size = 0 - size;
  }
  const std::uint64_t power = kPowers[decimals];
  const fmt::format_int whole(size / power);
  std::memcpy(to, whole.data(), whole.size());
  to += whole.size();
  std::uint64_t rest = size % power;
  if (rest == 0) return to;
  *to++ = '.';
  for (; rest % 10 == 0; rest /= 10) --decimals;
  for (char* digit = to + decimals; digit > to; rest /= 10) *--digit = static_cast<char>('0' + rest % 10);
  return to + decimals;
}

/// Formats numbers that often repeat. Caches the last text.
class LastNumber {
 public:
  char* put(char* to, double number) {
    const auto bits = std::bit_cast<std::uint64_t>(number);
    if (bits != bits_ || size_ == 0) {
      bits_ = bits;
      size_ = static_cast<std::size_t>(put_number(text_, number) - text_);
    }
    std::memcpy(to, text_, kLongestNumber);  // a fixed length is faster than the exact one
    return to + size_;
  }

 private:
  std::uint64_t bits_ = 0;
  std::size_t size_ = 0;
  char text_[kLongestNumber] = {};
};

}  // namespace robosim::record
