// What `robosim classic` found, for people and for programs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/classic/survey.h"
#include "sim/classic/walk.h"
#include "sim/cli/arguments.h"

namespace robosim::cli {

struct TapedMove {
  classic::CellPose pose;  ///< and sense: before the move
  classic::Sense sense;
  classic::Move move;
  double clock;  ///< after it
};

struct ClassicReport {
  const grid::Map& map;
  grid::Start start;
  const ClassicArguments& arguments;
  std::optional<classic::Scan> scan;
  std::optional<classic::Walk> walk;
  std::vector<classic::Route> routes;
  const std::vector<TapedMove>& trace;
};

std::string classic_text(const ClassicReport& report);
/// Schema robosim.classic/1, see docs/formats.md.
std::string classic_json(const ClassicReport& report);

}  // namespace robosim::cli
