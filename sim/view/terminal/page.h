// Builds one screen of a session, from the top: a title, text, lists, a map. A footer follows directly below,
// and is always shown.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sim/view/terminal/frame.h"
#include "sim/view/terminal/terminal.h"

namespace robosim::terminal {

class Page {
 public:
  /// A line of the footer. Long lines are wrapped.
  struct Line {
    std::string text;
    Ink ink = Ink::plain;
  };
  Page(TerminalSize size, Look look, const std::vector<Line>& footer);

  Look look() const { return look_; }
  int columns() const { return frame_.columns(); }
  /// Returns the number of rows left above the footer.
  int rows_left() const { return least_footer_row_ - row_; }

  /// Adds one row, cut at the edge.
  void line(std::string_view text, Ink ink = Ink::plain);
  /// Adds text, with as many rows as necessary.
  void text(std::string_view text, Ink ink = Ink::plain);
  void blank() { ++row_; }
  /// Adds a list, in at most `rows` rows. If not all lines fit, those around `selected` are shown.
  void list(const std::vector<std::string>& lines, std::size_t selected, int rows, bool mark_selected = true);
  /// Returns the frame. After drawing into it from row() on, pass the number of used rows to took().
  Frame& frame() { return frame_; }
  int row() const { return row_; }
  void took(int rows) { row_ += rows; }

  /// Returns the page, with the footer.
  Frame finish();

 private:
  Frame frame_;
  Look look_;
  std::vector<Line> footer_;
  int least_footer_row_;
  int row_ = 0;
};

}  // namespace robosim::terminal
