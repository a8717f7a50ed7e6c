// The options of a comparison.
#pragma once

#include <string>
#include <vector>

#include "sim/launch/run_settings.h"

namespace robosim::campaign {

struct CompareOptions {
  std::vector<std::string> targets;  ///< all others are compared with the first
  std::string moves;                 ///< with several robots: the one that changes its target; empty = all
  launch::RunSettings each;          ///< settings of each run, except target and seed
};

}  // namespace robosim::campaign
