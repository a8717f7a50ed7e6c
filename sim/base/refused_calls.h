// Refuses system calls that no program in a sandbox needs. Landlock and namespaces protect only files. The
// refused calls would reach the network, other processes, and parts of the kernel that compilers do not use.
#pragma once

namespace robosim {

/// Refuses the calls permanently (seccomp) to this process and its later children. The calls then fail with
/// EPERM. Does nothing without support by the kernel. Requires PR_SET_NO_NEW_PRIVS. Async-signal-safe.
void refuse_needless_calls();

}  // namespace robosim
