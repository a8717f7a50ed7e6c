// A rectangle of characters, and how it becomes bytes for a terminal.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace robosim::tui {

/// What a character stands for; its colour follows from that.
enum class Ink : std::uint8_t { plain, faint, line, wall, trail, robot, mark, good, bad, strong };

/// What the terminal can do.
struct Look {
  bool utf8 = true;    ///< else everything is drawn in plain ASCII
  bool colour = true;  ///< else no escape sequence for colours is written
};

/// From LC_ALL, LC_CTYPE or LANG; NO_COLOR and TERM=dumb switch colours off, as does `terminal` = false.
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
  /// Outside the frame nothing happens.
  void set(int column, int row, Glyph glyph) {
    if (contains(column, row)) glyphs_[index(column, row)] = glyph;
  }
  /// Writes UTF-8 text from left to right, cut at the frame's edge; gives the column after it.
  int put(int column, int row, std::string_view text, Ink ink = Ink::plain);

 private:
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }
  int columns_, rows_;
  std::vector<Glyph> glyphs_;
};

/// The text's characters, each one column wide: what is not (control, combining and wide characters, broken
/// UTF-8) becomes one '?', so that no program on a simulated robot can drive the terminal.
std::u32string printable(std::string_view utf8);
/// One character as UTF-8, or as the nearest ASCII.
void append(std::string& bytes, char32_t c, bool utf8);

/// Lines without trailing blanks, each with a line feed.
std::string to_text(const Frame& frame, Look look);
/// The bytes that turn a terminal which shows `before` into one that shows `after`, by cursor movements.
/// Frames of different size: clears, and draws everything.
std::string changes(const Frame& before, const Frame& after, Look look);

/// The escape sequence that selects an ink; empty without colours.
std::string select(Ink ink, Look look);

}  // namespace robosim::tui
