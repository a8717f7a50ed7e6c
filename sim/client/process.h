// A child process that is spoken to in lines.
#pragma once

#include <signal.h>

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/base/child.h"

namespace robosim::client {

/// Starts a program with its standard input and output in our hands, in a process group of its own, so that
/// Ctrl-C in a terminal reaches us alone. Standard error is shared with it. Nothing else of ours is
/// inherited. The destructor ends the program and whatever it forked, and leaves no zombie.
class Process {
 public:
  /// Throws std::system_error if the program cannot be started.
  explicit Process(const std::filesystem::path& program);
  ~Process();
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  /// False if the program no longer listens.
  bool write(std::string_view text);
  /// The next line without its line feed, valid until the next call; nothing at the end of the output (an
  /// unfinished last line is dropped) or when `timeout_ms` of wall time have passed; -1 = wait for ever.
  std::optional<std::string_view> read_line(int timeout_ms = -1);

  /// The next bytes, so many, valid until the next call; nothing if the output ends before.
  std::optional<std::string_view> read_bytes(std::size_t count);

  /// Readable, as poll(2) has it, when the program has said something or ended.
  int descriptor() const { return answers_.get(); }
  /// read_line() came to the end of the output.
  bool silent() const { return silent_; }

  /// Makes the pipe of its output as short as possible (a page), so that it cannot run far ahead of its
  /// reader.
  void keep_close() const;

  /// How long an interrupted program may stay silent, wall time.
  static constexpr int kStopPatience_ms = 2000;

  /// Sends SIGINT to the program's whole process group. Async-signal-safe.
  void interrupt();
  bool interrupted() const { return interrupted_ != 0; }
  /// It has answered: an interrupt before that is over and done with.
  void forget_interrupt() { interrupted_ = 0; }
  /// Ends the whole process group at once. Async-signal-safe.
  void kill() const;
  /// No more input. Waits for the end, at most a second; then kills. Says how it ended: "ended with status
  /// 3", "was ended by signal 11 (Segmentation fault)".
  std::string finish();

 private:
  struct Ends;
  explicit Process(Ends ends);

  /// How long a read may take.
  struct Patience {
    std::int64_t until_ms;  ///< wall time; negative = for ever
    std::int64_t interrupt_seen_ms = -1;
  };
  /// Adds to the buffer; false at the end of the output, or when patience is.
  bool read_more(Patience& patience);

  Descriptor requests_;  // socket to its standard input
  Descriptor answers_;   // pipe from its standard output
  Child child_;
  bool finished_ = false;
  volatile sig_atomic_t interrupted_ = 0;
  bool silent_ = false;
  std::vector<char> chunk_ = std::vector<char>(65536);  // of the pipe
  std::string buffer_;
  std::size_t next_ = 0;  // where in buffer_ the next line begins
};

}  // namespace robosim::client
