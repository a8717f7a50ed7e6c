// Measures a path: its length, its crossings, its smallest radius.
#pragma once

#include "sim/map/path.h"

namespace robosim::map {

struct PathSurvey {
  double length_m = 0.0;
  bool is_closed = false;
  double gap_m = 0.0;              ///< straight distance from the end to the beginning
  int crossings = 0;               ///< places where the path crosses itself
  int corners = 0;                 ///< number of sharp corners
  double smallest_radius_m = 0.0;  ///< smallest radius of an arc; 0 = no arcs
};

/// Surveys a path. A path counts as closed if its ends are within `closed_within` m of each other. Crossings
/// are found between chords of 5 mm. The survey may miss crossings that are closer together than 5 mm. It may
/// also miss places where the path only touches itself.
PathSurvey survey_path(const Path& path, double closed_within);

}  // namespace robosim::map
