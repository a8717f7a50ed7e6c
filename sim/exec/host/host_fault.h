// Describes a fatal signal, such as a processor fault, from the data that the signal handler receives.
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
  const void* link = nullptr;  // return address of the innermost call, if a register contains it
  bool known_write = false;
  bool known_read = false;
  int call = -1;       // for SIGSYS: the refused system call
  int own_signal = 0;  // signal that the firmware sent itself; 0 = none

  const char* access() const { return known_write ? "write" : known_read ? "read" : "access"; }
};

HostFault describe(int signal, const siginfo_t& info, ucontext_t& context);

/// Returns a clause: "it sends itself signal 2 (Interrupt)".
std::string signal_text(int signal);

/// Returns the reason for the crash, as a text for the user. `heap` and `stack` are the memory of the
/// firmware.
std::string reason_of(const HostFault& fault, const GuardedMemory& heap, const GuardedMemory& stack);

/// Returns whether both addresses are in the same executable or shared object.
bool in_same_object(const void* a, const void* b);

/// Gives the thread a separate stack for signal handlers, if the thread has no such stack yet. A handler
/// cannot run on the firmware's stack, which may have overflowed.
void ensure_signal_stack();

}  // namespace robosim::exec
