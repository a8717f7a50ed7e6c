// System calls that no program within walls needs. Landlock and namespaces guard files; these would reach the
// network, other processes, and parts of the kernel that compilers have no use for.
#pragma once

namespace robosim {

/// Refuses them to this process and to what it starts, for ever (seccomp): they fail with EPERM. Does nothing
/// where the kernel cannot. It needs PR_SET_NO_NEW_PRIVS. Async-signal-safe.
void refuse_needless_calls();

}  // namespace robosim
