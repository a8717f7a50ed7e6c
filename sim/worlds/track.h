// A closed loop of line that does not cross itself: the outline of squares of a lattice.
#pragma once

#include <string>
#include <vector>

#include "sim/worlds/line_network.h"

namespace robosim::worlds {

struct Track {
  int apart = 4;                   ///< cells: the least width of a square
  std::vector<Knot> squares;       ///< by their upper left corners, in order
  std::vector<int> columns, rows;  ///< cells: their widths and heights
  std::vector<Piece> gaps;         ///< pieces whose middle cell is not painted
  Piece start;                     ///< in whose middle the start is

  /// The loop; its start means nothing.
  LineNetwork outline() const;
  /// One loop, that starts on it, not in a gap.
  bool is_sound() const;

  /// Tracks that are a step smaller, sound ones only. Ends after finitely many steps.
  std::vector<Track> smaller() const;
  /// The grid of a map file: `S`, and `3` for gaps.
  std::string grid() const;
};

struct TrackLimits {
  int squares = 1;
  int apart = 4;
  int gaps = 0;
};
Track lay_out(const TrackLimits& limits, const Die& die);

}  // namespace robosim::worlds
