// Child processes: how they start, and how they end.
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

/// How a child process has ended.
struct Ending {
  int status = 0;  ///< exit status, unless a signal has ended it
  int signal = 0;  ///< 0 = none

  bool ok() const { return status == 0 && signal == 0; }
  /// Returns "ended with status 3", "was ended by signal 11 (Segmentation fault)".
  std::string text() const;
};

struct ChildStart {
  static constexpr int kOurs = -1, kNothing = -2;  ///< besides a descriptor; kNothing is /dev/null

  std::vector<std::string> words;  ///< the program and its arguments; without a / it is looked for on $PATH
  std::filesystem::path folder;    ///< the folder in which it works; empty = ours
  std::optional<std::vector<std::string>> environment;  ///< "NAME=VALUE"; nothing = ours
  int input = kOurs, output = kOurs, errors = kOurs;
  std::vector<int>
      default_signals;     ///< these are not ignored, even if we do; where there are any, none is blocked
  bool own_group = false;  ///< a process group of its own: Ctrl-C in a terminal does not reach it
};

/// A child process: a program, or a copy of this process. A program inherits the descriptors that its start
/// names, and those without FD_CLOEXEC. The destructor kills a running child, and leaves no zombie.
class Child {
 public:
  /// Starts a program. Throws std::system_error if it cannot be started.
  explicit Child(const ChildStart& start);
  /// Starts a copy of this process. The result of `work` is its exit status; it is aborted if `work` throws.
  /// Throws std::system_error.
  explicit Child(const std::function<int()>& work);
  Child(Child&& other) noexcept;
  Child& operator=(Child&& other) noexcept;
  ~Child();

  /// Sends a signal, to all of its group if it has its own. No effect after wait(). Async-signal-safe.
  void send(int signal) const;
  /// Returns whether it has ended. Until wait() its number is not reused.
  bool has_ended() const;
  Ending wait();
  pid_t pid() const { return pid_; }

 private:
  pid_t pid_ = -1;
  bool own_group_ = false;
  Ending ending_;
};

/// Returns what a program writes to its standard output; empty if it cannot be started.
std::string output_of(const std::vector<std::string>& words);

}  // namespace robosim
