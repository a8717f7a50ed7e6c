// Reads the path of a robot, from a recording or from a table that a real robot has logged. Computes the
// distance between two paths.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "sim/record/recording.h"

namespace robosim::record {

struct Track {
  std::string what;  ///< for display: "PidFollower on tight, seed 2, host: reached after 7.70 s"
  std::vector<double> t_s, x_mm, y_mm;
  std::string robot = {};  ///< the robot's name if there are several robots
};

/// Returns the track of robot number `robot`.
Track track_of(const Recording& recording, std::size_t robot = 0);

/// Reads a table whose first line contains the names of the columns. One column is the time (t_s, t_ms, t_us
/// …), two are the position (x_mm or x_m, y_mm or y_m …). Separators are commas, semicolons or tabs; lines
/// that begin with # are skipped. Throws InputError with file and line.
Track track_of_table(std::string_view text, const std::string& file);

/// Reads the track of each robot from a .rec, a table, or a recorded page (.html). `bytes`, if not null,
/// receives the content of the table, of the .rec, or of the .rec inside the page.
std::vector<Track> read_tracks(const std::filesystem::path& file, std::string* bytes = nullptr);

/// The distance between two robots at equal times, while both positions are known.
struct Apart {
  double until_s = 0.0;      ///< end of the time that both tracks cover
  double from_1mm_s = -1.0;  ///< first time at which they are 1 mm apart; negative = never
  double most_mm = 0.0, most_s = 0.0;
  double mean_mm = 0.0;
};
/// Compares two tracks. Throws InputError if they have no time in common.
Apart apart(const Track& one, const Track& other);

}  // namespace robosim::record
