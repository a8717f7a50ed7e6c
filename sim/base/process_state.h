// Reads the state of a process from the kernel.
#pragma once

#include <sys/types.h>

namespace robosim {

/// Returns the state letter in /proc/PID/stat: R = running or waiting for a processor, S and D = sleeping, T
/// = stopped, t = halted by a debugger, Z = ended. Returns 0 if the process is missing, or the system has no
/// /proc.
char process_state(pid_t process);

}  // namespace robosim
