#include "sim/record/track.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <optional>

#include "sim/base/csv.h"
#include "sim/base/error.h"
#include "sim/base/file.h"
#include "sim/record/record_page.h"
#include "sim/wire/json_reader.h"

namespace robosim::record {
namespace {

struct Unit {
  const char* name;
  double factor;  ///< converts to s, or mm
};
constexpr Unit kTimes[] = {{"t", 1},       {"t_s", 1},       {"time", 1},       {"time_s", 1},
                           {"seconds", 1}, {"t_ms", 1e-3},   {"time_ms", 1e-3}, {"millis", 1e-3},
                           {"t_us", 1e-6}, {"micros", 1e-6}, {"t_ns", 1e-9}};
constexpr Unit kPlaces[] = {{"", 1}, {"_mm", 1}, {"_cm", 10}, {"_m", 1000}};  // suffixes of x or y

struct Found {
  std::size_t column;
  double factor;
};

template <std::size_t N>
std::optional<Found> find(const std::vector<std::string>& names, const std::string& before,
                          const Unit (&units)[N]) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    std::string name = names[i];
    std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::tolower(c); });
    for (const Unit& unit : units)
      if (name == before + unit.name) return Found{i, unit.factor};
  }
  return std::nullopt;
}

/// Splits a line into cells. If `separator` is not a comma, reads commas as decimal points.
std::vector<std::string> cells_of(const std::string& line, char separator) {
  std::vector<std::string> cells;
  if (separator == ',')
    cells = csv_fields(line).value_or(cells);
  else
    for (std::size_t from = 0; from <= line.size();) {
      const std::size_t end = std::min(line.find(separator, from), line.size());
      cells.push_back(line.substr(from, end - from));
      std::replace(cells.back().begin(), cells.back().end(), ',', '.');
      from = end + 1;
    }
  for (std::string& cell : cells) {
    cell.erase(0, std::min(cell.find_first_not_of(' '), cell.size()));
    cell.erase(cell.find_last_not_of(' ') + 1);
  }
  return cells;
}

std::optional<double> number_in(const std::vector<std::string>& cells, std::size_t column) {
  if (column >= cells.size()) return std::nullopt;
  double value = 0.0;
  const char* const end = cells[column].data() + cells[column].size();
  const auto [read_to, error] = std::from_chars(cells[column].data(), end, value);
  if (error != std::errc() || read_to != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

/// Interpolates linearly between two samples.
double at(const Track& track, const std::vector<double>& values, std::size_t before, double t) {
  if (before + 1 >= values.size()) return values.back();
  const double step = track.t_s[before + 1] - track.t_s[before];
  const double share = step > 0.0 ? (t - track.t_s[before]) / step : 0.0;
  return values[before] + share * (values[before + 1] - values[before]);
}

}  // namespace

Track track_of(const Recording& recording, std::size_t robot) {
  const RobotRecord& record = recording.header().of(robot);
  Track track;
  track.robot = record.name;
  track.what = fmt::format("{} on {}, seed {}, {}: {} after {:.2f} s", record.sketch, recording.header().map,
                           record.result.seed, record.target, record.result.verdict, record.result.time_s);
  const auto samples = recording.stream("samples", robot);
  if (samples.size() < 3) return track;
  for (const double t_us : samples[0]) track.t_s.push_back(t_us * 1e-6);
  track.x_mm = samples[1];
  track.y_mm = samples[2];
  return track;
}

Track track_of_table(std::string_view text, const std::string& file) {
  Track track;
  char separator = ',';
  std::vector<std::string> names;
  std::optional<Found> time, x, y;
  int number = 0;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string line(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    ++number;
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (line.starts_with('#') || line.find_first_not_of(" \t") == line.npos) continue;
    if (names.empty()) {
      separator = line.find(';') != line.npos ? ';' : line.find('\t') != line.npos ? '\t' : ',';
      names = cells_of(line, separator);
      time = find(names, "", kTimes);
      x = find(names, "x", kPlaces);
      y = find(names, "y", kPlaces);
      if (!time || !x || !y)
        throw InputError(
            {file, number},
            "the log's columns: expected time, x and y (t_s, t_ms or t_us; x_mm or x_m; y_mm or y_m), got " +
                wire::excerpt(line));
      continue;
    }
    const std::vector<std::string> cells = cells_of(line, separator);
    const auto t = number_in(cells, time->column), at_x = number_in(cells, x->column),
               at_y = number_in(cells, y->column);
    if (!t || !at_x || !at_y)
      throw InputError({file, number},
                       "time, x and y: expected numbers, got the line " + wire::excerpt(line));
    const double t_s = *t * time->factor;
    if (!track.t_s.empty() && t_s < track.t_s.back())
      throw InputError({file, number},
                       fmt::format("time goes backwards, from {} s to {} s", track.t_s.back(), t_s));
    track.t_s.push_back(t_s);
    track.x_mm.push_back(*at_x * x->factor);
    track.y_mm.push_back(*at_y * y->factor);
  }
  if (track.t_s.size() < 2)
    throw InputError({file}, "the log is too short: expected a line of names and at least two rows");
  const bool has_units = names[x->column].size() > 1 && names[y->column].size() > 1;
  track.what = fmt::format("a log of {:.2f} s{}", track.t_s.back() - track.t_s.front(),
                           has_units ? "" : ", x and y read as mm");
  return track;
}

std::vector<Track> read_tracks(const std::filesystem::path& file, std::string* bytes) {
  std::string content = read_file(file);
  const bool is_table = file.extension() == ".csv" || file.extension() == ".txt";
  std::vector<Track> tracks;
  if (is_table) {
    tracks.push_back(track_of_table(content, file.string()));
  } else {
    const Recording recording = Recording::read(file);
    for (std::size_t i = 0; i < recording.header().robot_count(); ++i)
      tracks.push_back(track_of(recording, i));
  }
  if (bytes) *bytes = is_table ? std::move(content) : recording_in(std::move(content));
  return tracks;
}

Apart apart(const Track& one, const Track& other) {
  Apart found;
  std::size_t near = 0, counted = 0;
  for (std::size_t i = 0; i < one.t_s.size() && !other.t_s.empty(); ++i) {
    const double t = one.t_s[i];
    if (t < other.t_s.front()) continue;
    if (t > other.t_s.back()) break;
    while (near + 1 < other.t_s.size() && other.t_s[near + 1] <= t) ++near;
    const double mm = std::hypot(one.x_mm[i] - at(other, other.x_mm, near, t),
                                 one.y_mm[i] - at(other, other.y_mm, near, t));
    if (mm >= 1.0 && found.from_1mm_s < 0.0) found.from_1mm_s = t;
    if (mm > found.most_mm) found.most_mm = mm, found.most_s = t;
    found.mean_mm += mm;
    found.until_s = t;
    ++counted;
  }
  if (counted == 0) throw InputError("the two runs have no time in common");
  found.mean_mm /= static_cast<double>(counted);
  return found;
}

}  // namespace robosim::record
