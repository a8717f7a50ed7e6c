#include "sim/record/record_csv.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "sim/base/csv.h"

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
  if (agent >= result::kMostAgents || has_header_) return;
  cells_.resize(std::max(cells_.size(), agent + 1));
  Cells& cells = cells_[agent];
  for (std::size_t i = 0; i < started.readings.size(); ++i) {
    const std::size_t column = robots_.empty()
                                   ? (readings_.push_back(started.readings[i]), readings_.size() - 1)
                                   : column_of(started.readings[i]);
    cells.resize(std::max(cells.size(), column + 1), kEmpty);
    cells[column] = i;
  }
  if (++begun_ >= std::max<std::size_t>(robots_.size(), 1)) write_header();
}

void CsvRecorder::add(const wire::Event& event) {
  if (const auto* started = std::get_if<wire::Started>(&event))
    begin_robot(*started);
  else if (const auto* sample = std::get_if<wire::Sample>(&event))
    add_row(*sample);
}

void CsvRecorder::write_header() {
  has_header_ = true;
  std::string header = robots_.empty() ? "t_us" : "t_us,robot";
  header += ",x_mm,y_mm,yaw_rad,speed_mm_s,cross_track_mm,left,right";
  for (const std::string& name : readings_) header += "," + csv_field(name);
  file_.add(header += "\n");
  for (const wire::Sample& sample : std::exchange(early_, {})) add_row(sample);
}

void CsvRecorder::add_row(const wire::Sample& s) {
  const auto agent = static_cast<std::size_t>(s.agent);
  // Ignores robots that are not in the request.
  if (agent >= result::kMostAgents || (!robots_.empty() && agent >= robots_.size())) return;
  if (!has_header_) return early_.push_back(s);
  cells_.resize(std::max(cells_.size(), agent + 1));  // a robot that has not begun has no readings yet
  const Cells& cells = cells_[agent];
  const std::string name = robots_.empty() ? "" : "," + robots_[agent];
  const double pose[] = {s.x_mm, s.y_mm, s.yaw_rad, s.speed_mm_s, s.cross_track_mm, s.left, s.right};
  last_.resize(std::size(pose) + readings_.size());
  LastNumber* last = last_.data();
  char* to = put_number(file_.room(name.size() + (1 + last_.size()) * (kLongestNumber + 1)), s.t_us);
  to = std::copy(name.begin(), name.end(), to);
  for (const double number : pose) {
    *to++ = ',';
    to = last++->put(to, number);
  }
  for (std::size_t column = 0; column < readings_.size(); ++column, ++last) {
    *to++ = ',';
    const std::size_t reading = column < cells.size() ? cells[column] : kEmpty;
    if (reading < s.readings.size()) to = last->put(to, s.readings[reading]);
  }
  *to++ = '\n';
  file_.added(to);
}

void CsvRecorder::finish(const result::RunResult&) {
  if (!has_header_) write_header();
  file_.finish();
}

}  // namespace robosim::record
