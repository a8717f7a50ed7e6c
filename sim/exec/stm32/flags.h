// Computes the flags of the xPSR lazily (ARMv7-M ARM, A2.2.1, A7.3). An instruction stores the values that
// determine its flags. Each flag is computed from these values only when the flag is read.
#pragma once

#include <array>
#include <cstdint>

namespace robosim::exec::stm32 {

/// For each condition number, a bit set of the combinations of N, Z, C and V that satisfy the condition.
inline constexpr std::array<std::uint16_t, 16> kPasses = [] {
  std::array<std::uint16_t, 16> all{};
  for (unsigned flags = 0; flags < 16; ++flags) {
    const bool n = flags & 8, z = flags & 4, c = flags & 2, v = flags & 1;
    const bool holds[] = {z, c, n, v, c && !z, n == v, n == v && !z, true};
    for (unsigned condition = 0; condition < 16; ++condition)
      if (condition >= 14 || holds[condition >> 1] != (condition & 1))
        all[condition] = static_cast<std::uint16_t>(all[condition] | 1u << flags);
  }
  return all;
}();

struct Flags {
  std::int64_t sign = 1;       ///< N is set if `sign` is negative, Z if its lower 32 bits are 0
  std::uint32_t carry = 0;     ///< 0 or 1
  std::uint32_t overflow = 0;  ///< V in bit 31

  /// Returns N, Z, C, V in bits 31 to 28, as in the xPSR.
  std::uint32_t pack() const {
    return (sign < 0 ? 1u << 31 : 0) | (zero() ? 1u << 30 : 0) | carry << 29 | (overflow >> 31) << 28;
  }
  void unpack(std::uint32_t status) {
    constexpr std::int64_t kNegative = std::int64_t{-1} << 32;
    sign = (status >> 31 ? kNegative : 0) | (status >> 30 & 1 ? 0 : 1);
    carry = status >> 29 & 1;
    overflow = status << 3;
  }
  bool zero() const { return static_cast<std::uint32_t>(sign) == 0; }
  /// Returns whether N differs from V.
  bool less() const {
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(sign >> 32) ^ overflow) < 0;
  }
  /// Returns whether the condition with this number is true (A7.3).
  bool passes(unsigned condition) const { return kPasses[condition] >> (pack() >> 28) & 1; }

  std::uint32_t logic(std::uint32_t result) {
    sign = static_cast<std::int32_t>(result);
    return result;
  }
  std::uint32_t sum(std::uint32_t a, std::uint32_t b) {
    const std::uint32_t result = a + b;
    carry = result < a;
    overflow = (a ^ result) & (b ^ result);
    return logic(result);
  }
  std::uint32_t sum_with_carry(std::uint32_t a, std::uint32_t b) {
    const std::uint64_t wide = std::uint64_t{a} + b + carry;
    const auto result = static_cast<std::uint32_t>(wide);
    carry = static_cast<std::uint32_t>(wide >> 32);
    overflow = (a ^ result) & (b ^ result);
    return logic(result);
  }
  std::uint32_t difference(std::uint32_t a, std::uint32_t b) {
    const std::uint32_t result = a - b;
    carry = a >= b;
    overflow = (a ^ b) & (a ^ result);
    return logic(result);
  }
};

}  // namespace robosim::exec::stm32
