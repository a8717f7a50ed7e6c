// What a process may still ask of the system once firmware for the host is in it: a filter of system calls
// (seccomp, by libseccomp), and limits. docs/security.md says what that holds off, and what it does not.
#pragma once

#include <signal.h>
#include <ucontext.h>

#include <array>
#include <cstdint>
#include <string>

namespace robosim::exec {

/// The descriptors of a confined process besides 0, 1 and 2, which are /dev/null.
enum ConfinedDescriptor : int {
  kTellFd = 3,      ///< written to
  kAnswersFd = 4,   ///< read from
  kLinesFd = 5,     ///< read from
  kImageFd = 6,     ///< of the image while it is being loaded
  kFirstSealed = 8  ///< from here on images that this process loads: what they hold and where stays the same
};

/// Only calls with these in registers that they do not use may use the first three, put another file at
/// kImageFd, or end the process: what a sketch does without them is refused.
using CallKey = std::array<std::uint32_t, 2>;

/// Empty where this kernel can confine; else a clause: "the kernel has no filter of system calls (seccomp)".
std::string what_kernel_lacks();
/// Empty where runs are confined; else a clause: what the kernel lacks, or what was chosen.
std::string why_not_confined();

/// From here on, for ever: no new file, socket or process, no signal, no program, no code but what images
/// hold; at most kConfinedMemory; an empty environment. What else it asks for raises SIGSYS. Throws
/// std::runtime_error if that cannot be.
/// `has_grown`: whether it may have taken much memory since prepare_to_confine(). To ask for that takes a
/// process that is new as long as it takes all the rest of this.
void confine(const CallKey& key, bool has_grown);
/// Before each process is forked: what is the same for all is done once, and saves each a millisecond.
void prepare_to_confine();
constexpr std::uint64_t kConfinedMemory = 512
                                          << 20;  ///< more bytes of variables, heap and stacks than it has

/// read() and write() with the key, in a confined process; in another one read() and write().
long keyed_read(int fd, void* data, std::size_t bytes);
long keyed_write(int fd, const void* data, std::size_t bytes);

/// Puts a sealed image at `as`; false where `fd` is not open.
bool keyed_dup(int fd, int as);
[[noreturn]] void keyed_exit(int status);

/// `check` of a crash that a refused call is.
constexpr const char* kSandboxCheck = "sandbox";
/// Exit status of a process that asked for something refused outside of the firmware's own time.
constexpr int kRefusedStatus = 98;
/// Of one that has had all its memory.
constexpr int kNoMemoryStatus = 97;
/// And a signal's number: of one that sent itself that signal outside of the firmware's own time.
constexpr int kSignalStatus = 128;

/// Whether confine() was called.
bool is_confined();
/// How the names begin that the loader opens in a confined process: it gets kImageFd.
constexpr const char* kImageName = "/robosim/firmware";
/// In a handler of SIGSYS: does what the loader needs of kImageFd, and answers calls that the C library makes
/// around others. Returns false for any other call: that is refused.
bool serve_call(const siginfo_t& info, ucontext_t& context);

/// In a handler: the signal that the process has sent to itself, or would have if that were not refused;
/// 0 = neither.
int own_signal(const siginfo_t& info, ucontext_t& context);
/// Ends a confined process so that its runner names the signal.
[[noreturn]] void end_by_signal(int signal);

/// What it says of a call that was refused: "the sandbox refuses its system call openat (files)".
std::string refusal(int call);

}  // namespace robosim::exec
