// Describes a path for people and programs: its length, crossings, smallest radius.
#pragma once

#include "sim/grid/path.h"

namespace robosim::grid {

struct PathSurvey {
  double length_m = 0.0;
  bool is_closed = false;
  double gap_m = 0.0;              ///< from the end to the beginning, straight, where it is not closed
  int crossings = 0;               ///< places where it crosses itself
  int corners = 0;                 ///< sharp ones
  double smallest_radius_m = 0.0;  ///< of its arcs; 0 = it has none
};

/// Surveys a path. `closed_within` is the distance of both ends, m, up to which it counts as closed.
/// Crossings are found between chords of 5 mm. Two crossings that are closer, or a touch without crossing,
/// may not count.
PathSurvey survey_path(const Path& path, double closed_within);

}  // namespace robosim::grid
