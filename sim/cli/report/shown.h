// What a report shows of runs beyond its table: replays, and where robots left the line.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "sim/cli/arguments.h"
#include "sim/cli/report/junit_cases.h"
#include "sim/cli/report/made_again.h"
#include "sim/cli/report/sweep_rows.h"

namespace robosim::cli {

/// Where the robots of a map's runs left the line; maps of equal text are one.
struct LeftOn {
  std::string map;  ///< its name
  record::FloorShapes floor;
  std::vector<std::array<double, 2>> places_mm;
  std::size_t runs = 0;
};

struct Shown {
  std::map<std::size_t, std::string> replays;  ///< of a run by its number: a link from the page
  std::vector<LeftOn> left;
  std::size_t other = 0;      ///< runs that came out otherwise when they were made again
  std::size_t not_made = 0;   ///< failed, too, but there were enough
  std::size_t written = 0;    ///< of `replays`, for this page
  std::string cannot;         ///< why runs cannot be made again: of the first
  std::size_t cannot_be = 0;  ///< and how many

  void add(const Seen& seen);

 private:
  std::map<std::string, std::size_t> places_;  ///< in `left`, by the map's text
};

/// Of a table: runs are made again, the worst of each combination first, and that one gets its replay.
Shown look_at_runs(const std::vector<SweptRun>& runs, const ReportArguments& arguments);

/// Of tests: those of robosim test that failed are made again and get their replay, of each sketch the first
/// one first; those in C++ have kept theirs.
Shown look_at_cases(const std::vector<JunitCase>& cases, const ReportArguments& arguments);

/// A link to a file, from a page in `folder`.
std::string link_to(const std::filesystem::path& file, const std::filesystem::path& folder);

/// The run of a combination that is worth looking at: of those that failed the one with the fewest laps and
/// stations, of equal ones that which has driven least; where none has failed the slowest, of equal ones the
/// farthest off the line.
std::size_t worst_of(const std::vector<SweptRun>& runs, const std::vector<std::size_t>& combination);

/// Numbers of the runs with equal sketch, map, robot and target, in the table's order.
std::vector<std::vector<std::size_t>> combinations_of(const std::vector<SweptRun>& runs);

}  // namespace robosim::cli
