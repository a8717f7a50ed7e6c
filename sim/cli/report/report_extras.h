// Additions of a report to its table: replays, and where robots left the line.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "sim/cli/arguments.h"
#include "sim/cli/report/junit_cases.h"
#include "sim/cli/report/rerun.h"
#include "sim/cli/report/sweep_rows.h"

namespace robosim::cli {

/// Where the robots of a map's runs left the line; maps of equal text count as one.
struct LeftOn {
  std::string map;  ///< its name
  record::FloorShapes floor;
  std::vector<std::array<double, 2>> places_mm;
  std::size_t runs = 0;
};

struct ReportExtras {
  std::map<std::size_t, std::string> replays;  ///< by the number of a run: a link from the page
  std::vector<LeftOn> left;
  std::size_t other = 0;      ///< runs with another result when they were repeated
  std::size_t not_made = 0;   ///< failed, too, but there were enough
  std::size_t written = 0;    ///< number of `replays` for this page
  std::string cannot;         ///< why runs cannot be repeated: the first reason
  std::size_t cannot_be = 0;  ///< and their number

  void add(const RecordingExtract& extract);

 private:
  std::map<std::string, std::size_t> places_;  ///< index in `left`, by the map's text
};

/// For a table: repeats runs, the worst of each combination first, and that one gets its replay.
ReportExtras extras_of_runs(const std::vector<SweptRun>& runs, const ReportArguments& arguments);

/// For tests: repeats the failed ones of robosim test, for each sketch the first one first, and they get
/// their replays. Those in C++ have saved theirs.
ReportExtras extras_of_cases(const std::vector<JunitCase>& cases, const ReportArguments& arguments);

/// Returns a link to a file, from a page in `folder`.
std::string link_to(const std::filesystem::path& file, const std::filesystem::path& folder);

/// Returns the run of a combination that is worth examining. Of failed runs it is the one with the fewest
/// laps and stations, then the shortest distance. If none has failed it is the slowest, then the one with the
/// largest cross-track error.
std::size_t worst_of(const std::vector<SweptRun>& runs, const std::vector<std::size_t>& combination);

/// Returns the numbers of the runs with equal sketch, map, robot and target, in the table's order.
std::vector<std::vector<std::size_t>> combinations_of(const std::vector<SweptRun>& runs);

}  // namespace robosim::cli
