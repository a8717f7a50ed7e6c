// What a hunt has done so far, a line for each run, so that it can be gone on with: DIR/runs.jsonl.
#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/base/write_claim.h"
#include "sim/cli/hunt/finding.h"

namespace robosim::cli {

/// What is kept of a run. Its world is drawn again.
struct HuntRow {
  std::uint64_t run = 0;  ///< from 0
  double time_s = 0.0;
  bool reached = false;
  std::vector<std::string> traits;   ///< that no run before it had
  Moment moment = {};                ///< of the first of these, where that is known
  std::vector<std::string> heard;    ///< that must come sometimes, likewise
  std::size_t finding = 0;           ///< whose number it is, from 1; 0 = none
  std::optional<HuntFinding> fresh;  ///< that it is the first of
};

/// What one of several machines has done.
struct HuntPart {
  std::filesystem::path folder;
  Shard shard;
  std::vector<HuntRow> rows;
};

/// Throws InputError where a folder has no log, one of another hunt, or two are not parts of one.
std::vector<HuntPart> read_parts(const std::vector<std::string>& folders, const std::string& from);

/// In place of a shard: such a folder has no runs of its own, and cannot be gone on with.
inline constexpr const char* kMerged = "merged";

class HuntLog {
 public:
  /// In a folder that is there. `from` is what the runs come from, `part` a shard, kMerged or nothing; with
  /// `resume` the rows of a hunt of the same are read, a last line that was cut off is left out. Throws
  /// InputError.
  HuntLog(const std::filesystem::path& folder, const std::string& from, const std::string& part, bool resume);

  /// null = it was not made.
  const HuntRow* row(std::uint64_t run) const;
  /// Throws InputError if it cannot be written.
  void add(const HuntRow& row);

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  void put(const std::string& line);

  std::filesystem::path path_;
  WriteClaim claim_;
  std::map<std::uint64_t, HuntRow> rows_;
  std::unique_ptr<std::FILE, Close> file_;
};

}  // namespace robosim::cli
