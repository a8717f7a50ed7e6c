// Reads a sweep's table for a report. Accepts any table that `sweep --csv` has written, with any inputs.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace robosim::campaign {

struct SweptRun {
  std::string sketch, map, robot, target;
  std::uint64_t seed = 0;
  std::string verdict;
  double time_s = 0.0;
  double distance_m = 0.0;
  double cross_track_max_mm = 0.0;
  double laps = 0.0, stations = 0.0;  ///< complete laps, and visited stations
  std::string command;                ///< command that repeats the run; empty in a table of an older Robosim
  std::string trace_hash, why;

  bool reached() const { return verdict == "reached"; }
};

/// Reads the runs. Throws InputError with file and line.
std::vector<SweptRun> read_swept_runs(std::string_view text, const std::string& file);

}  // namespace robosim::campaign
