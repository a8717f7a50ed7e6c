// The measurements of a run that a check can limit and a table shows, with their names in `run --json`. They
// are its time, and the numbers among its metrics and resources.
#pragma once

#include <string>
#include <vector>

#include "sim/wire/run_result.h"

namespace robosim::cli {

struct Figure {
  const char* name;
  bool chip_only;  ///< only known on an emulated chip

  /// Returns one value, one for each lap, or none if it is unknown.
  std::vector<double> values(const wire::RunResult& result) const;
};

const std::vector<Figure>& figures();

/// Formats a value for display: with four digits.
std::string figure_text(double value);

}  // namespace robosim::cli
