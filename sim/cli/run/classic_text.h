// The results of `robosim classic`, as text and as JSON.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/cli/arguments.h"
#include "sim/map/cells/survey.h"
#include "sim/map/cells/walk.h"

namespace robosim::cli {

struct TapedMove {
  cells::CellPose pose;  ///< pose and sense before the move
  cells::Sense sense;
  cells::Move move;
  double clock;  ///< simulated time after the move, seconds
};

struct ClassicReport {
  const map::Map& map;
  map::Start start;
  const ClassicArguments& arguments;
  std::optional<cells::Scan> scan;
  std::optional<cells::Walk> walk;
  std::vector<cells::Route> routes;
  const std::vector<TapedMove>& trace;
};

std::string classic_text(const ClassicReport& report);
/// Formats the report as robosim.classic/1, see docs/reference/classic.md.
std::string classic_json(const ClassicReport& report);

}  // namespace robosim::cli
