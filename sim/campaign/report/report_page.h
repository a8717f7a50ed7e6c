// Makes the pages of `robosim report`: for a sweep's table, and for the results of tests.
#pragma once

#include <string>
#include <vector>

#include "sim/campaign/report/report_extras.h"

namespace robosim::campaign {

std::string sweep_page(const std::string& file, const std::vector<SweptRun>& runs,
                       const ReportExtras& extras);
std::string junit_page(const std::string& file, const std::vector<JunitCase>& cases,
                       const ReportExtras& extras);

}  // namespace robosim::campaign
