// Implements functions that end the firmware: abort(), exit(), a failed assert().
#include <stdlib.h>
#include <string.h>

#include "hal/host/clock.h"

namespace host = robosim::host;

namespace {

__attribute__((noreturn)) void crash(const char* reason, const char* file, uint32_t line, const void* where) {
  host::executor->crash(reason, file, line, where);
  __builtin_unreachable();
}

/// Stops firmware that called the function `name` with the argument `status`.
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

}  // extern "C"
