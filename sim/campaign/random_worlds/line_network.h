// Describes a network of lines on a lattice: the basis for generating random maps, and for shrinking them.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "sim/campaign/random_worlds/random_source.h"

namespace robosim::random_worlds {

/// A crossing of lattice lines, by column and row.
struct Knot {
  int x = 0, y = 0;
  auto operator<=>(const Knot&) const = default;
};

/// A piece of line between two neighbouring knots: from `at` to the right, or downward.
struct Piece {
  Knot at;
  bool down = false;
  Knot end() const { return down ? Knot{at.x, at.y + 1} : Knot{at.x + 1, at.y}; }
  auto operator<=>(const Piece&) const = default;
};

bool has(const std::vector<Piece>& pieces, const Piece& piece);

struct LineNetwork {
  int apart = 3;              ///< cells: smallest distance between knots; at least 2, or lines would touch
  int most_ways = 4;          ///< maximum number of pieces at a knot
  std::vector<Piece> pieces;  ///< sorted
  std::vector<int> columns, rows;  ///< cells from each lattice column, or row, to the next
  std::vector<Piece> obstacles;    ///< pieces with an obstacle in their middle
  Knot start;

  /// Returns the neighbouring knots that a line connects to `knot`.
  std::vector<Knot> neighbours(Knot knot) const;
  bool is_connected() const;
  /// Returns the knots with one neighbour, in row order.
  std::vector<Knot> stations() const;
  /// Returns whether the network is connected, starts at a station, and has at most `most_ways` pieces at
  /// each knot.
  bool is_sound() const;

  /// Returns networks that are one step smaller. All are sound, and the smallest come first. Shrinking a
  /// result again and again ends after finitely many steps.
  std::vector<LineNetwork> smaller() const;
  /// Returns the number of cells between lines and the map's edge: enough for a robot to turn round.
  int margin() const { return std::max(apart, 3); }
  /// Returns the column of the map's cell at a knot; row_of() returns the row.
  int column_of(int x) const;
  int row_of(int y) const;
  /// Returns the rows of a map, without the start.
  std::vector<std::string> cells() const;
  /// Returns the text of a map file.
  std::string map() const;
};

struct GrowthLimits {
  int pieces = 1;
  int apart = 3;
  int most_ways = 4;  ///< maximum number of pieces at a knot
  int cycles = 0;
  int obstacles = 0;
};
/// Returns a random sound network with at most `limits.pieces` pieces.
LineNetwork grow(const GrowthLimits& limits, const RandomSource& rng);

}  // namespace robosim::random_worlds
