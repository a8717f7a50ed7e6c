// A signal by which the processor refuses to continue, as its handler receives it.
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
  const void* link = nullptr;  // the innermost call's return address, if that is in a register
  bool known_write = false;
  bool known_read = false;
  int call = -1;       // SIGSYS: the system call that was refused
  int own_signal = 0;  // the signal that the firmware sent itself; 0 = none

  const char* access() const { return known_write ? "write" : known_read ? "read" : "access"; }
};

HostFault describe(int signal, const siginfo_t& info, ucontext_t& context);

/// Returns "it sends itself signal 2 (Interrupt)".
std::string signal_text(int signal);

/// Returns the reason for the user, whose firmware has this heap and this stack.
std::string reason_of(const HostFault& fault, const GuardedMemory& heap, const GuardedMemory& stack);

/// Returns whether both addresses are in one executable or shared object.
bool in_same_object(const void* a, const void* b);

/// Gives the thread a stack for signal handlers, unless it has one: the firmware's own may have overflowed.
void ensure_signal_stack();

}  // namespace robosim::exec
