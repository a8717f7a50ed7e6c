// The state of a process as the kernel reports it.
#pragma once

#include <sys/types.h>

namespace robosim {

/// Returns the letter of /proc/PID/stat. R runs or waits for a processor. S and D sleep. T is stopped, t is
/// halted by a debugger, Z has ended. Returns 0 if there is no such process, or the system has no /proc.
char process_state(pid_t process);

}  // namespace robosim
