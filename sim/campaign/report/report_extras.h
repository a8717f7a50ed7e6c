// Adds replays, and the places where robots left the line, to a report's table.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "sim/campaign/report/junit_cases.h"
#include "sim/campaign/report/report_options.h"
#include "sim/campaign/report/rerun.h"
#include "sim/campaign/report/sweep_rows.h"

namespace robosim::campaign {

/// The places where robots left the line of a map; maps with equal text count as one.
struct LeftOn {
  std::string map;  ///< its name
  record::FloorShapes floor;
  std::vector<std::array<double, 2>> places_mm;
  std::size_t runs = 0;
};

struct ReportExtras {
  std::map<std::size_t, std::string> replays;  ///< links from the page, by a run's number
  std::vector<LeftOn> left;
  std::size_t other = 0;      ///< number of runs with a different result when repeated
  std::size_t not_made = 0;   ///< number of failed runs beyond ReportOptions::runs, not repeated
  std::size_t written = 0;    ///< number of replays that were written for this page
  std::string cannot;         ///< the first reason why a run cannot be repeated
  std::size_t cannot_be = 0;  ///< number of runs that cannot be repeated

  void add(const RecordingExtract& extract);

 private:
  std::map<std::string, std::size_t> places_;  ///< index in `left`, by the map's text
};

/// Returns a sentence for each kind of run that is not shown: runs with another result, and runs that cannot
/// be repeated.
std::vector<std::string> remarks_on(const ReportExtras& extras);

/// Reads the command of a run, as a table or `robosim test` has stored it. Throws InputError.
using ReadCommand = std::function<launch::RunSettings(const std::string& command)>;

/// Repeats runs of a sweep's table, beginning with the worst run of each combination. Only these worst runs
/// get a replay.
ReportExtras extras_of_runs(const std::vector<SweptRun>& runs, const ReportOptions& options,
                            const ReadCommand& read_command, const launch::Listener& listener);

/// Repeats the failed checks in `file`, the JUnit XML of `robosim test`, and adds their replays. Begins with
/// the first failure of each sketch. For C++ tests, adds the replays that the tests have saved.
ReportExtras extras_of_cases(const std::vector<JunitCase>& cases, const std::string& file,
                             const ReportOptions& options, const ReadCommand& read_command,
                             const launch::Listener& listener);

/// Returns a link to a file, from a page in `folder`.
std::string link_to(const std::filesystem::path& file, const std::filesystem::path& folder);

/// Returns the worst run of a combination. Among failed runs, this is the run with the fewest laps and
/// stations, then the shortest distance. Without failed runs, it is the slowest run, then the one with the
/// largest cross-track error.
std::size_t worst_of(const std::vector<SweptRun>& runs, const std::vector<std::size_t>& combination);

/// Returns the numbers of the runs with equal sketch, map, robot and target, in the table's order.
std::vector<std::vector<std::size_t>> combinations_of(const std::vector<SweptRun>& runs);

}  // namespace robosim::campaign
