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

/// A number that is kept as a whole one, `steps`, so many `decimals` (at most 6) below it; none that is 0
/// stands at the end.
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

/// Numbers that are often the same as the one before: its text is kept.
class LastNumber {
 public:
  char* put(char* to, double number) {
    const auto bits = std::bit_cast<std::uint64_t>(number);
    if (bits != bits_ || size_ == 0) {
      bits_ = bits;
      size_ = static_cast<std::size_t>(put_number(text_, number) - text_);
    }
    std::memcpy(to, text_, kLongestNumber);  // so many are quicker than as many as there are
    return to + size_;
  }

 private:
  std::uint64_t bits_ = 0;
  std::size_t size_ = 0;
  char text_[kLongestNumber] = {};
};

}  // namespace robosim::record
