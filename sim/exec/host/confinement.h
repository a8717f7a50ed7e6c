// Confines a process that runs firmware for the host: a filter of system calls (seccomp, by libseccomp), and
// limits. docs/explanation/security.md lists what that prevents, and what it does not.
#pragma once

#include <signal.h>
#include <ucontext.h>

#include <array>
#include <cstdint>
#include <string>

namespace robosim::exec {

/// The descriptors of a confined process, in addition to 0, 1 and 2, which are /dev/null.
enum ConfinedDescriptor : int {
  kTellFd = 3,      ///< written to
  kAnswersFd = 4,   ///< read from
  kLinesFd = 5,     ///< read from
  kImageFd = 6,     ///< of the image while it is being loaded
  kFirstSealed = 8  ///< from here on images that this process loads; their content and places are fixed
};

/// A key for some calls, in registers that they do not use. Without it, calls on the first three descriptors,
/// another file at kImageFd, and the end of the process are refused.
using CallKey = std::array<std::uint32_t, 2>;

/// Returns an empty text if this kernel can confine; else a clause: "the kernel has no filter of system calls
/// (seccomp)".
std::string what_kernel_lacks();
/// Returns an empty text if runs are confined; else a clause: what the kernel lacks, or the user's choice.
std::string why_not_confined();

/// Confines this process for ever. It gets no new file, socket or process, no signal, no program, and no code
/// except that of images. It has at most kConfinedMemory and an empty environment. Any other system call
/// raises SIGSYS. Throws std::runtime_error if that is impossible. `has_grown`: whether the process may have
/// taken much memory since prepare_to_confine(). In a new process that query takes as long as the rest of
/// this function.
/// process that is new as long as it takes all the rest of this.
void confine(const CallKey& key, bool has_grown);
/// Does the common part of all confinements before processes are forked, which saves each a millisecond.
void prepare_to_confine();
constexpr std::uint64_t kConfinedMemory = 192
                                          << 20;  ///< more bytes of variables, heap and stacks than it has

/// Call read() and write(), in a confined process with the key.
long keyed_read(int fd, void* data, std::size_t bytes);
long keyed_write(int fd, const void* data, std::size_t bytes);

/// Puts a sealed image at `as`; returns false if `fd` is not open.
bool keyed_dup(int fd, int as);
[[noreturn]] void keyed_exit(int status);

/// `check` of a crash by a refused call.
constexpr const char* kSandboxCheck = "sandbox";
/// Exit status of a process that made a refused call outside of the firmware's own time.
constexpr int kRefusedStatus = 98;
/// Exit status of a process that has used up its memory.
constexpr int kNoMemoryStatus = 97;
/// Plus a signal's number: exit status of a process that sent itself that signal outside of the firmware's
/// own time.
constexpr int kSignalStatus = 128;

/// Returns whether confine() was called.
bool is_confined();
/// Prefix of the names that the loader opens in a confined process: it gets kImageFd.
constexpr const char* kImageName = "/robosim/firmware";
/// In a handler of SIGSYS: emulates the loader's calls on kImageFd, and calls that the C library wraps around
/// others. Returns false for any other call: that is refused.
bool serve_call(const siginfo_t& info, ucontext_t& context);

/// In a handler: returns the signal that the process has sent to itself, even if it was refused; 0 = none.
int own_signal(const siginfo_t& info, ucontext_t& context);
/// Ends a confined process so that its runner reports the signal.
[[noreturn]] void end_by_signal(int signal);

/// Returns the message for a refused call: "the sandbox refuses its system call openat (files)".
std::string refusal(int call);

}  // namespace robosim::exec
