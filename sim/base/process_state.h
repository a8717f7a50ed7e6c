// Reads the state of a process from the kernel.
#pragma once

#include <sys/types.h>

namespace robosim {

/// Returns the state letter in /proc/PID/stat: R runs or waits for a processor; S and D sleep; T is stopped;
/// t is halted by a debugger; Z has ended. Returns 0 if the process is missing, or the system has no /proc.
char process_state(pid_t process);

}  // namespace robosim
