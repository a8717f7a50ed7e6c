// Draws a part of the floor in braille dots: 2 x 4 per character. The dots are square, because characters are
// twice as high as wide.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/base/vec.h"
#include "sim/map/map.h"
#include "sim/map/stripes.h"
#include "sim/view/terminal/frame.h"

namespace robosim::terminal {

/// The visible part of the floor, and its scale.
struct Window {
  int columns = 0;     ///< characters
  int rows = 0;        ///< characters
  Vec2 top_left;       ///< m, world frame
  double dot_m = 0.0;  ///< side of a dot, m
  bool operator==(const Window&) const = default;
};

/// A rectangle of the floor, m.
struct Area {
  Vec2 least;
  Vec2 most;
};

/// Returns the area of the whole map.
Area area_of(const map::Map& map);

/// Returns a window of at most `columns` x `rows` characters that shows `area` as large as possible. A map
/// cell is at most 16 dots wide. If a cell is wider than a dot, its width is a whole number of dots.
Window fit(const map::Map& map, Area area, int columns, int rows);

/// A character on the floor: a station's number, an arrow.
struct Mark {
  Vec2 at;  ///< m
  Glyph glyph;
};

/// Returns an arrow for a heading, in steps of 45 degrees.
char32_t arrow(double yaw_rad);

class FloorPicture {
 public:
  /// The map must outlive the picture.
  explicit FloorPicture(const map::Map& map);

  const Window& window() const { return window_; }
  /// Redraws walls, hills and line for a new window. Clears the trail.
  void look_at(const Window& window);

  void add_trail(Vec2 from, Vec2 to);
  /// Replaces the robot's drawing: its closed outline, and a line from its middle to its front.
  void set_robot(const std::vector<Vec2>& outline, Vec2 middle, Vec2 front);

  /// Draws the picture with its top left corner at (column, row) of the frame. Marks are on top.
  void draw(Frame& frame, int column, int row, const std::vector<Mark>& marks, Look look) const;

 private:
  using Layer = std::vector<std::uint8_t>;  // braille bits, one byte per character

  struct Dot {
    int x, y;
  };
  Dot dot_of(Vec2 p) const;
  /// Returns whether p is within `reach_m` of a centre line. With `whole`, uses half of the line's width if
  /// this is larger than `reach_m`.
  bool is_painted(Vec2 p, double reach_m, bool whole) const;
  /// Returns the symbol for the floor at p, the middle of a character. On a hill, `^`, `>`, `v` and `<` point
  /// uphill, `:` is level ground, and `=` is a seesaw. Elsewhere, `~` is a surface. Returns 0 otherwise.
  char relief_at(Vec2 p) const;
  bool has_surface(Vec2 p) const;
  void set(Layer& layer, Dot dot) const;
  void draw_line(Layer& layer, Vec2 from, Vec2 to) const;

  const map::Map& map_;
  std::vector<map::Paint> paints_;
  map::Stripes stripes_;
  Window window_;
  Layer wall_;    // 1 = the character's middle is wall
  Layer relief_;  // symbol for a hill or a surface at each character, or 0
  Layer line_, thin_line_, trail_, robot_;
};

}  // namespace robosim::terminal
