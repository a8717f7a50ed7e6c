// The tiles of RoboCupJunior Rescue Line, as rcj-rescue-cms (commit 14ba0ba2) numbers them: an implementation
// detail of read_rescue().
//
// What is drawn on them was measured in the editor's pictures, to about 2 % of a tile (6 mm): that is how
// exact they are themselves. Tiles are 300 mm wide, their lines 20 mm.
#pragma once

#include <span>
#include <string_view>

#include "sim/course/polyline.h"

namespace robosim::course {

/// A line across a tile: points in percent of its side, x to the right and y down, "0,50 100,50"; `/` before
/// a point: no paint from the point before to it. Bends are rounded with a radius, mm; 0 = sharp.
struct TileLine {
  std::string_view points;
  double rounding_mm = 0.0;
};

struct TileKind {
  std::string_view id;
  TileLine lines[2] = {};
  /// Of an intersection: the sides (L T R B) that are joined to the middle.
  std::string_view arms = {};
  /// Where the route leaves an intersection by which it was entered: "LT TL" = left to top, top to left.
  std::string_view turns = {};
  /// Green squares in the corners of an intersection: a b above, c d below it, to the left and the right.
  std::string_view greens = {};
  bool simplified = false;  ///< what is drawn is the way through it, not what is on it
};

std::span<const TileKind> rescue_tiles();
/// In percent of a tile; roundings in m.
Polyline polyline_of(const TileLine& line);

/// A side of a tile, L T R or B, turned clockwise by quarters; and a point, percent, about the tile's middle.
char turned(char side, int quarters);
Vec2 turned(Vec2 percent, int quarters);
Vec2 middle_of(char side);
/// The side on which a point is, 0 = within the tile.
char side_of(Vec2 percent);

inline constexpr std::string_view kRescueExit = "58cfd6549792e9313b1610e0";
inline constexpr std::string_view kRescueSeesaw = "58cfd6549792e9313b1610df";
/// Of the evacuation zone.
inline bool is_evacuation(std::string_view id) {
  return id == "58cfd6549792e9313b1610e1" || id == "58cfd6549792e9313b1610e2" ||
         id == "58cfd6549792e9313b1610e3";
}

}  // namespace robosim::course
