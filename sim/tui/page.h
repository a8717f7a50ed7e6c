// One screenful of a session, from the top: a title, text, lists, a map; directly below them a footer, which
// is always shown.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sim/tui/frame.h"
#include "sim/tui/terminal.h"

namespace robosim::tui {

class Page {
 public:
  /// The footer's lines come last, wrapped, and are never pushed out.
  struct Line {
    std::string text;
    Ink ink = Ink::plain;
  };
  Page(TerminalSize size, Look look, const std::vector<Line>& footer);

  Look look() const { return look_; }
  int columns() const { return frame_.columns(); }
  /// How many rows are left above the footer.
  int rows_left() const { return least_footer_row_ - row_; }

  /// One row, cut at the edge.
  void line(std::string_view text, Ink ink = Ink::plain);
  /// As many rows as it needs.
  void text(std::string_view text, Ink ink = Ink::plain);
  void blank() { ++row_; }
  /// Lines of which those around `selected` are shown if there is no room for all, in at most `rows`.
  void list(const std::vector<std::string>& lines, std::size_t selected, int rows, bool mark_selected = true);
  /// The frame, for something drawn from row() on, which took so many rows.
  Frame& frame() { return frame_; }
  int row() const { return row_; }
  void took(int rows) { row_ += rows; }

  /// With the footer.
  Frame finish();

 private:
  Frame frame_;
  Look look_;
  std::vector<Line> footer_;
  int least_footer_row_;
  int row_ = 0;
};

}  // namespace robosim::tui
