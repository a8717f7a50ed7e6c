// A signal by which the processor refuses to run on, as its handler meets it.
#pragma once

#include <signal.h>
#include <ucontext.h>

#include <cstddef>
#include <string>

#include "sim/exec/host/fiber.h"

namespace robosim::exec {

struct HostFault {
  int signal = 0;
  int code = 0;
  const std::byte* address = nullptr;
  const std::byte* pc = nullptr;
  const std::byte* stack_pointer = nullptr;
  const void* link = nullptr;  // where the innermost call returns to, if that is in a register
  bool known_write = false;
  bool known_read = false;
  int call = -1;       // SIGSYS: the system call that was refused
  int own_signal = 0;  // that the firmware sent itself; 0 = none

  const char* access() const { return known_write ? "write" : known_read ? "read" : "access"; }
};

HostFault describe(int signal, const siginfo_t& info, ucontext_t& context);

/// "it sends itself signal 2 (Interrupt)".
std::string signal_text(int signal);

/// What the user is told of it, whose firmware has this heap and this stack.
std::string reason_of(const HostFault& fault, const GuardedMemory& heap, const GuardedMemory& stack);

/// Whether both addresses are in one executable or shared object.
bool in_same_object(const void* a, const void* b);

/// A stack for signal handlers, unless the thread has one: the firmware's own may be what has overflowed.
void ensure_signal_stack();

}  // namespace robosim::exec
