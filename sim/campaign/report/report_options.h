// The options of a report.
#pragma once

#include <cstddef>
#include <string>

#include "sim/launch/run_settings.h"

namespace robosim::campaign {

struct ReportOptions {
  std::string out = "report.html";  ///< the page; replays go into a folder next to it
  std::size_t runs = 40;            ///< maximum number of repeated runs
  launch::RunSettings each;         ///< the settings of the sweep, for a table without commands
};

}  // namespace robosim::campaign
