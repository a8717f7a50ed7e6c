/* The handlers of gcc's UndefinedBehaviorSanitizer for an AVR. A sketch that is built with checks
 * (--sanitize) calls a handler when a check fails. The handler executes an instruction that no AVR has, so
 * the emulator stops. To describe the failure, the emulator reads the handler's arguments (data and values).
 * They are still in the registers r25 to r20.
 *
 * The build compiles this file together with the genuine core. Only images with checks contain the code. */
#include <stdint.h>

#define ROBOSIM_STOP __asm__ volatile(".word 0x00FE")

#define ROBOSIM_HANDLER(check) \
  __attribute__((naked, used, externally_visible)) void __ubsan_handle_##check(void) { ROBOSIM_STOP; }

ROBOSIM_HANDLER(add_overflow)
ROBOSIM_HANDLER(sub_overflow)
ROBOSIM_HANDLER(mul_overflow)
ROBOSIM_HANDLER(negate_overflow)
ROBOSIM_HANDLER(divrem_overflow)
ROBOSIM_HANDLER(float_cast_overflow)
ROBOSIM_HANDLER(out_of_bounds)

struct Type {
  uint16_t kind;
  uint16_t info; /* for an integer type: 2 * log2(bits), + 1 if signed */
};

struct ShiftData {
  const char* file;
  unsigned line, column;
  const struct Type* value;
  const struct Type* distance;
};

__attribute__((naked, used, externally_visible)) void __ubsan_handle_shift_out_of_bounds_abort(
    const struct ShiftData* data, uintptr_t value, uintptr_t distance) {
  ROBOSIM_STOP;
}

static unsigned bits(const struct Type* type) { return 1u << (type->info >> 1); }

/* gcc defines the result of << for negative numbers, and for bits that are shifted out at the top. So only
 * the shift distance can be invalid, and this handler ignores all other failures. */
__attribute__((used, externally_visible)) void __ubsan_handle_shift_out_of_bounds(
    const struct ShiftData* data, uintptr_t value, uintptr_t distance) {
  /* A value wider than a pointer is passed by its address. */
  const uint32_t by = bits(data->distance) > 16 ? *(const uint32_t*)distance : distance;
  if (by >= bits(data->value)) __ubsan_handle_shift_out_of_bounds_abort(data, value, distance);
}
