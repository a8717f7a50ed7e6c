#include "sim/record/record_csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "sim/base/csv.h"
#include "sim/base/file.h"

namespace robosim::record {

void CsvRecorder::begin(const RecordedRun& run) {
  for (const RecordedRobot& robot : run.robots) robots_.push_back(robot.name);
}

std::size_t CsvRecorder::column_of(const std::string& reading) {
  const auto known = std::find(readings_.begin(), readings_.end(), reading);
  if (known != readings_.end()) return static_cast<std::size_t>(known - readings_.begin());
  readings_.push_back(reading);
  return readings_.size() - 1;
}

void CsvRecorder::add(const wire::Event& event) {
  if (const auto* started = std::get_if<wire::Started>(&event)) {
    const auto agent = static_cast<std::size_t>(started->agent);
    if (agent >= wire::kMostAgents) return;
    columns_.resize(std::max(columns_.size(), agent + 1));
    for (const std::string& name : started->readings)
      columns_[agent].push_back(robots_.empty() ? (readings_.push_back(name), readings_.size() - 1)
                                                : column_of(name));
  } else if (const auto* sample = std::get_if<wire::Sample>(&event)) {
    add_row(*sample);
  }
}

void CsvRecorder::add_row(const wire::Sample& s) {
  std::string row = fmt::format("{},", s.t_us);
  const auto agent = static_cast<std::size_t>(s.agent);
  // A robot that nobody has asked for is none.
  if (agent >= wire::kMostAgents || (!robots_.empty() && agent >= robots_.size())) return;
  columns_.resize(std::max(columns_.size(), agent + 1));  // one that has not begun has no readings
  if (!robots_.empty()) row += robots_[agent] + ",";
  fmt::format_to(std::back_inserter(row), "{},{},{},{},{},{},{}", s.x_mm, s.y_mm, s.yaw_rad, s.speed_mm_s,
                 s.cross_track_mm, s.left, s.right);
  std::vector<std::string> cells(readings_.size());
  for (std::size_t i = 0; i < std::min(s.readings.size(), columns_[agent].size()); ++i)
    cells[columns_[agent][i]] = fmt::format("{}", s.readings[i]);
  for (const std::string& cell : cells) row += "," + cell;
  rows_.push_back(std::move(row));
  widths_.push_back(cells.size());
}

std::string CsvRecorder::text() const {
  std::string text = robots_.empty() ? "t_us" : "t_us,robot";
  text += ",x_mm,y_mm,yaw_rad,speed_mm_s,cross_track_mm,left,right";
  for (const std::string& name : readings_) text += "," + csv_field(name);
  text += "\n";
  for (std::size_t i = 0; i < rows_.size(); ++i)
    text += rows_[i] + std::string(readings_.size() - widths_[i], ',') + "\n";
  return text;
}

void CsvRecorder::finish(const wire::RunResult&) { write_file(path_, text()); }

}  // namespace robosim::record
