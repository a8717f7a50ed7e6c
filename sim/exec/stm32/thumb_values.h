// Computes results of instructions: shifts, reversed bits, sign extension and division (ARMv7-M ARM, A2.2,
// A7.7).
#pragma once

#include <bit>
#include <cstdint>

#include "sim/exec/stm32/thumb.h"

namespace robosim::exec::stm32 {

/// Returns `value` shifted by `amount`, which must be at least 1. Sets `carry` to the last bit that was
/// shifted out.
inline std::uint32_t shifted(unsigned kind, std::uint32_t value, unsigned amount, std::uint32_t& carry) {
  switch (kind) {
    case kLsl:
      carry = amount <= 32 ? value >> (32 - amount) & 1 : 0;
      return amount < 32 ? value << amount : 0;
    case kLsr:
      carry = amount <= 32 ? value >> (amount - 1) & 1 : 0;
      return amount < 32 ? value >> amount : 0;
    case kAsr: {
      const auto number = static_cast<std::int32_t>(value);
      carry = static_cast<std::uint32_t>(number >> (amount <= 32 ? amount - 1 : 31)) & 1;
      return static_cast<std::uint32_t>(number >> (amount < 32 ? amount : 31));
    }
    case kRor: {
      const std::uint32_t rotated = std::rotr(value, static_cast<int>(amount & 31));
      carry = rotated >> 31;
      return rotated;
    }
    default: {
      const std::uint32_t in = carry << 31;
      carry = value & 1;
      return in | value >> 1;
    }
  }
}

inline std::uint32_t reversed(std::uint32_t value) {
  std::uint32_t result = 0;
  for (int i = 0; i < 32; ++i, value >>= 1) result = result << 1 | (value & 1);
  return result;
}

inline std::uint32_t sign_extended(std::uint32_t value, unsigned bits) {
  return static_cast<std::uint32_t>(static_cast<std::int32_t>(value << (32 - bits)) >> (32 - bits));
}

inline std::uint32_t quotient(std::uint32_t n, std::uint32_t m, bool is_signed) {
  if (m == 0) return 0;
  if (!is_signed) return n / m;
  if (m == 0xFFFFFFFF) return 0 - n;
  return static_cast<std::uint32_t>(static_cast<std::int32_t>(n) / static_cast<std::int32_t>(m));
}

}  // namespace robosim::exec::stm32
