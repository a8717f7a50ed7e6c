#include "sim/map/picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace robosim::map {
namespace {

// The characters of a picture. The index in `square` and `round` is the sum of a line cell's neighbours: 1
// east, 2 south, 4 west, 8 north.
struct Signs {
  const char* square[16];
  const char* round[16];
  const char* arrow[4];  // by Direction
  const char* wall;
  const char* gap_across;
  const char* gap_down;
};

constexpr Signs kBoxDrawing = {
    {"•", "╶", "╷", "┌", "╴", "─", "┐", "┬", "╵", "└", "│", "├", "┘", "┴", "┤", "┼"},
    {"•", "╶", "╷", "╭", "╴", "─", "╮", "┬", "╵", "╰", "│", "├", "╯", "┴", "┤", "┼"},
    {"►", "▼", "◄", "▲"},
    "▒",
    "╌",
    "╎"};
constexpr Signs kAscii = {{"o", "-", "|", "+", "-", "-", "+", "+", "|", "+", "|", "+", "+", "+", "+", "+"},
                          {"o", "-", "|", "+", "-", "-", "+", "+", "|", "+", "|", "+", "+", "+", "+", "+"},
                          {">", "v", "<", "^"},
                          "#",
                          ".",
                          "."};

constexpr unsigned kEast = 1;
constexpr unsigned kWest = 4;

// A visible range of columns or rows.
struct Span {
  int from = 0;
  int count = 0;
  bool holds(int n) const { return n >= from && n < from + count; }
};

// Returns a span of at most `most` columns or rows around `middle`, within 0 to `size` - 1.
Span fit(int size, int most, int middle) {
  const int count = std::clamp(most, 1, size);
  return {std::clamp(middle - count / 2, 0, size - count), count};
}

class Picture {
 public:
  Picture(const Map& map, const Start& start, const PictureOptions& options)
      : map_(map), start_(start), signs_(options.ascii ? kAscii : kBoxDrawing) {
    margin_ = static_cast<int>(std::to_string(map.height - 1).size()) + 1;
    const int room = options.columns - margin_;
    per_cell_ = map.width * 2 <= room ? 2 : 1;
    columns_ = fit(map.width, room / per_cell_, start.cell.x);
    rows_ = fit(map.height, options.rows - 4, start.cell.y);
    canvas_.assign(static_cast<std::size_t>(rows_.count),
                   std::vector<std::string>(static_cast<std::size_t>(columns_.count * per_cell_), " "));
    for (int y = rows_.from; y < rows_.from + rows_.count; ++y)
      for (int x = columns_.from; x < columns_.from + columns_.count; ++x) draw_cell({x, y});
  }

  void label(const Station& station) {
    const std::string text = std::to_string(station.id);
    const bool beside = station.cell == start_.cell;  // the start's arrow occupies the cell
    const bool line_east = has(line_neighbours(map_, station.cell), Direction::east);
    const int at = (station.cell.x - columns_.from) * per_cell_;
    const int length = static_cast<int>(text.size());
    write(station.cell, line_east ? at - length + (beside ? 0 : 1) : at + (beside ? 1 : 0), text);
  }
  void mark(CellAt cell, const std::string& sign) { write(cell, (cell.x - columns_.from) * per_cell_, sign); }
  void draw_start() { mark(start_.cell, signs_.arrow[static_cast<std::size_t>(start_.facing)]); }

  std::string text() const {
    std::string text = ruler();
    for (int y = rows_.from; y < rows_.from + rows_.count; ++y) {
      std::string line = fmt::format("{:>{}} ", y, margin_ - 1);
      for (const std::string& sign : canvas_[static_cast<std::size_t>(y - rows_.from)]) line += sign;
      line.erase(line.find_last_not_of(' ') + 1);
      text += line + '\n';
    }
    return text;
  }

  std::string clipped() const {
    if (columns_.count == map_.width && rows_.count == map_.height) return "";
    return fmt::format(
        "Only columns {} to {} of {} and rows {} to {} of {} are shown: the map is larger than the screen.\n",
        columns_.from, columns_.from + columns_.count - 1, map_.width, rows_.from,
        rows_.from + rows_.count - 1, map_.height);
  }

