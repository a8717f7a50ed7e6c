// Defines a rectangle of characters, and converts it to bytes for a terminal.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace robosim::terminal {

/// The meaning of a character, which determines its colour.
enum class Ink : std::uint8_t { plain, faint, line, wall, trail, robot, mark, good, bad, strong };

/// The terminal's abilities.
struct Look {
  bool utf8 = true;    ///< false: plain ASCII
  bool colour = true;  ///< false: no escape sequences for colours
};

/// Returns the abilities. LC_ALL, LC_CTYPE or LANG decides about UTF-8. NO_COLOR, TERM=dumb and `terminal` =
/// false disable colours.
Look look_from_environment(bool terminal);

struct Glyph {
  char32_t c = U' ';
  Ink ink = Ink::plain;
  bool operator==(const Glyph&) const = default;
};

class Frame {
 public:
  Frame(int columns, int rows);
  int columns() const { return columns_; }
  int rows() const { return rows_; }
  bool contains(int column, int row) const {
    return column >= 0 && row >= 0 && column < columns_ && row < rows_;
  }
  const Glyph& at(int column, int row) const { return glyphs_[index(column, row)]; }
  /// Sets a character. Has no effect outside the frame.
  void set(int column, int row, Glyph glyph) {
    if (contains(column, row)) glyphs_[index(column, row)] = glyph;
  }
  /// Writes UTF-8 text from left to right, cut at the frame's edge. Returns the column after the text.
  int put(int column, int row, std::string_view text, Ink ink = Ink::plain);

 private:
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }
  int columns_, rows_;
  std::vector<Glyph> glyphs_;
};

/// Returns the text's characters, each one column wide. Each other character (control, combining, wide,
/// broken UTF-8) becomes one '?', so that no program on a simulated robot can control the terminal.
std::u32string printable(std::string_view utf8);
/// Appends one character as UTF-8, or as its nearest ASCII equivalent.
void append(std::string& bytes, char32_t c, bool utf8);

/// Returns the frame's lines without trailing spaces, each with a line feed.
std::string to_text(const Frame& frame, Look look);
/// Returns the bytes that change a terminal from `before` to `after`: cursor movements and new characters. If
/// the sizes differ, the bytes clear the screen and draw everything.
std::string changes(const Frame& before, const Frame& after, Look look);

/// Returns the escape sequence that selects an ink; empty without colours.
std::string select(Ink ink, Look look);

}  // namespace robosim::terminal
