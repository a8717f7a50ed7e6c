// Makes text of others (sketches, file names, compiler messages) safe to show on a terminal.
#pragma once

#include <string>
#include <string_view>

namespace robosim {

/// Escapes control characters, invalid UTF-8 and changes of the writing direction as `\x1b` or `\u202e`.
/// Then a terminal executes none of them. Keeps line feeds and tabs, and writes CR LF as LF.
std::string for_terminal(std::string_view text);

/// Does the same, in one line: a line feed in a file's name must not start a new line.
std::string in_one_line(std::string_view text);

/// Does so for a text that arrives in pieces, which may split a character or CR LF.
class TerminalText {
 public:
  /// Returns what can be shown so far.
  std::string add(std::string_view piece);
  /// Returns the rest.
  std::string finish();

 private:
  std::string held_;  ///< the beginning of a character
};

}  // namespace robosim
