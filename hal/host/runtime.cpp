// How firmware ends: abort, exit, a failed assert, a division by zero (gcc's
// -fsanitize=integer-divide-by-zero).
#include <stdlib.h>
#include <string.h>

#include "hal/host/clock.h"

namespace host = robosim::host;

namespace {

__attribute__((noreturn)) void crash(const char* reason, const char* file, uint32_t line, const void* where) {
  host::executor->crash(reason, file, line, where);
  __builtin_unreachable();
}

/// What gcc hands to a handler of its undefined behaviour sanitizer, as far as it is used here.
struct DivisionData {
  const char* file;
  uint32_t line;
  uint32_t column;
};

/// `name` is a function of one number, and was called with `status`.
__attribute__((noreturn)) void stop(const char* name, int status) {
  static char how[24];
  strcpy(how, name);
  strcat(how, "(");
  itoa(status, how + strlen(how), 10);
  strcat(how, ")");
  host::stop_for_ever(how);
  __builtin_unreachable();
}

}  // namespace

extern "C" {

void abort() { crash("abort() called", nullptr, 0, __builtin_return_address(0)); }

void exit(int status) {
  host::state.place = __builtin_return_address(0);
  stop("exit", status);
}

void _exit(int status) {
  host::state.place = __builtin_return_address(0);
  stop("_exit", status);
}

void __assert(const char*, const char* file, int line, const char*) {
  crash("assert() failed", file, static_cast<uint32_t>(line), __builtin_return_address(0));
}

void __ubsan_handle_divrem_overflow(DivisionData* data, uintptr_t, uintptr_t) {
  crash("division by zero", data->file, data->line, __builtin_return_address(0));
}

void __ubsan_handle_divrem_overflow_abort(DivisionData* data, uintptr_t, uintptr_t) {
  crash("division by zero", data->file, data->line, __builtin_return_address(0));
}

}  // extern "C"
