// The figures of a run that a check can limit and a table shows, under the names that `run --json` gives
// them: its time, and the numbers among its metrics and resources.
#pragma once

#include <string>
#include <vector>

#include "sim/wire/run_result.h"

namespace robosim::cli {

struct Figure {
  const char* name;
  bool chip_only;  ///< known of a chip's emulator only

  /// One value, one for each lap, or none if it is not known.
  std::vector<double> values(const wire::RunResult& result) const;
};

const std::vector<Figure>& figures();

/// For people: four digits are enough.
std::string figure_text(double value);

}  // namespace robosim::cli
