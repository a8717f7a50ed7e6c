// Confines a process that runs firmware built for the host, by resource limits and a filter of system calls
// (seccomp, by libseccomp). docs/explanation/security.md lists the attacks that confinement prevents, and the
// attacks that it does not prevent.
#pragma once

#include <signal.h>
#include <ucontext.h>

#include <array>
#include <cstdint>
#include <string>

namespace robosim::exec {

/// The descriptors of a confined process, in addition to 0, 1 and 2, which are /dev/null.
enum ConfinedDescriptor : int {
  kTellFd = 3,      ///< messages to the runner
  kAnswersFd = 4,   ///< the runner's answers
  kLinesFd = 5,     ///< input from the client
  kImageFd = 6,     ///< the image that is being loaded
  kFirstSealed = 8  ///< from this number on, sealed images, which the process cannot change or close
};

/// A random key. Robosim passes the key in the argument registers that a system call leaves unused. A sketch
/// does not know the key. Without the key, the kernel rejects calls that use kTellFd, kAnswersFd or kLinesFd.
/// Calls that replace the file at kImageFd or end the process need the key, too.
using CallKey = std::array<std::uint32_t, 2>;

/// Returns why this kernel cannot confine processes, as a clause: "the kernel has no filter of system calls
/// (seccomp)". Returns an empty text if the kernel can confine processes.
std::string what_kernel_lacks();
/// Returns why runs are not confined, as a clause: a feature that the kernel lacks, or the user's choice.
/// Returns an empty text if runs are confined.
std::string why_not_confined();

/// Confines this process permanently. The process can no longer open files or sockets, start processes or
/// programs, or send signals. It can execute only the code of images and of Robosim. The process can allocate
/// at most kConfinedMemory, and its environment is empty. System calls that are not allowed raise SIGSYS.
/// Throws std::runtime_error if confinement is impossible.
///
/// `has_grown` must be true if the process may have allocated much memory since prepare_to_confine(). Callers
/// pass false for a new process, because measuring the memory takes as long as the rest of this function.
void confine(const CallKey& key, bool has_grown);
/// Creates the filter that all confined processes share, and measures the memory in use. A call before
/// processes are forked saves each of these processes a millisecond.
void prepare_to_confine();
constexpr std::uint64_t kConfinedMemory = 192 << 20;  ///< bytes that a process may allocate after confine()

/// Call read() and write() with the key, which the kernel requires in a confined process.
long keyed_read(int fd, void* data, std::size_t bytes);
long keyed_write(int fd, const void* data, std::size_t bytes);

/// Duplicates the descriptor of a sealed image from number `fd` to number `as`. Returns false if that fails,
/// for example because `fd` is not open.
bool keyed_dup(int fd, int as);
[[noreturn]] void keyed_exit(int status);

/// The value of Crash::check for a crash by a refused system call.
constexpr const char* kSandboxCheck = "sandbox";
/// Exit status of a process that has made a refused system call while no firmware was running.
constexpr int kRefusedStatus = 98;
/// Exit status of a process that has run out of memory.
constexpr int kNoMemoryStatus = 97;
/// Exit status of a process that has sent itself a signal while no firmware was running. The signal's number
/// is added to this value.
constexpr int kSignalStatus = 128;

/// Returns whether confine() was called.
bool is_confined();
/// Prefix of the file names by which a confined process loads images. serve_call() opens kImageFd instead of
/// such a file.
constexpr const char* kImageName = "/robosim/firmware";
/// Emulates the loader's system calls for kImageFd, and the C library's system calls that block signals.
/// Returns false for any other call, which is then refused. Must be called in a handler of SIGSYS.
bool serve_call(const siginfo_t& info, ucontext_t& context);

/// Returns the signal that the process has sent or tried to send to itself; 0 = none. Must be called in a
/// signal handler.
int own_signal(const siginfo_t& info, ucontext_t& context);
/// Ends a confined process with an exit status by which the runner recognises the signal. For SIGABRT, ends
/// the process by a real SIGABRT instead.
[[noreturn]] void end_by_signal(int signal);

/// Returns the message for a refused call: "the sandbox refuses its system call openat (files)".
std::string refusal(int call);

}  // namespace robosim::exec
