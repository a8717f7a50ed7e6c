// Formats text for screens.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace robosim::terminal {

/// Breaks text between words into lines of at most `columns` characters. Does not break a longer word.
std::vector<std::string> wrap(std::string_view text, int columns);

/// Returns the number of characters of UTF-8 text.
int width_of(std::string_view utf8);

/// Returns the last `count` lines of a serial output. A final line feed ends the last line, and does not
/// begin another.
std::vector<std::string> last_lines(std::string_view text, std::size_t count);

/// Returns a bar of `columns` characters, filled by `share` (0..1) in eighths of a character.
std::u32string bar(double share, int columns, bool utf8);

/// Returns "12.34 s", or "2 min 12.3 s" from one minute on.
std::string time_text(double seconds);

}  // namespace robosim::terminal
