// Building blocks of the pages of `robosim report`: HTML and SVG in one file, without scripts.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "sim/campaign/report/report_extras.h"

namespace robosim::campaign {

inline constexpr std::size_t kMostRows = 5'000, kMostFailures = 200;  ///< most rows of a table

std::string page_of(const std::string& title, const std::string& body);

/// Returns ", the first 10 of 25" for a table that shows `most` of `count` rows; "" if it shows all.
std::string rows_shown(std::size_t count, std::size_t most);

/// Returns a bar with its numbers: "3/4".
std::string share_bar(std::size_t good, std::size_t all);

/// Returns a histogram of values, with bins of equal width in 0..most.
std::string bars(const std::vector<double>& values, double most, const std::string& unit);

double most_of(const std::vector<double>& values);

/// Returns `markup`, as a link if the run has a replay.
std::string linked(const ReportExtras& extras, std::size_t run, const std::string& markup);

/// Draws the places where robots left the line. Then states how many runs are not shown, and why.
std::string places_left(const ReportExtras& extras);

}  // namespace robosim::campaign
