// Where a robot was, of a recording or of a table that a real one has logged; and how far two of them are
// apart.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "sim/record/recording.h"

namespace robosim::record {

struct Track {
  std::string what;  ///< for people: "PidFollower on tight, seed 2, host: reached after 7.70 s"
  std::vector<double> t_s, x_mm, y_mm;
  std::string robot = {};  ///< its name, of one of several
};

/// Of the robot of that number.
Track track_of(const Recording& recording, std::size_t robot = 0);

/// A table: its first line names the columns, one of them the time (t_s, t_ms, t_us …), two the place (x_mm
/// or x_m, y_mm or y_m …); commas, semicolons or tabs between; lines that begin with # are left out. Throws
/// InputError with file and line.
Track track_of_table(std::string_view text, const std::string& file);

/// Of each robot in a .rec or a page, or of a table; `bytes`, if not null, gets what a page can show of it: a
/// .rec or a table.
std::vector<Track> read_tracks(const std::filesystem::path& file, std::string* bytes = nullptr);

/// How far apart two robots are at equal times, as long as both are known.
struct Apart {
  double until_s = 0.0;      ///< both are known
  double from_1mm_s = -1.0;  ///< the first time that they are 1 mm apart; negative = never
  double most_mm = 0.0, most_s = 0.0;
  double mean_mm = 0.0;
};
/// Throws InputError if there is no time at which both are known.
Apart apart(const Track& one, const Track& other);

}  // namespace robosim::record
