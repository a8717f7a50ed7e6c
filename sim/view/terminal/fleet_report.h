// Formats the final screen of a run of several robots: one line per robot.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/map/map.h"
#include "sim/view/terminal/report.h"

namespace robosim::terminal {

struct FleetRow {
  std::string name;
  std::string sketch;  ///< sketch and robot are named as the user typed them
  std::string robot;
  std::string target;
  result::RunResult result;
  Trail trail;
};

struct FleetReport {
  std::string map;
  wire::Started started;  ///< of the first robot
  std::vector<FleetRow> rows;
  std::optional<double> wall_s;  ///< empty = not shown
};

/// Returns the screen. Without a `map` (null) there is no picture.
std::string fleet_screen(const FleetReport& report, const map::Map* map, int columns, Look look);

}  // namespace robosim::terminal
