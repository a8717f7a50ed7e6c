#include "sim/view/terminal/cell_picture.h"

#include <fmt/format.h>

#include <algorithm>

namespace robosim::terminal {
namespace {

using map::Cell;
using map::CellAt;
using map::Direction;

// Characters, indexed by a cell's neighbours: 1 east + 2 south + 4 west + 8 north.
constexpr char32_t kBoxes[] = U"•╶╷┌╴─┐┬╵└│├┘┴┤┼";
constexpr char32_t kAscii[] = U"o-|+--++|+|+++++";
constexpr char32_t kArrows[] = U"►▼◄▲";
constexpr char32_t kAsciiArrows[] = U">v<^";

// Chooses `count` visible cells from the cells `least` to `most`, and returns the first of them. Keeps `now`,
// the present first cell, if this keeps `middle` away from the edges. Otherwise, centres `middle`.
int keep_in_sight(int now, int least, int most, int count, int middle) {
  const int margin = count / 5;
  if (middle < now + margin || middle >= now + count - margin) now = middle - count / 2;
  return std::clamp(now, least, most - count);
}

}  // namespace

std::vector<CellLabel> graph_labels(const map::TrueGraph& graph) {
  std::vector<CellLabel> labels;
  int number = 0;
  for (const map::GraphJunction& junction : graph.junctions)
    labels.push_back({junction.cell, fmt::format("J{}", ++number), Ink::mark});
  number = 0;
  for (const map::GraphStation& station : graph.stations)
    labels.push_back({station.cell, fmt::format("S{}", ++number), Ink::good});
  return labels;
}

CellPicture::CellPicture(const map::Map& map) : map_(map) {
  int right = 0, bottom = 0;
  left_line_ = map.width;
  top_line_ = map.height;
  for (std::size_t i = 0; i < map.cells.size(); ++i) {
    if (!map::is_line(map.cells[i])) continue;
    const CellAt c = map.cell_at(i);
    left_line_ = std::min(left_line_, c.x);
    top_line_ = std::min(top_line_, c.y);
    right = std::max(right, c.x);
    bottom = std::max(bottom, c.y);
  }
  left_line_ = std::max(left_line_ - 1, 0);
  top_line_ = std::max(top_line_ - 1, 0);
  right_line_ = std::min(right + 2, map.width);
  bottom_line_ = std::min(bottom + 2, map.height);
}

void CellPicture::add_trail(CellAt cell) {
  if (!map_.contains(cell)) return;
  if (trail_.empty()) trail_.resize(map_.cells.size());
  trail_[map_.index_of(cell)] = true;
}

CellPicture::Part CellPicture::choose_part(int columns, int rows, CellAt around) const {
  constexpr int kScales[][2] = {{4, 2}, {2, 1}, {1, 1}};
  Part part;
  part.wide = 2;
  for (const auto& [wide, high] : kScales) {
    if (map_.width * wide > columns || map_.height * high > rows) continue;
    part.wide = wide;
    part.high = high;
    part.columns = map_.width;
    part.rows = map_.height;
    return part;
  }
  // If the map does not fit, floor and walls around the line are dropped first.
  const int least_x = std::min(left_line_, around.x), most_x = std::max(right_line_, around.x + 1);
  const int least_y = std::min(top_line_, around.y), most_y = std::max(bottom_line_, around.y + 1);
  part.columns = std::clamp(columns / part.wide, 1, most_x - least_x);
  part.rows = std::clamp(rows / part.high, 1, most_y - least_y);
  part.x = keep_in_sight(left_, least_x, most_x, part.columns, around.x);
  part.y = keep_in_sight(top_, least_y, most_y, part.rows, around.y);
  return part;
}

void CellPicture::draw_cell(Frame& frame, int top, const Part& part, CellAt cell, Look look) const {
  const Cell kind = map_.at(cell);
  if (kind == Cell::floor) return;
  const int column = (cell.x - part.x) * part.wide;
  const int row = top + (cell.y - part.y) * part.high;
  if (kind == Cell::wall) {
    for (int r = 0; r < part.high; ++r)
      for (int c = 0; c < part.wide; ++c)
        frame.set(column + c, row + r, {look.utf8 ? U'▒' : U'#', Ink::wall});
    return;
  }
  const Ink ink = was_on(cell) ? Ink::trail : Ink::line;
  const unsigned lines = map::line_neighbours(map_, cell);
  const bool is_gap = kind == Cell::gap;
  const auto sign = [&](unsigned neighbours) {
    if (is_gap) return U'.';
    return look.utf8 ? kBoxes[neighbours] : kAscii[neighbours];
  };
  frame.set(column, row, kind == Cell::obstacle ? Glyph{U'x', Ink::bad} : Glyph{sign(lines), ink});
  const auto joint_ink = [&](Direction d) {
    return was_on(cell) && was_on(ahead(cell, d)) ? Ink::trail : Ink::line;
  };
  if (map::has(lines, Direction::east) && cell.x + 1 < part.x + part.columns)
    for (int c = 1; c < part.wide; ++c)
      frame.set(column + c, row, {sign(1u << 0 | 1u << 2), joint_ink(Direction::east)});
  if (map::has(lines, Direction::south) && cell.y + 1 < part.y + part.rows)
    for (int r = 1; r < part.high; ++r)
      frame.set(column, row + r, {sign(1u << 1 | 1u << 3), joint_ink(Direction::south)});
}

int CellPicture::draw(Frame& frame, int row, int rows, CellAt around, const std::optional<map::Start>& robot,
                      const std::vector<CellLabel>& labels, Look look) {
  if (rows <= 0) return 0;
  Part part = choose_part(frame.columns(), rows, around);
  const bool is_part = part.columns < map_.width || part.rows < map_.height;
  if (is_part && rows > 4) part = choose_part(frame.columns(), rows - 1, around);
  left_ = part.x;
  top_ = part.y;
  for (int y = part.y; y < part.y + part.rows; ++y)
    for (int x = part.x; x < part.x + part.columns; ++x) draw_cell(frame, row, part, {x, y}, look);

  const auto shows = [&](CellAt c) {
    return c.x >= part.x && c.y >= part.y && c.x < part.x + part.columns && c.y < part.y + part.rows;
  };
  const auto column_of = [&](CellAt c) { return (c.x - part.x) * part.wide; };
  const auto row_of = [&](CellAt c) { return row + (c.y - part.y) * part.high; };
  for (const CellLabel& label : labels) {
    if (!shows(label.cell)) continue;
    // If the line comes from the right and there is room, the label ends on its cell. Otherwise the label
    // begins on its cell. A robot on the cell shifts the label by one column.
    const int length = static_cast<int>(label.text.size());
    const int beside = robot && robot->cell == label.cell ? 1 : 0;
    const bool ends_here =
        map::line_neighbours(map_, label.cell) == 1u && column_of(label.cell) - length + 1 - beside >= 0;
    frame.put(column_of(label.cell) + (ends_here ? 1 - length - beside : beside), row_of(label.cell),
              label.text, label.ink);
  }
  if (robot && shows(robot->cell)) {
    const auto d = static_cast<std::size_t>(robot->facing);
    frame.set(column_of(robot->cell), row_of(robot->cell),
              {look.utf8 ? kArrows[d] : kAsciiArrows[d], Ink::robot});
  }
  const int drawn = part.rows * part.high;
  if (!is_part || rows <= 4) return drawn;
  frame.put(0, row + drawn,
            fmt::format("columns {} to {} of {}, rows {} to {} of {}", part.x, part.x + part.columns - 1,
                        map_.width, part.y, part.y + part.rows - 1, map_.height),
            Ink::faint);
  return drawn + 1;
}

}  // namespace robosim::terminal
