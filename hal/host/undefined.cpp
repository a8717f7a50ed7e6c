// Handlers of gcc's UndefinedBehaviorSanitizer. Every image calls the handlers for a division by zero and for
// unreachable code. An image that is built with checks (--sanitize) also calls the other handlers, for the
// checks in sim/build/target.cpp. Without checks, a division by zero is only recorded, and has the chip's
// result (sim/build/division.h).
#include "hal/host/clock.h"

namespace {

__attribute__((noreturn)) void fail(const char* check, const void* data, uintptr_t value, uintptr_t other,
                                    const void* where) {
  robosim::host::executor->undefined(check, data, value, other, where);
  __builtin_unreachable();
}

}  // namespace

// Some checks pass fewer than two values. The executor distinguishes checks by their names.
#define ROBOSIM_HANDLER(check)                                                                 \
  extern "C" void __ubsan_handle_##check(const void* data, uintptr_t value, uintptr_t other) { \
    fail(#check, data, value, other, __builtin_return_address(0));                             \
  }

#ifdef ROBOSIM_SANITIZE
ROBOSIM_HANDLER(divrem_overflow)
#else
extern "C" void __ubsan_handle_divrem_overflow(const void* data, uintptr_t, uintptr_t) {
  robosim::host::executor->divides_by_zero(data, __builtin_return_address(0));
}
#endif
ROBOSIM_HANDLER(add_overflow)
ROBOSIM_HANDLER(sub_overflow)
ROBOSIM_HANDLER(mul_overflow)
ROBOSIM_HANDLER(negate_overflow)
ROBOSIM_HANDLER(shift_out_of_bounds)
ROBOSIM_HANDLER(out_of_bounds)
ROBOSIM_HANDLER(type_mismatch_v1)
ROBOSIM_HANDLER(pointer_overflow)
ROBOSIM_HANDLER(load_invalid_value)
ROBOSIM_HANDLER(float_cast_overflow)
ROBOSIM_HANDLER(vla_bound_not_positive)
ROBOSIM_HANDLER(builtin_unreachable)
ROBOSIM_HANDLER(missing_return)
ROBOSIM_HANDLER(nonnull_arg)
ROBOSIM_HANDLER(invalid_builtin)
