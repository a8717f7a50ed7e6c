// A closed loop of line that does not cross itself: the outline of squares of a lattice.
#pragma once

#include <string>
#include <vector>

#include "sim/worlds/line_network.h"

namespace robosim::worlds {

struct Track {
  int apart = 4;                   ///< cells: the smallest width of a square
  std::vector<Knot> squares;       ///< by their upper left corners, sorted
  std::vector<int> columns, rows;  ///< cells: their widths and heights
  std::vector<Piece> gaps;         ///< pieces whose middle cell is not painted
  Piece start;                     ///< the piece with the start in its middle

  /// Returns the loop; its start is meaningless.
  LineNetwork outline() const;
  /// Returns whether it is one loop, with its start on it, and not in a gap.
  bool is_sound() const;

  /// Returns tracks that are a step smaller, sound ones only. Repeated calls end after finitely many steps.
  std::vector<Track> smaller() const;
  /// Returns the grid of a map file: `S`, and `3` for gaps.
  std::string grid() const;
};

struct TrackLimits {
  int squares = 1;
  int apart = 4;
  int gaps = 0;
};
Track lay_out(const TrackLimits& limits, const RandomSource& rng);

}  // namespace robosim::worlds
