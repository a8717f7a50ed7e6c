// Starts child processes, and waits for their end.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "sim/base/descriptor.h"

namespace robosim {

/// A pipe that child processes do not inherit by default.
struct Pipe {
  Descriptor read, write;
  /// Opens a pipe. Throws std::system_error.
  Pipe();
};

/// The exit status of a child process, or the signal that ended the process.
struct Ending {
  int status = 0;  ///< exit status, unless a signal ended the process
  int signal = 0;  ///< 0 = none

  bool ok() const { return status == 0 && signal == 0; }
  /// Returns a text such as "ended with status 3" or "was ended by signal 11 (Segmentation fault)".
  std::string text() const;
};

struct ChildStart {
  static constexpr int kOurs = -1, kNothing = -2;  ///< special streams: kOurs = inherit, kNothing = /dev/null

  std::vector<std::string> words;  ///< the program and its arguments; a name without / is searched on $PATH
  std::filesystem::path folder;    ///< the child's working folder; empty = inherit
  std::optional<std::vector<std::string>> environment;  ///< "NAME=VALUE"; nothing = inherit
  int input = kOurs, output = kOurs, errors = kOurs;
  std::vector<int>
      default_signals;     ///< signals with default actions in the child; unless empty, it blocks no signal
  bool own_group = false;  ///< starts a process group, so that Ctrl-C in a terminal does not reach the child
  bool fixed_addresses = false;  ///< disables ASLR; no effect if the kernel refuses this
};

/// A child process: a program, or a copy of this process. A program inherits the descriptors in its
/// ChildStart, and all descriptors without FD_CLOEXEC. The destructor kills a running child, and leaves no
/// zombie.
class Child {
 public:
  /// Starts a program. Throws std::system_error if it cannot be started.
  explicit Child(const ChildStart& start);
  /// Starts a copy of this process, which runs `work` and returns the result as its exit status. The copy
  /// aborts if `work` throws. Throws std::system_error.
  explicit Child(const std::function<int()>& work);
  Child(Child&& other) noexcept;
  Child& operator=(Child&& other) noexcept;
  ~Child();

  /// Sends a signal to the child, or to its process group if `own_group` was set. Has no effect after wait().
  /// Async-signal-safe.
  void send(int signal) const;
  /// Returns whether the child has ended. The process number is not reused until wait().
  bool has_ended() const;
  Ending wait();
  pid_t pid() const { return pid_; }

 private:
  pid_t pid_ = -1;
  bool own_group_ = false;
  Ending ending_;
};

/// Returns the standard output of a program; empty if the program cannot be started.
std::string output_of(const std::vector<std::string>& words);

}  // namespace robosim
