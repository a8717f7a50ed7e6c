// Runs a child process and exchanges lines of text with it.
#pragma once

#include <signal.h>

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/base/child.h"

namespace robosim::client {

/// Starts a program with its standard input and output connected to this process. The program has its own
/// process group, so that Ctrl-C in a terminal reaches only this process. The program shares this process's
/// standard error, and inherits no other open file. The destructor ends the program and its forks, and leaves
/// no zombie.
class Process {
 public:
  /// Starts the program. Throws std::system_error if that fails.
  explicit Process(const std::filesystem::path& program);
  ~Process();
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  /// Writes text to the program's standard input. Returns false if the program no longer reads.
  bool write(std::string_view text);
  /// Returns the next line without its line feed; the view is valid until the next call. Returns nothing at
  /// the end of the output, and drops an incomplete last line. Also returns nothing after `timeout_ms` of
  /// wall time; -1 = no limit. After interrupt(), the limit is kStopPatience_ms.
  std::optional<std::string_view> read_line(int timeout_ms = -1);

  /// Returns the next `count` bytes, which are valid until the next call. Returns nothing if the output ends
  /// earlier.
  std::optional<std::string_view> read_bytes(std::size_t count);

  /// Returns a descriptor that poll(2) reports as readable when the program has written or ended.
  int descriptor() const { return answers_.get(); }
  /// Returns whether read_line() reached the end of the output.
  bool silent() const { return silent_; }

  /// Makes the output pipe as small as possible (a page). The program then cannot run far ahead of its
  /// reader.
  void keep_close() const;

  /// Maximum wall time that a read waits for output after interrupt().
  static constexpr int kStopPatience_ms = 2000;

  /// Sends SIGINT to the program's whole process group. Async-signal-safe.
  void interrupt();
  bool interrupted() const { return interrupted_ != 0; }
  /// Resets interrupted(). The caller calls this function after each answer, so that an old interrupt does
  /// not affect the next request.
  void forget_interrupt() { interrupted_ = 0; }
  /// Kills the whole process group. Async-signal-safe.
  void kill() const;
  /// Closes the program's input. Waits at most a second for the program to end, then kills it. Returns how
  /// the program ended: "ended with status 3", "was ended by signal 11 (Segmentation fault)".
  std::string finish();

 private:
  struct Ends;
  explicit Process(Ends ends);

  /// The time limit of a read.
  struct Patience {
    std::int64_t until_ms;  ///< wall time; negative = no limit
    std::int64_t interrupt_seen_ms = -1;
  };
  /// Reads more output into `buffer_`. Returns false at the end of the output, or after the time limit.
  bool read_more(Patience& patience);

  Descriptor requests_;  // socket to the program's standard input
  Descriptor answers_;   // pipe from the program's standard output
  Child child_;
  bool finished_ = false;
  volatile sig_atomic_t interrupted_ = 0;
  bool silent_ = false;
  std::vector<char> chunk_ = std::vector<char>(65536);  // buffer for reading the pipe
  std::string buffer_;
  std::size_t next_ = 0;  // beginning of the next line in buffer_
};

}  // namespace robosim::client
