#include "sim/testing/run_log.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/base/escaped.h"

namespace robosim::testing {

void RunLog::add(Entry entry) {
  const auto later = std::upper_bound(events.begin(), events.end(), entry.t_ns,
                                      [](std::int64_t t, const Entry& other) { return t < other.t_ns; });
  events.insert(later, std::move(entry));
}

std::string seconds(std::int64_t ns) {
  std::string text = fmt::format("{:.3f}", static_cast<double>(ns) * 1e-9);
  // Keeps at least two decimals, and drops the third if it is 0.
  if (text.back() == '0') text.pop_back();
  return text + " s";
}

std::string seconds(Duration time) { return seconds(time.count()); }

std::string place_of(const Pose& pose) {
  return fmt::format("column {}, row {} (x {:.0f} mm, y {:.0f} mm)", pose.column, pose.row, pose.x_mm,
                     pose.y_mm);
}

std::string on_one_line(const std::string& text) {
  std::string result;
  for (const char c : text) result += c == '\n' ? "\\n" : c == '\r' ? "\\r" : std::string(1, c);
  return result;
}

std::string in_quotes(const std::string& text) { return '"' + escaped(text) + '"'; }

Moment moment_of(const RunLog& log, const wire::Sample& sample) {
  Moment moment;
  moment.t = std::chrono::microseconds(sample.t_us);
  moment.pose = {sample.x_mm, sample.y_mm, sample.yaw_rad};
  const double cell_mm = log.started.cell_mm;
  if (cell_mm > 0.0) {
    moment.pose.column = static_cast<int>(std::floor(sample.x_mm / cell_mm));
    moment.pose.row = log.started.height - 1 - static_cast<int>(std::floor(sample.y_mm / cell_mm));
  }
  moment.speed = {sample.speed_mm_s};
  moment.cross_track = {sample.cross_track_mm};
  moment.left = sample.left;
  moment.right = sample.right;
  moment.station = sample.at_station;
  moment.readings = sample.readings;
  bool senses = false, sees = false;
  // A reading is 0 over white, and 1 over black. In the profile `typical`, a sensor's reading of the floor
  // alone may be 0.1 more or less.
  constexpr double kLeast = 0.25;
  const auto is_line = [&](double reading) {
    return (log.has_light_line ? 1.0 - reading : reading) >= kLeast;
  };
  for (std::size_t i = 0; i < std::min(sample.readings.size(), log.is_line_sensor.size()); ++i) {
    senses = senses || log.is_line_sensor[i];
    sees = sees || (log.is_line_sensor[i] && is_line(sample.readings[i]));
  }
  moment.off_line = senses && !sees;
  return moment;
}

}  // namespace robosim::testing
