// Makes text from other sources (sketches, file names, compiler messages) safe for a terminal.
#pragma once

#include <string>
#include <string_view>

namespace robosim {

/// Escapes control characters, invalid UTF-8 and changes of the writing direction as `\x1b` or `\u202e`. A
/// terminal then executes none of them. Keeps line feeds and tabs, and converts CR LF to LF.
std::string for_terminal(std::string_view text);

/// Escapes text like for_terminal(), and also line feeds and tabs: a file's name must not start a new line.
std::string in_one_line(std::string_view text);

/// Escapes text that arrives in pieces, which may split a character or CR LF.
class TerminalText {
 public:
  /// Returns the escaped text that is complete so far.
  std::string add(std::string_view piece);
  /// Returns the remaining escaped text.
  std::string finish();

 private:
  std::string held_;  ///< start of an incomplete character
};

}  // namespace robosim
