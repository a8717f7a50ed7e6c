// Stores the resolutions that analogReadResolution and analogWriteResolution (bluepill.h) set, for the
// implementations of analogRead and analogWrite.
#pragma once

namespace robosim_hal {

extern int read_bits;   ///< number of bits in analogRead's result
extern int write_bits;  ///< number of bits in analogWrite's value

/// Converts a non-negative value from one number of bits to another, rounding down.
inline int with_bits(int value, int from_bits, int to_bits) {
  if (to_bits > from_bits) return value << (to_bits - from_bits);
  return value >> (from_bits - to_bits);
}

}  // namespace robosim_hal
