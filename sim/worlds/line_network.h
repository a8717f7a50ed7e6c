// A network of lines on a lattice: what random maps are made of, and shrunk by.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "sim/worlds/die.h"

namespace robosim::worlds {

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
  int apart = 3;              ///< cells: the least distance of two knots; 2 at least, or lines would touch
  int most_ways = 4;          ///< of a knot
  std::vector<Piece> pieces;  ///< in order
  std::vector<int> columns, rows;  ///< cells from a lattice column, or row, to the next
  std::vector<Piece> obstacles;    ///< pieces in whose middle one stands
  Knot start;

  /// Neighbouring knots with a line between.
  std::vector<Knot> neighbours(Knot knot) const;
  bool is_connected() const;
  /// Knots with one neighbour, in row order.
  std::vector<Knot> stations() const;
  /// A connected network that starts at a station; no knot has too many ways.
  bool is_sound() const;

  /// Networks that are a step smaller, sound ones only; the smallest come first. Ends after finitely many
  /// steps.
  std::vector<LineNetwork> smaller() const;
  /// Cells from lines to the map's edge: what a robot needs to turn round.
  int margin() const { return std::max(apart, 3); }
  /// The column, or row, of the map's cell at a knot.
  int column_of(int x) const;
  int row_of(int y) const;
  /// The rows of a map, without the start.
  std::vector<std::string> cells() const;
  /// As a map file.
  std::string map() const;
};

struct GrowthLimits {
  int pieces = 1;
  int apart = 3;
  int most_ways = 4;  ///< of a knot
  int cycles = 0;
  int obstacles = 0;
};
/// A random sound network, with at most so many pieces.
LineNetwork grow(const GrowthLimits& limits, const Die& die);

}  // namespace robosim::worlds
