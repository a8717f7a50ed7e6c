#include "sim/base/base64.h"

#include <array>
#include <cstdint>

#include "sim/base/error.h"

namespace robosim {
namespace {

constexpr const char* kBase64Digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

}  // namespace

std::string base64(std::string_view bytes) {
  std::string text((bytes.size() + 2) / 3 * 4, '=');
  char* to = text.data();
  const auto byte = [&](std::size_t i) { return std::uint32_t{static_cast<std::uint8_t>(bytes[i])}; };
  const auto put = [&](std::uint32_t group, int digits) {
    for (int k = 0; k < digits; ++k) to[k] = kBase64Digits[group >> (18 - 6 * k) & 63];
    to += digits;
  };
  std::size_t i = 0;
  for (; i + 3 <= bytes.size(); i += 3) put(byte(i) << 16 | byte(i + 1) << 8 | byte(i + 2), 4);
  if (bytes.size() - i == 1) put(byte(i) << 16, 2);
  if (bytes.size() - i == 2) put(byte(i) << 16 | byte(i + 1) << 8, 3);
  return text;
}

std::string from_base64(std::string_view text) {
  static const auto values = [] {
    std::array<std::int8_t, 256> table;
    table.fill(-1);
    for (std::int8_t i = 0; i < 64; ++i) table[static_cast<std::uint8_t>(kBase64Digits[i])] = i;
    return table;
  }();
  while (!text.empty() && text.back() == '=') text.remove_suffix(1);
  std::string bytes(text.size() * 3 / 4, '\0');
  char* to = bytes.data();
  int bad = 0;  // negative once a character was none of base64's
  const auto value = [&](std::size_t i) {
    const int v = values[static_cast<std::uint8_t>(text[i])];
    bad |= v;
    return static_cast<std::uint32_t>(v);
  };
  std::size_t i = 0;
  for (; i + 4 <= text.size(); i += 4) {
    const std::uint32_t group = value(i) << 18 | value(i + 1) << 12 | value(i + 2) << 6 | value(i + 3);
    *to++ = static_cast<char>(group >> 16);
    *to++ = static_cast<char>(group >> 8);
    *to++ = static_cast<char>(group);
  }
  if (text.size() - i == 1) bad = -1;  // six bits are no byte
  if (text.size() - i >= 2) *to++ = static_cast<char>(value(i) << 2 | value(i + 1) >> 4);
  if (text.size() - i == 3) *to++ = static_cast<char>(value(i + 1) << 4 | value(i + 2) >> 2);
  if (bad < 0) throw InputError("its data are damaged");
  return bytes;
}

}  // namespace robosim
