// Logs a hunt in DIR/runs.jsonl, one line for each run, so that the hunt can be resumed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "sim/campaign/hunt/finding.h"
#include "sim/campaign/run_file.h"

namespace robosim::campaign {

/// The stored data of a run. The test case is not stored, because a resumed hunt draws it again.
struct HuntRow {
  std::uint64_t run = 0;  ///< from 0
  double time_s = 0.0;
  bool reached = false;
  std::vector<std::string> traits;   ///< traits that no earlier run had
  Moment moment = {};                ///< moment of the first new trait, if known
  std::vector<std::string> heard;    ///< texts of `sometimes` assertions that no earlier run had
  std::size_t finding = 0;           ///< number of the run's finding, from 1; 0 = none
  std::optional<HuntFinding> fresh;  ///< the finding, if this run is the first that shows it
  bool has_goal = false;             ///< the run had a goal
  std::string missed;                ///< verdict of a run that had a goal and missed it; otherwise empty
};

/// The part of a hunt that one machine ran.
struct HuntPart {
  std::filesystem::path folder;
  Shard shard;
  std::vector<HuntRow> rows;
};

/// Reads the parts. Throws InputError if a folder has no log or another hunt's log, or if the parts do not
/// belong together.
std::vector<HuntPart> read_parts(const std::vector<std::string>& folders, const std::string& from);

/// The value of `part` (see HuntLog) for a folder of merged shards. Such a folder has no runs of its own, and
/// cannot be resumed.
inline constexpr const char* kMerged = "merged";

class HuntLog {
 public:
  /// Opens a log in an existing folder. `from` is the fingerprint of the hunt's inputs
  /// (CampaignRunner::fingerprint()). `part` is a shard, kMerged or empty. With `resume`, reads the rows that
  /// the same hunt has written, and skips an incomplete last line. Throws InputError.
  HuntLog(const std::filesystem::path& folder, const std::string& from, const std::string& part, bool resume);

  /// Returns the row of a run; null if there is no such run yet.
  const HuntRow* row(std::uint64_t run) const;
  /// Appends a row. Throws InputError if it cannot be written.
  void add(const HuntRow& row);

 private:
  RunFile file_;
  std::map<std::uint64_t, HuntRow> rows_;
};

}  // namespace robosim::campaign
