#include "sim/record/record_csv.h"

#include <algorithm>
#include <iterator>

#include "sim/base/csv.h"
#include "sim/base/file.h"
#include "sim/record/number_text.h"

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

void CsvRecorder::begin_robot(const wire::Started& started) {
  const auto agent = static_cast<std::size_t>(started.agent);
  if (agent >= wire::kMostAgents) return;
  cells_.resize(std::max(cells_.size(), agent + 1));
  Cells& cells = cells_[agent];
  for (std::size_t i = 0; i < started.readings.size(); ++i) {
    const std::size_t column = robots_.empty()
                                   ? (readings_.push_back(started.readings[i]), readings_.size() - 1)
                                   : column_of(started.readings[i]);
    cells.resize(std::max(cells.size(), column + 1), kEmpty);
    cells[column] = i;
  }
}

void CsvRecorder::add(const wire::Event& event) {
  if (const auto* started = std::get_if<wire::Started>(&event))
    begin_robot(*started);
  else if (const auto* sample = std::get_if<wire::Sample>(&event))
    add_row(*sample);
}

void CsvRecorder::add_row(const wire::Sample& s) {
  const auto agent = static_cast<std::size_t>(s.agent);
  // A robot that nobody has asked for is none.
  if (agent >= wire::kMostAgents || (!robots_.empty() && agent >= robots_.size())) return;
  cells_.resize(std::max(cells_.size(), agent + 1));  // one that has not begun has no readings
  const Cells& cells = cells_[agent];
  const std::string name = robots_.empty() ? "" : "," + robots_[agent];
  const double pose[] = {s.x_mm, s.y_mm, s.yaw_rad, s.speed_mm_s, s.cross_track_mm, s.left, s.right};
  const std::size_t begin = rows_.size();
  rows_.resize(begin + name.size() + (1 + std::size(pose) + readings_.size()) * (kLongestNumber + 1));
  char* to = put_number(rows_.data() + begin, s.t_us);
  to = std::copy(name.begin(), name.end(), to);
  for (const double number : pose) {
    *to++ = ',';
    to = put_number(to, number);
  }
  for (std::size_t column = 0; column < readings_.size(); ++column) {
    *to++ = ',';
    const std::size_t reading = column < cells.size() ? cells[column] : kEmpty;
    if (reading < s.readings.size()) to = put_number(to, s.readings[reading]);
  }
  rows_.resize(static_cast<std::size_t>(to - rows_.data()));
  row_ends_.push_back({rows_.size(), readings_.size()});
}

std::string CsvRecorder::text() const {
  std::string text = robots_.empty() ? "t_us" : "t_us,robot";
  text += ",x_mm,y_mm,yaw_rad,speed_mm_s,cross_track_mm,left,right";
  for (const std::string& name : readings_) text += "," + csv_field(name);
  text += "\n";
  text.reserve(text.size() + rows_.size() + row_ends_.size());
  std::size_t begin = 0;
  for (const Row& row : row_ends_) {
    text.append(rows_, begin, row.end - begin).append(readings_.size() - row.width, ',') += '\n';
    begin = row.end;
  }
  return text;
}

void CsvRecorder::finish(const wire::RunResult&) { write_file(path_, text()); }

}  // namespace robosim::record
