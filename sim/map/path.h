// A line that does not follow cells: a sequence of straights, arcs and corners. Each piece begins at the end
// of the previous piece, in the same direction. Courses of most competitions consist of such lines. A map
// describes such a line in a table [[path]] (docs/reference/maps.md).
#pragma once

#include <vector>

#include "sim/base/error.h"
#include "sim/base/vec.h"

namespace robosim::map {

/// A straight, an arc of a circle, or a corner, which has no length.
struct PathPiece {
  Pose begin;           ///< in the world frame, in m; its heading is the direction of travel
  double length = 0;    ///< length of the centre line in m
  double turn = 0;      ///< in rad, positive to the left; 0 = straight
  double radius = 0;    ///< in m; 0 = straight, or a corner
  bool is_gap = false;  ///< a part that the robot must follow, but that is not painted
  int paint = 0;        ///< index in paints_of()

  /// Returns the centre of an arc.
  Vec2 centre() const { return begin.position + left_of(begin.heading) * (turn < 0.0 ? -radius : radius); }
  /// Returns the position and heading at a distance along the piece in m.
  Pose at(double along) const;
};

class Path {
 public:
  /// Maximum length of a path in m.
  static constexpr double kMost = 10'000.0;

  explicit Path(Pose begin) : end_(begin) {}

  void add_straight(double length, bool is_gap = false);
  /// Adds an arc; `turn` is in rad, positive to the left.
  void add_arc(double radius, double turn, bool is_gap = false);
  void add_corner(double turn);
  /// Sets the paint of the last piece, an index in paints_of().
  void paint_last(int paint) { pieces_.back().paint = paint; }

  const std::vector<PathPiece>& pieces() const { return pieces_; }
  double length() const { return length_; }
  Pose begin() const { return pieces_.empty() ? end_ : pieces_.front().begin; }
  Pose end() const { return end_; }
  /// Returns whether the end meets the beginning, within `most` m and 5 degrees.
  bool is_closed(double most) const;
  /// Returns the pose at a distance along the path in m. A closed path continues at its beginning; an open
  /// path stops at its ends.
  Pose at(double along, bool closed) const;

  Place place;  ///< place of the path in the map's file

 private:
  void add(double length, double turn, double radius, bool is_gap);

  std::vector<PathPiece> pieces_;
  std::vector<double> begins_;  // for each piece, the distance in m along the path to its beginning
  Pose end_;
  double length_ = 0.0;
};

}  // namespace robosim::map
