// Confines a process that runs firmware built for the host. Uses limits and a filter of system calls
// (seccomp, by libseccomp). docs/explanation/security.md lists what this prevents and what it does not.
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
  kFirstSealed = 8  ///< this and higher numbers: sealed images, which cannot be changed or closed
};

/// A key in argument registers that a system call does not use. Without it, the kernel rejects calls that use
/// kTellFd, kAnswersFd or kLinesFd, replace the file at kImageFd, or end the process.
using CallKey = std::array<std::uint32_t, 2>;

/// Returns why this kernel cannot confine processes, as a clause: "the kernel has no filter of system calls
/// (seccomp)". Returns an empty text if the kernel can.
std::string what_kernel_lacks();
/// Returns why runs are not confined, as a clause: a feature that the kernel lacks, or the user's choice.
/// Empty if they are confined.
std::string why_not_confined();

/// Confines this process permanently. It can no longer obtain files, sockets, processes, signals or programs.
/// It can execute only the code of images. Its memory is limited to kConfinedMemory, and its environment is
/// empty. System calls that are not allowed raise SIGSYS. Throws std::runtime_error if confinement is
/// impossible.
///
/// `has_grown`: whether the process may have allocated much memory since prepare_to_confine(). Pass false for
/// a new process: measuring its memory takes as long as the rest of this function.
void confine(const CallKey& key, bool has_grown);
/// Makes the filter that all confined processes share, and measures the memory in use. Call it before forking
/// processes, which saves each of them a millisecond.
void prepare_to_confine();
constexpr std::uint64_t kConfinedMemory = 192
                                          << 20;  ///< bytes of additional memory: variables, heap and stacks

/// Call read() and write(). They pass the key, which is needed in a confined process.
long keyed_read(int fd, void* data, std::size_t bytes);
long keyed_write(int fd, const void* data, std::size_t bytes);

/// Duplicates the sealed image `fd` to the descriptor `as`. Returns false if `fd` is not open.
bool keyed_dup(int fd, int as);
[[noreturn]] void keyed_exit(int status);

/// The value of Crash::check for a crash caused by a refused call.
constexpr const char* kSandboxCheck = "sandbox";
/// Exit status of a process that made a refused call while no firmware was running.
constexpr int kRefusedStatus = 98;
/// Exit status of a process that has run out of memory.
constexpr int kNoMemoryStatus = 97;
/// Base of the exit status of a process that sent itself a signal while no firmware was running. The signal's
/// number is added.
constexpr int kSignalStatus = 128;

/// Returns whether confine() was called.
bool is_confined();
/// Prefix of the file names that the loader opens in a confined process. The loader gets kImageFd instead.
constexpr const char* kImageName = "/robosim/firmware";
/// Emulates the loader's calls on kImageFd, and the C library's calls that block signals. Returns false for
/// any other call, which is then refused. Call it in a handler of SIGSYS.
bool serve_call(const siginfo_t& info, ucontext_t& context);

/// Returns the signal that the process sent to itself, even if the sending call was refused; 0 = none. Call
/// it in a signal handler.
int own_signal(const siginfo_t& info, ucontext_t& context);
/// Ends a confined process in such a way that its runner reports the signal.
[[noreturn]] void end_by_signal(int signal);

/// Returns the message for a refused call: "the sandbox refuses its system call openat (files)".
std::string refusal(int call);

}  // namespace robosim::exec
