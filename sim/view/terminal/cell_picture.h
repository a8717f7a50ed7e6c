// Draws a map for a robot that moves from cell to cell, with the robot, its trail and labels. Each cell is as
// large as possible on the screen. If the map is too large, only the part around the robot is drawn.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/map/map.h"
#include "sim/map/true_graph.h"
#include "sim/view/terminal/frame.h"

namespace robosim::terminal {

/// A label on a cell: "S1".
struct CellLabel {
  map::CellAt cell;
  std::string text;
  Ink ink = Ink::mark;
};

/// Returns labels "S1", "J1" for all stations and junctions of a graph.
std::vector<CellLabel> graph_labels(const map::TrueGraph& graph);

class CellPicture {
 public:
  /// The map must outlive the picture.
  explicit CellPicture(const map::Map& map);

  /// Adds a cell to the robot's trail.
  void add_trail(map::CellAt cell);
  void clear_trail() { trail_.clear(); }

  /// Draws into `rows` rows from `row` on, over the frame's whole width. `around` stays in view. Returns the
  /// number of rows used.
  int draw(Frame& frame, int row, int rows, map::CellAt around, const std::optional<map::Start>& robot,
           const std::vector<CellLabel>& labels, Look look);

 private:
  // The visible part: its first cell (x, y), and its size in cells. Each cell has `wide` x `high` characters.
  struct Part {
    int x = 0, y = 0;
    int columns = 0, rows = 0;
    int wide = 1, high = 1;
  };
  Part choose_part(int columns, int rows, map::CellAt around) const;
  void draw_cell(Frame& frame, int top, const Part& part, map::CellAt cell, Look look) const;
  bool was_on(map::CellAt cell) const {
    return !trail_.empty() && map_.contains(cell) && trail_[map_.index_of(cell)];
  }

  const map::Map& map_;
  int left_line_, top_line_, right_line_, bottom_line_;  // extent of the line, with a margin
  std::vector<bool> trail_;                              // by cell; empty until the robot has a position
  int left_ = 0, top_ = 0;                               // first cell of the last visible part
};

}  // namespace robosim::terminal
