// The table of a sweep (--csv): docs/howto/sweeps.md describes its columns. The table is written during the
// sweep. However the sweep ends, the table's complete rows remain, and the sweep can be resumed.
#pragma once

#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "sim/campaign/run_file.h"
#include "sim/campaign/sweep/sweep_plan.h"
#include "sim/wire/messages.h"

namespace robosim::campaign {

/// The verdict of a run that Robosim failed to make; `why` then contains the reason.
inline constexpr const char* kErrorVerdict = "error";

/// The stored data of a run.
struct SweepOutcome {
  std::string verdict;  ///< empty = missing
  double time_s = 0.0;
  std::string why;
  double score = std::numeric_limits<double>::quiet_NaN();  ///< score of a competition; NaN = no score

  bool made() const { return !verdict.empty(); }
  bool reached() const { return verdict == "reached"; }
};

/// The columns of a table: all columns, all except the command, or all except the command and the score.
/// Tables of older versions lack columns, and are resumed without them.
enum class Columns { all, without_command, without_score };

/// Return the header and the row of a run, each with its line feed.
std::string sweep_header(Columns columns = Columns::all);
std::string sweep_row(const Combination& combination, const result::RunResult& result,
                      Columns columns = Columns::all);

struct SweepRow {
  std::size_t run = 0;
  SweepOutcome outcome;
  std::string line;  ///< with its line feed
};
/// Reads the rows of `text`, the content of a table: the run and outcome of each. An incomplete last row
/// without line feed is skipped. Throws InputError (with `file` and line) if a row is damaged, belongs to
/// another plan, or has other inputs. In newer tables, the last group of digits in `inputs` is a checksum of
/// the rest of the row.
std::vector<SweepRow> read_sweep_rows(const std::string& text, const std::string& file,
                                      const SweepPlan& plan);

/// Returns the rows of several tables, in the order of the runs, except rows with the verdict `error`. Throws
/// InputError like read_sweep_rows, and if two tables contain the same run.
std::vector<SweepRow> merged_rows(const std::vector<std::string>& files, const SweepPlan& plan);

class SweepTable {
 public:
  /// Begins a new file, or continues an existing file if `resume` is true. Stores the outcomes of an existing
  /// file in `outcomes`, which has one element for each run. Drops incomplete rows, and rows with the verdict
  /// `error`. Rejects an existing file without `resume`, and a file that another sweep is writing. Throws
  /// InputError.
  SweepTable(std::filesystem::path file, bool resume, const SweepPlan& plan,
             std::vector<SweepOutcome>& outcomes);

  /// Appends rows of other tables. Throws InputError if this table already has one of the runs.
  void take(const std::vector<SweepRow>& rows, std::vector<SweepOutcome>& outcomes);
  /// Appends a row. Throws InputError if that fails.
  void add(std::size_t run, const std::string& row);
  /// Sorts the complete rows by run, if necessary.
  void finish();

  /// Returns the columns of the file.
  Columns columns() const { return columns_; }

 private:
  RunFile file_;
  const SweepPlan& plan_;
  Columns columns_ = Columns::all;
  std::size_t next_ = 0;  ///< all rows in the file belong to lower run numbers
  bool ordered_ = true;
};

}  // namespace robosim::campaign
