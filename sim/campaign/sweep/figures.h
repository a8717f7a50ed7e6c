// The measurements of a run that a check can limit and a table shows, with their names in `run --json`. They
// are the run's time, and the numbers among its metrics and resources.
#pragma once

#include <string>
#include <vector>

#include "sim/result/run_result.h"

namespace robosim::campaign {

struct Figure {
  const char* name;
  bool chip_only;  ///< only known on an emulated chip

  /// Returns one value, one value for each lap, or no value if it is unknown.
  std::vector<double> values(const result::RunResult& result) const;
};

const std::vector<Figure>& figures();

/// Formats a value for display: with four digits.
std::string figure_text(double value);

}  // namespace robosim::campaign
