// The page of `robosim report`: HTML and SVG in one file, without scripts.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "sim/cli/report/junit_cases.h"
#include "sim/cli/report/sweep_rows.h"
#include "sim/record/floor_shapes.h"

namespace robosim::cli {

/// Where the robots of a map's runs left the line.
struct LeftOn {
  std::optional<record::FloorShapes> floor;
  std::vector<std::array<double, 2>> places_mm;
  std::size_t runs = 0;  ///< that were made again
};

/// What is known of runs beyond their table.
struct Shown {
  std::map<std::size_t, std::string> replays;  ///< of a run by its number: a page beside this one
  std::map<std::string, LeftOn> left;          ///< by map
  std::size_t other = 0;                       ///< runs that came out otherwise when they were made again
  std::size_t not_made = 0;                    ///< failed, too, but there were enough
};

/// The run of a combination that is worth looking at: the first that failed, or the slowest.
std::size_t worst_of(const std::vector<SweptRun>& runs, const std::vector<std::size_t>& combination);

/// Numbers of the runs with equal sketch, map, robot and target, in the table's order.
std::vector<std::vector<std::size_t>> combinations_of(const std::vector<SweptRun>& runs);

std::string sweep_page(const std::string& file, const std::vector<SweptRun>& runs, const Shown& shown);
std::string junit_page(const std::string& file, const std::vector<JunitCase>& cases);

}  // namespace robosim::cli
