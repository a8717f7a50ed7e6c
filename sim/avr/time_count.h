// The Arduino core's handler of timer 0's overflow (wiring.c), which advances millis(). Every sketch runs it
// a thousand times a second, also while it sleeps or waits. avr-gcc's translation is recognised by its 62
// instructions, and the processor does all of them except RETI at once.
//
//   push r1, r0, SREG, r18, r19, r24 to r27; eor r1, r1
//   f = fraction + step;  m = millis + few
//   if (f >= limit) { f = fraction + carried_step;  m = millis + many }
//   fraction = f;  millis = m;  overflows += 1
//   pop all of them; reti
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "sim/avr/decode.h"

namespace robosim::avr {

struct TimeCount {
  static constexpr std::uint32_t kWords = 74;  ///< RETI is the last of them
  static constexpr int kPushes = 9;
  static constexpr std::int64_t kCycles = 89;  ///< up to RETI; one more with a carry of the fraction

  std::uint16_t millis = 0, overflows = 0, fraction = 0;  ///< their addresses in memory
  int last = 0;                                           ///< the last of these addresses
  std::uint8_t step = 0, limit = 0, carried_step = 0, few = 0, many = 0, one = 0;

  /// Pushes and counts, in memory. Returns the number of cycles up to RETI.
  std::int64_t count(std::uint8_t* data, std::uint16_t sp, std::uint8_t sreg) const {
    std::uint8_t* to = data + sp;
    const auto push = [&](std::uint8_t value) { *to-- = value; };
    push(data[1]), push(data[0]), push(sreg);
    push(data[18]), push(data[19]), push(data[24]), push(data[25]), push(data[26]), push(data[27]);
    const auto sum = static_cast<std::uint8_t>(data[fraction] + step);
    const bool carries = sum >= limit;
    data[fraction] = carries ? static_cast<std::uint8_t>(data[fraction] + carried_step) : sum;
    add(data + millis, carries ? many : few);
    add(data + overflows, one);
    return kCycles + carries;
  }

 private:
  static void add(std::uint8_t* number, std::uint32_t n) {
    n += static_cast<std::uint32_t>(number[0]) | static_cast<std::uint32_t>(number[1]) << 8 |
         static_cast<std::uint32_t>(number[2]) << 16 | static_cast<std::uint32_t>(number[3]) << 24;
    number[0] = static_cast<std::uint8_t>(n);
    number[1] = static_cast<std::uint8_t>(n >> 8);
    number[2] = static_cast<std::uint8_t>(n >> 16);
    number[3] = static_cast<std::uint8_t>(n >> 24);
  }
};

/// Returns the handler at the first of these words of flash, if it is this one and its
/// variables are in RAM. `code` is the decoded flash.
std::optional<TimeCount> time_count_of(std::span<const std::uint8_t> flash, std::span<const Instruction> code,
                                       int first_ram, int last_ram);

}  // namespace robosim::avr
