// Recognises the Arduino core's handler of timer 0's overflow (wiring.c), which advances millis(). An Arduino
// sketch runs the handler about a thousand times a second, even while the sketch sleeps or waits. The handler
// is identified by the 56 instructions that avr-gcc generates. The processor runs all of these instructions
// except RETI in one step.
//
//   push r1, r0, SREG, r18, r19, r24 to r27; eor r1, r1
//   f = fraction + step;  m = millis + few
//   if (f >= limit) { f = fraction + carried_step;  m = millis + many }
//   fraction = f;  millis = m;  overflows += 1
//   pop all these registers; reti
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "sim/mcu/avr/decode.h"

namespace robosim::avr {

struct TimeCount {
  static constexpr std::uint32_t kWords = 74;  ///< size of the handler; RETI is the last word
  static constexpr int kPushes = 9;
  static constexpr std::int64_t kCycles = 89;  ///< cycles up to RETI; one more if the fraction carries

  std::uint16_t millis = 0, overflows = 0, fraction = 0;  ///< addresses of the variables
  int last = 0;                                           ///< highest address of these variables
  std::uint8_t step = 0, limit = 0, carried_step = 0, few = 0, many = 0, one = 0;

  /// Pushes the registers and advances the variables in `data`. Returns the number of cycles up to RETI.
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

/// Returns the handler if `flash` starts with its instructions and its variables are in RAM. `code` is the
/// decoded flash.
std::optional<TimeCount> time_count_of(std::span<const std::uint8_t> flash, std::span<const Instruction> code,
                                       int first_ram, int last_ram);

}  // namespace robosim::avr