  const char* wall() const { return signs_.wall; }
  const char* gap() const { return signs_.gap_across; }
  const char* arrow() const { return signs_.arrow[static_cast<std::size_t>(start_.facing)]; }
  bool shows(Cell kind) const {
    for (int y = rows_.from; y < rows_.from + rows_.count; ++y)
      for (int x = columns_.from; x < columns_.from + columns_.count; ++x)
        if (map_.at({x, y}) == kind) return true;
    return false;
  }

 private:
  void draw_cell(CellAt cell) {
    const Cell kind = map_.at(cell);
    if (kind == Cell::floor) return;
    const unsigned lines = line_neighbours(map_, cell);
    const char* sign = (map_.corner_m > 0.0 ? signs_.round : signs_.square)[lines];
    if (kind == Cell::wall) sign = signs_.wall;
    if (kind == Cell::gap) sign = (lines & (kEast | kWest)) != 0 ? signs_.gap_across : signs_.gap_down;
    if (kind == Cell::obstacle) sign = "x";
    mark(cell, sign);
    if (per_cell_ == 1) return;
    const char* joint = " ";
    if (kind == Cell::wall) joint = signs_.wall;
    if (is_line(kind) && has(lines, Direction::east)) {
      const bool gap = kind == Cell::gap || map_.at({cell.x + 1, cell.y}) == Cell::gap;
      joint = gap ? signs_.gap_across : signs_.square[kEast | kWest];
    }
    write(cell, (cell.x - columns_.from) * per_cell_ + 1, joint);
  }

  // Writes one sign, or ASCII text, to column `at` of the cell's row. Clips text at the edge.
  void write(CellAt cell, int at, const std::string& text) {
    if (!rows_.holds(cell.y) || !columns_.holds(cell.x)) return;
    auto& row = canvas_[static_cast<std::size_t>(cell.y - rows_.from)];
    const bool ascii = static_cast<unsigned char>(text[0]) < 0x80;
    for (std::size_t i = 0; i < (ascii ? text.size() : 1); ++i) {
      const int column = at + static_cast<int>(i);
      if (column < 0 || column >= static_cast<int>(row.size())) continue;
      row[static_cast<std::size_t>(column)] = ascii ? std::string(1, text[i]) : text;
    }
  }

  // Returns a line with the numbers of every fifth column, or of fewer columns if the numbers are too long.
  std::string ruler() const {
    const int widest = static_cast<int>(std::to_string(columns_.from + columns_.count).size());
    int step = 5;
    while (step * per_cell_ < widest + 1) step += 5;
    std::string line(static_cast<std::size_t>(margin_), ' ');
    for (int x = (columns_.from + step - 1) / step * step; x < columns_.from + columns_.count; x += step) {
      const int at = margin_ + (x - columns_.from) * per_cell_;
      line.resize(static_cast<std::size_t>(at), ' ');
      line += std::to_string(x);
    }
    return line + '\n';
  }

  const Map& map_;
  const Start& start_;
  const Signs& signs_;
  int margin_ = 0;
  int per_cell_ = 2;
  Span columns_;
  Span rows_;
  std::vector<std::vector<std::string>> canvas_;  // by row and column; each element is one sign
};

}  // namespace

std::string draw(const Map& map, const Network& network, const Start& start, const PictureOptions& options) {
  Picture picture(map, start, options);
  for (const CellAt cell : network.unreachable) picture.mark(cell, "?");
  for (const Station& station : network.stations) picture.label(station);
  picture.draw_start();
  std::string key = fmt::format("{} start", picture.arrow());
  if (network.stations.size() == 1) key += ", 1 the station";
  if (network.stations.size() > 1) key += fmt::format(", 1 to {} stations", network.stations.size());
  if (!network.unreachable.empty()) key += ", ? not reachable";
  if (picture.shows(Cell::wall)) key += fmt::format(", {} wall", picture.wall());
  if (picture.shows(Cell::gap)) key += fmt::format(", {} gap", picture.gap());
  if (picture.shows(Cell::obstacle)) key += ", x obstacle";
  return picture.text() + key + '\n' + picture.clipped();
}

}  // namespace robosim::map
