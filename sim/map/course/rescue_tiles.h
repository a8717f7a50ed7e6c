// Lists the tiles of RoboCupJunior Rescue Line, with their numbers in rcj-rescue-cms (commit 14ba0ba2). This
// is an implementation detail of read_rescue().
//
// The drawings were measured in the editor's pictures, to about 2 % of a tile (6 mm), which is the accuracy
// of the pictures. Tiles are 300 mm wide, and lines are 20 mm wide.
#pragma once

#include <span>
#include <string_view>

#include "sim/map/course/polyline.h"

namespace robosim::course {

/// A line across a tile. Points are in percent of the tile's side, x to the right and y down: "0,50 100,50".
/// `/` before a point means that the line to this point is not painted. Bends are rounded with a radius in
/// mm; 0 = sharp.
struct TileLine {
  std::string_view points;
  double rounding_mm = 0.0;
};

struct TileKind {
  std::string_view id;
  TileLine lines[2] = {};
  /// For an intersection: the sides (L T R B) that lines join to the middle.
  std::string_view arms = {};
  /// For an intersection: the exit of the route for each entry. "LT TL" = left to top, top to left.
  std::string_view turns = {};
  /// Green squares in the corners of an intersection: a = upper left, b = upper right, c = lower left, d =
  /// lower right.
  std::string_view greens = {};
  bool simplified = false;  ///< only the way through the tile is drawn, not all its lines
};

std::span<const TileKind> rescue_tiles();
/// Returns a line of a tile, in percent of the tile, with roundings in m.
Polyline polyline_of(const TileLine& line);

/// Return a side (L T R or B), or a point in percent, after `quarters` clockwise quarter turns of the tile.
char turned(char side, int quarters);
Vec2 turned(Vec2 percent, int quarters);
Vec2 middle_of(char side);
/// Returns the side on which a point is; 0 = inside the tile.
char side_of(Vec2 percent);

inline constexpr std::string_view kRescueExit = "58cfd6549792e9313b1610e0";
inline constexpr std::string_view kRescueSeesaw = "58cfd6549792e9313b1610df";
/// Returns whether the tile belongs to the evacuation zone.
inline bool is_evacuation(std::string_view id) {
  return id == "58cfd6549792e9313b1610e1" || id == "58cfd6549792e9313b1610e2" ||
         id == "58cfd6549792e9313b1610e3";
}

}  // namespace robosim::course
