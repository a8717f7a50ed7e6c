// What a path is like, for people and programs: its length, crossings, smallest radius.
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

/// `closed_within`: m, between the end and the beginning of a path that is taken as closed. Crossings are
/// found between chords of 5 mm: two that are nearer to each other, or touch without crossing, may not be
/// counted.
PathSurvey survey_path(const Path& path, double closed_within);

}  // namespace robosim::grid
