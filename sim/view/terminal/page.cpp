#include "sim/view/terminal/page.h"

#include <fmt/format.h>

#include <algorithm>

#include "sim/view/terminal/text.h"

namespace robosim::terminal {

Page::Page(TerminalSize size, Look look, const std::vector<Line>& footer)
    : frame_(size.columns, size.rows), look_(look) {
  for (const Line& line : footer) {
    if (line.text.empty()) footer_.push_back(line);
    for (std::string& row : wrap(line.text, size.columns)) footer_.push_back({std::move(row), line.ink});
  }
  least_footer_row_ = std::max(size.rows - static_cast<int>(footer_.size()), 0);
}

void Page::line(std::string_view text, Ink ink) {
  if (rows_left() > 0) frame_.put(0, row_++, text, ink);
}

void Page::text(std::string_view text, Ink ink) {
  for (const std::string& row : wrap(text, columns())) line(row, ink);
}

void Page::list(const std::vector<std::string>& lines, std::size_t selected, int rows, bool mark_selected) {
  const auto room = static_cast<std::size_t>(std::max(std::min(rows, rows_left()), 1));
  std::size_t first = 0, count = lines.size();
  if (count > room) {
    count = room > 2 ? room - 1 : 1;  // one row shows the visible range
    first = std::min(selected - std::min(selected, count / 2), lines.size() - count);
  }
  for (std::size_t i = first; i < first + count; ++i) {
    const bool is_selected = mark_selected && i == selected;
    line((mark_selected ? is_selected ? "> " : "  " : "") + lines[i], is_selected ? Ink::strong : Ink::plain);
  }
  if (count < lines.size() && room > 2)
    line(fmt::format("  {} to {} of {}: arrow up and down show the others", first + 1, first + count,
                     lines.size()),
         Ink::faint);
}

Frame Page::finish() {
  row_ = std::clamp(row_, 0, least_footer_row_);
  for (const Line& line : footer_) frame_.put(0, row_++, line.text, line.ink);
  return std::move(frame_);
}

}  // namespace robosim::terminal
