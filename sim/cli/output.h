// Writes to standard output and to standard error. Reports a failed write only for standard output.
#pragma once

#include <string_view>

#include "sim/base/terminal_text.h"

namespace robosim::cli {

/// Writes and flushes. On a terminal, passes the text through for_terminal() first, which escapes control
/// characters. Throws InputError if a write fails (full disk).
void print(std::string_view text);

/// Writes to standard error, through for_terminal(). Ignores a failed write, so that the exit status stays
/// the same.
void complain(std::string_view text);

// Write a coloured screen. The caller has already escaped names and texts that come from the user's files.
void print_coloured(std::string_view text);
void complain_coloured(std::string_view text);

/// Writes the sketch's output to standard output. On a terminal, passes it through for_terminal() first;
/// otherwise writes its bytes unchanged.
class SerialPrinter {
 public:
  void add(std::string_view text);
  void finish();

 private:
  TerminalText shown_;
};

/// Replaces closed standard streams by /dev/null. Otherwise the next opened file would get the number of a
/// standard stream. Opens /dev/null read-only for standard output, so that writing to it still fails.
void open_standard_streams();

}  // namespace robosim::cli
