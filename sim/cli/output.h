// Standard output, with its errors checked; standard error.
#pragma once

#include <string_view>

#include "sim/base/terminal_text.h"

namespace robosim::cli {

/// Writes and flushes; on a terminal as for_terminal() has it. Throws InputError if that fails (a full disk).
void print(std::string_view text);

/// Writes to standard error, as for_terminal() has it. Where that cannot be written the exit status must do.
void complain(std::string_view text);

// Write a screen with our own colours, in which the names and texts of others are visible already.
void print_coloured(std::string_view text);
void complain_coloured(std::string_view text);

/// Writes what a sketch sends to standard output: on a terminal as for_terminal() has it, else byte by byte.
class SerialPrinter {
 public:
  void add(std::string_view text);
  void finish();

 private:
  TerminalText shown_;
};

/// Puts /dev/null in the place of standard streams that are closed, or the next file that is opened would be
/// taken for one of them. Writing to such a standard output fails.
void open_standard_streams();

}  // namespace robosim::cli
