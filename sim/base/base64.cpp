#include "sim/base/base64.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

#include "sim/base/error.h"

namespace robosim {
namespace {

constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

// The two base64 digits of each 12-bit value.
constexpr auto kPairs = [] {
  std::array<std::array<char, 2>, 4096> pairs{};
  for (std::size_t bits = 0; bits < pairs.size(); ++bits)
    pairs[bits] = {kDigits[bits >> 6], kDigits[bits & 63]};
  return pairs;
}();

// The bits that each character contributes at each of the four positions in a group; kBad for an invalid
// character.
constexpr std::uint32_t kBad = 1u << 24;
constexpr auto kValues = [] {
  std::array<std::array<std::uint32_t, 256>, 4> values{};
  for (std::size_t place = 0; place < 4; ++place) {
    for (std::uint32_t& value : values[place]) value = kBad;
    for (std::uint32_t i = 0; i < 64; ++i)
      values[place][static_cast<std::uint8_t>(kDigits[i])] = i << (18 - 6 * place);
  }
  return values;
}();

}  // namespace

char* Base64::put(char* to, std::string_view bytes) {
  const auto put_group = [&to](const char* group) {
    const auto byte = [group](int i) { return std::uint32_t{static_cast<std::uint8_t>(group[i])}; };
    const std::uint32_t bits = byte(0) << 16 | byte(1) << 8 | byte(2);
    std::memcpy(to, kPairs[bits >> 12].data(), 2);
    std::memcpy(to + 2, kPairs[bits & 4095].data(), 2);
    to += 4;
  };
  if (left_size_ > 0) {
    const std::size_t more = std::min(sizeof left_ - left_size_, bytes.size());
    std::copy_n(bytes.data(), more, left_ + left_size_);
    left_size_ += more;
    bytes.remove_prefix(more);
    if (left_size_ < sizeof left_) return to;
    put_group(left_);
  }
  const char* from = bytes.data();
  const char* const end = from + bytes.size() / 3 * 3;
  // Encodes two groups of three bytes per 8-byte load.
  for (; static_cast<std::size_t>(bytes.data() + bytes.size() - from) >= sizeof(std::uint64_t); from += 6) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, from, sizeof bits);
    if constexpr (std::endian::native == std::endian::little) bits = __builtin_bswap64(bits);
    for (const int place : {52, 40, 28, 16}) {
      std::memcpy(to, kPairs[bits >> place & 4095].data(), 2);
      to += 2;
    }
  }
  for (; from != end; from += 3) put_group(from);
  left_size_ = bytes.size() % 3;
  std::copy_n(from, left_size_, left_);
  return to;
}

char* Base64::finish(char* to) {
  if (left_size_ == 0) return to;
  const std::size_t digits = left_size_ + 1;
  std::fill(left_ + left_size_, left_ + sizeof left_, '\0');
  char* const end = put(to, {left_ + left_size_, sizeof left_ - left_size_});
  std::fill(to + digits, end, '=');
  return end;
}

std::string base64(std::string_view bytes) {
  std::string text(Base64::most(bytes.size()), '\0');
  Base64 writer;
  text.resize(static_cast<std::size_t>(writer.finish(writer.put(text.data(), bytes)) - text.data()));
  return text;
}

std::string from_base64(std::string_view text) {
  while (!text.empty() && text.back() == '=') text.remove_suffix(1);
  std::string bytes(text.size() * 3 / 4, '\0');
  char* to = bytes.data();
  std::uint32_t bad = 0;  // an invalid character sets the bit kBad
  const auto value = [&](std::size_t i, std::size_t place) {
    return kValues[place][static_cast<std::uint8_t>(text[i])];
  };
  std::size_t i = 0;
  for (; i + 4 <= text.size(); i += 4) {
    const std::uint32_t group = value(i, 0) | value(i + 1, 1) | value(i + 2, 2) | value(i + 3, 3);
    bad |= group;
    *to++ = static_cast<char>(group >> 16);
    *to++ = static_cast<char>(group >> 8);
    *to++ = static_cast<char>(group);
  }
  const std::size_t left = text.size() - i;
  if (left == 1) bad = kBad;  // a single digit has only six bits, less than a byte
  if (left >= 2) {
    const std::uint32_t group = value(i, 0) | value(i + 1, 1) | (left == 3 ? value(i + 2, 2) : 0);
    bad |= group;
    *to++ = static_cast<char>(group >> 16);
    if (left == 3) *to++ = static_cast<char>(group >> 8);
  }
  if (bad & kBad) throw InputError("the data are damaged");
  return bytes;
}

}  // namespace robosim
