// Confines a process that runs firmware for the host, by limits and a filter of system calls (seccomp, using
// libseccomp). docs/explanation/security.md lists what this prevents and what it does not.
#pragma once

#include <signal.h>
#include <ucontext.h>

#include <array>
#include <cstdint>
#include <string>

namespace robosim::exec {

/// The descriptors of a confined process, in addition to 0, 1 and 2, which are /dev/null.
enum ConfinedDescriptor : int {
  kTellFd = 3,      ///< written by the process
  kAnswersFd = 4,   ///< read by the process
  kLinesFd = 5,     ///< read by the process
  kImageFd = 6,     ///< the image while it is being loaded
  kFirstSealed = 8  ///< this and higher ones: images for this process, with fixed content and places
};

/// A key in argument registers that a system call does not use. Without it, the kernel rejects calls that use
/// the first three descriptors above, replace the file at kImageFd, or end the process.
using CallKey = std::array<std::uint32_t, 2>;

/// Returns why this kernel cannot confine processes, as a clause: "the kernel has no filter of system calls
/// (seccomp)". Empty if it can.
std::string what_kernel_lacks();
/// Returns why runs are not confined, as a clause: a feature that the kernel lacks, or the user's choice.
/// Empty if they are confined.
std::string why_not_confined();

/// Confines this process for ever. It can no longer obtain files, sockets, processes, signals or programs, or
/// code other than that of images. Its memory is limited to kConfinedMemory, and its environment is empty.
/// System calls that are not allowed raise SIGSYS. Throws std::runtime_error if confinement is impossible.
///
/// `has_grown`: the process may have allocated much memory since prepare_to_confine(). Pass false for a new
/// process, since finding out takes as long as the rest of this function.
void confine(const CallKey& key, bool has_grown);
/// Does the common part of all confinements. Call it before processes are forked, which saves each of them a
/// millisecond.
void prepare_to_confine();
constexpr std::uint64_t kConfinedMemory = 192
                                          << 20;  ///< bytes of additional memory: variables, heap and stacks

/// Call read() and write(); in a confined process, with the key.
long keyed_read(int fd, void* data, std::size_t bytes);
long keyed_write(int fd, const void* data, std::size_t bytes);

/// Duplicates the sealed image `fd` to the descriptor `as`. Returns false if `fd` is not open.
bool keyed_dup(int fd, int as);
[[noreturn]] void keyed_exit(int status);

/// The value of Crash::check for a crash by a refused call.
constexpr const char* kSandboxCheck = "sandbox";
/// Exit status of a process that made a refused call while no firmware was running.
constexpr int kRefusedStatus = 98;
/// Exit status of a process that has run out of memory.
constexpr int kNoMemoryStatus = 97;
/// Exit status, plus the signal's number, of a process that sent itself a signal while no firmware was
/// running.
constexpr int kSignalStatus = 128;

/// Returns whether confine() was called.
bool is_confined();
/// Prefix of the file names that the loader opens in a confined process. The loader gets kImageFd instead.
constexpr const char* kImageName = "/robosim/firmware";
/// Emulates the loader's calls on kImageFd, and calls that the C library makes along with others. Returns
/// false for any other call, which is refused. Call it in a handler of SIGSYS.
bool serve_call(const siginfo_t& info, ucontext_t& context);

/// Returns the signal that the process sent to itself, even if the call was refused; 0 = none. Call it in a
/// signal handler.
int own_signal(const siginfo_t& info, ucontext_t& context);
/// Ends a confined process in such a way that its runner reports the signal.
[[noreturn]] void end_by_signal(int signal);

/// Returns the message for a refused call: "the sandbox refuses its system call openat (files)".
std::string refusal(int call);

}  // namespace robosim::exec
