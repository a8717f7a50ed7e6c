// The pages of `robosim report`.
#pragma once

#include <string>
#include <vector>

#include "sim/cli/report/shown.h"

namespace robosim::cli {

std::string sweep_page(const std::string& file, const std::vector<SweptRun>& runs, const Shown& shown);
std::string junit_page(const std::string& file, const std::vector<JunitCase>& cases, const Shown& shown);

}  // namespace robosim::cli
