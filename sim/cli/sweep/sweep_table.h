// The table of a sweep (--csv): docs/sweeps.md has its columns. It is written during the sweep, so that it
// holds whole rows however the sweep ends, and can be resumed.
#pragma once

#include <cstdio>
#include <filesystem>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "sim/base/write_claim.h"
#include "sim/cli/sweep/sweep_plan.h"
#include "sim/wire/messages.h"

namespace robosim::cli {

/// The verdict of a run that Robosim failed to make; `why` then says what happened.
inline constexpr const char* kErrorVerdict = "error";

/// What a sweep keeps of each run.
struct SweepOutcome {
  std::string verdict;  ///< empty = not made
  double time_s = 0.0;
  std::string why;
  double score = std::numeric_limits<double>::quiet_NaN();  ///< of a competition; NaN = none

  bool made() const { return !verdict.empty(); }
  bool reached() const { return verdict == "reached"; }
};

/// Tables that were begun before there were scores have no column for them, and are gone on with as they are.
enum class Columns { all, without_score };

/// Each with its line feed.
std::string sweep_header(Columns columns = Columns::all);
std::string sweep_row(const Combination& combination, const wire::RunResult& result,
                      Columns columns = Columns::all);

/// The rows of `text`, the content of a table: which run each is of, and its outcome. A last row without line
/// feed was cut off and is left out. Throws InputError (with `file` and line) if a row is not of this plan,
/// or what it came from has changed since, or it is damaged: since tables have them, the last of the groups
/// of digits in `inputs` is a checksum of the rest of the row.
struct SweepRow {
  std::size_t run = 0;
  SweepOutcome outcome;
  std::string line;  ///< with its line feed
};
std::vector<SweepRow> read_sweep_rows(const std::string& text, const std::string& file,
                                      const SweepPlan& plan);

/// Those of several tables, in the order of the runs, without errors. Throws InputError as read_sweep_rows
/// does, and where two tables have the same run.
std::vector<SweepRow> merged_rows(const std::vector<std::string>& files, const SweepPlan& plan);

class SweepTable {
 public:
  /// Begins a file. With `resume` an existing one is gone on with: its outcomes are put into `outcomes`,
  /// which has one for each run; a row that was cut off, and those with the verdict `error`, go. Without, an
  /// existing one is refused, and so is one that another sweep is writing. Throws InputError.
  SweepTable(std::filesystem::path file, bool resume, const SweepPlan& plan,
             std::vector<SweepOutcome>& outcomes);

  /// Appends rows of other tables. Throws InputError if this one has a row of such a run.
  void take(const std::vector<SweepRow>& rows, std::vector<SweepOutcome>& outcomes);
  /// Appends a row. Throws InputError if that fails.
  void add(std::size_t run, const std::string& row);
  /// The rows are all there: puts them into the order of the runs, if they are not.
  void finish();

  /// Those of the file.
  Columns columns() const { return columns_; }

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  void put(const std::string& text);
  void open(const char* mode);

  std::filesystem::path path_;
  WriteClaim claim_;
  const SweepPlan& plan_;
  Columns columns_ = Columns::all;
  std::unique_ptr<std::FILE, Close> file_;
  std::size_t next_ = 0;  ///< all rows so far are of runs before this one
  bool ordered_ = true;
};

}  // namespace robosim::cli
