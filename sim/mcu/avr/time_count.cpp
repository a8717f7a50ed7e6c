#include "sim/mcu/avr/time_count.h"

#include <algorithm>

namespace robosim::avr {
namespace {

struct Word {
  std::uint16_t value, mask = 0xFFFF;
};
constexpr Word kAnyAddress{0, 0};  // matches any address of a variable
// Masks that ignore the constant of an instruction, because the constants depend on the board's clock.
constexpr std::uint16_t kConstant = 0xF0F0, kSmall = 0xFF30;

// clang-format off
constexpr Word kHandler[] = {
    {0x921F}, {0x920F}, {0xB60F}, {0x920F}, {0x2411},            // push r1, r0, SREG; eor r1, r1
    {0x932F}, {0x933F}, {0x938F}, {0x939F}, {0x93AF}, {0x93BF},  // push r18, r19, r24 to r27
    {0x9180}, kAnyAddress, {0x9190}, kAnyAddress,                // lds r24 to r27, millis
    {0x91A0}, kAnyAddress, {0x91B0}, kAnyAddress,
    {0x9130}, kAnyAddress,                                       // lds r19, fraction
    {0xE020, kConstant}, {0x0F23},                               // ldi r18, step; add r18, r19
    {0x3020, kConstant}, {0xF420},                               // cpi r18, limit; brcc to the other LDI
    {0x9600, kSmall}, {0x1DA1}, {0x1DB1}, {0xC005},              // adiw r24, few; adc; adc; rjmp to the STS
    {0xE020, kConstant}, {0x0F23},                               // ldi r18, carried_step; add r18, r19
    {0x9600, kSmall}, {0x1DA1}, {0x1DB1},                        // adiw r24, many; adc; adc
    {0x9320}, kAnyAddress,                                       // sts fraction, r18
    {0x9380}, kAnyAddress, {0x9390}, kAnyAddress,                // sts millis, r24 to r27
    {0x93A0}, kAnyAddress, {0x93B0}, kAnyAddress,
    {0x9180}, kAnyAddress, {0x9190}, kAnyAddress,                // lds r24 to r27, overflows
    {0x91A0}, kAnyAddress, {0x91B0}, kAnyAddress,
    {0x9600, kSmall}, {0x1DA1}, {0x1DB1},                        // adiw r24, one; adc; adc
    {0x9380}, kAnyAddress, {0x9390}, kAnyAddress,                // sts overflows, r24 to r27
    {0x93A0}, kAnyAddress, {0x93B0}, kAnyAddress,
    {0x91BF}, {0x91AF}, {0x919F}, {0x918F}, {0x913F}, {0x912F},  // pop r27 to r24, r19, r18
    {0x900F}, {0xBE0F}, {0x900F}, {0x901F}, {0x9518},            // pop SREG, r0, r1; reti
};
// clang-format on
static_assert(std::size(kHandler) == TimeCount::kWords);

// Positions of the handler's instructions, in words from its start.
constexpr std::size_t kLoadMillis = 11, kLoadFraction = 19, kStep = 21, kLimit = 23, kFew = 25, kCarried = 29,
                      kMany = 31, kStoreFraction = 34, kStoreMillis = 36, kLoadOverflows = 44, kOne = 52,
                      kStoreOverflows = 55;

bool is_handler(std::span<const std::uint8_t> flash) {
  for (std::size_t i = 0; i < TimeCount::kWords; ++i) {
    const unsigned word = flash[2 * i] | static_cast<unsigned>(flash[2 * i + 1]) << 8;
    if ((word & kHandler[i].mask) != kHandler[i].value) return false;
  }
  return true;
}

bool is_apart(int a, int a_bytes, int b, int b_bytes) { return a + a_bytes <= b || b + b_bytes <= a; }

}  // namespace

std::optional<TimeCount> time_count_of(std::span<const std::uint8_t> flash, std::span<const Instruction> code,
                                       int first_ram, int last_ram) {
  if (flash.size() < 2 * TimeCount::kWords || !is_handler(flash)) return std::nullopt;
  // Returns whether four consecutive accesses from `place` on use the four bytes at `address`, the lowest
  // first.
  const auto are_of = [&](std::size_t place, int address) {
    for (int byte = 0; byte < 4; ++byte)
      if (code[place + 2 * static_cast<std::size_t>(byte)].k != address + byte) return false;
    return true;
  };
  const int millis = code[kLoadMillis].k, fraction = code[kLoadFraction].k,
            overflows = code[kLoadOverflows].k;
  if (!are_of(kLoadMillis, millis) || !are_of(kStoreMillis, millis) || !are_of(kLoadOverflows, overflows) ||
      !are_of(kStoreOverflows, overflows) || code[kStoreFraction].k != fraction)
    return std::nullopt;
  if (!is_apart(millis, 4, overflows, 4) || !is_apart(millis, 4, fraction, 1) ||
      !is_apart(overflows, 4, fraction, 1))
    return std::nullopt;
  TimeCount found;
  found.last = std::max({millis + 3, overflows + 3, fraction});
  if (std::min({millis, overflows, fraction}) < first_ram || found.last > last_ram) return std::nullopt;
  found.millis = static_cast<std::uint16_t>(millis);
  found.overflows = static_cast<std::uint16_t>(overflows);
  found.fraction = static_cast<std::uint16_t>(fraction);
  found.step = code[kStep].b;
  found.limit = code[kLimit].b;
  found.carried_step = code[kCarried].b;
  found.few = code[kFew].b;
  found.many = code[kMany].b;
  found.one = code[kOne].b;
  return found;
}

}  // namespace robosim::avr
