// The log of a hunt, one line for each run, so that it can be resumed: DIR/runs.jsonl.
#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/base/file_lock.h"
#include "sim/cli/hunt/finding.h"

namespace robosim::cli {

/// The stored data of a run. Its test case is drawn again.
struct HuntRow {
  std::uint64_t run = 0;  ///< from 0
  double time_s = 0.0;
  bool reached = false;
  std::vector<std::string> traits;   ///< traits that no earlier run had
  Moment moment = {};                ///< of the first of these, if known
  std::vector<std::string> heard;    ///< promised texts of `sometimes` that no earlier run had
  std::size_t finding = 0;           ///< number of its finding, from 1; 0 = none
  std::optional<HuntFinding> fresh;  ///< the finding that it is the first of
};

/// The part of one of several machines.
struct HuntPart {
  std::filesystem::path folder;
  Shard shard;
  std::vector<HuntRow> rows;
};

/// Reads the parts. Throws InputError if a folder has no log, one of another hunt, or two are not parts of
/// one.
std::vector<HuntPart> read_parts(const std::vector<std::string>& folders, const std::string& from);

/// Used instead of a shard: such a folder has no runs of its own, and cannot be resumed.
inline constexpr const char* kMerged = "merged";

class HuntLog {
 public:
  /// Opens a log in an existing folder. `from` identifies the source of the runs, `part` is a shard, kMerged
  /// or nothing. With `resume` the rows of an equal hunt are read, and an incomplete last line is skipped.
  /// Throws InputError.
  HuntLog(const std::filesystem::path& folder, const std::string& from, const std::string& part, bool resume);

  /// Returns the row; null = no such run yet.
  const HuntRow* row(std::uint64_t run) const;
  /// Appends a row. Throws InputError if it cannot be written.
  void add(const HuntRow& row);

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  void put(const std::string& line);

  std::filesystem::path path_;
  FileLock claim_;
  std::map<std::uint64_t, HuntRow> rows_;
  std::unique_ptr<std::FILE, Close> file_;
};

}  // namespace robosim::cli
