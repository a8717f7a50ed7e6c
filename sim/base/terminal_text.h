// Text that others wrote (sketches, file names, compiler messages) as it may be shown on a terminal.
#pragma once

#include <string>
#include <string_view>

namespace robosim {

/// Writes control characters, bytes that are not UTF-8 and characters that turn the direction of writing as
/// `\x1b` or `\u202e`, so that a terminal carries out none of them. Keeps line feeds and tabs, and writes CR
/// LF as LF.
std::string for_terminal(std::string_view text);

/// As for_terminal(), but in one line: a line feed in a file's name must not begin a line of its own.
std::string in_one_line(std::string_view text);

/// Does so for a text that arrives in pieces, which may cut a character, or CR LF, in two.
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
