// Describes a closed loop of line that does not cross itself: the outline of squares of a lattice.
#pragma once

#include <string>
#include <vector>

#include "sim/campaign/random_worlds/line_network.h"

namespace robosim::random_worlds {

struct Track {
  int apart = 4;                   ///< cells: the smallest width of a square
  std::vector<Knot> squares;       ///< sorted upper left corners
  std::vector<int> columns, rows;  ///< cells: widths and heights of the lattice
  std::vector<Piece> gaps;         ///< pieces whose middle cell is not painted
  Piece start;                     ///< the piece with the start in its middle

  /// Returns the loop as a network. The network's start is meaningless.
  LineNetwork outline() const;
  /// Returns whether the track is one loop whose start lies on it, and not in a gap.
  bool is_sound() const;

  /// Returns tracks that are one step smaller, and sound. Shrinking a result again and again ends after
  /// finitely many steps.
  std::vector<Track> smaller() const;
  /// Returns the grid of a map file, with `S` for the start, and `3` for gaps.
  std::string grid() const;
};

struct TrackLimits {
  int squares = 1;
  int apart = 4;
  int gaps = 0;
};
Track lay_out(const TrackLimits& limits, const RandomSource& rng);

}  // namespace robosim::random_worlds
