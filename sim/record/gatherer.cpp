// Implements Gatherer, which collects the data of a run (recording.h).
#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

#include "hal/board/board_spec.h"
#include "sim/base/file.h"
#include "sim/base/profile.h"
#include "sim/map/floor_image.h"
#include "sim/record/recording.h"
#include "sim/wire/json_reader.h"
#include "sim/wire/json_writer.h"

namespace robosim::record {
namespace {

// Larger maps are neither drawn nor stored.
constexpr std::uintmax_t kLargestMap_bytes = 1'000'000;

constexpr const char* kSamples = "samples";
constexpr std::int64_t kManyRows = 256;

std::vector<std::string> pins_of(const std::string& board) {
  std::vector<std::string> names;
  if (const BoardSpec* spec = find_board(board.c_str()))
    for (Pin pin = 0; pin < spec->pin_count; ++pin) names.push_back(spec->pins[pin].name);
  return names;
}

void set_robot(RobotRecord& record, const wire::RobotInfo& info) {
  record.robot_info = info;
  record.robot_info.file = std::filesystem::path(info.file).filename();
  record.pins = pins_of(info.board.name);
}

}  // namespace

void Gatherer::begin(const RecordedRun& run) {
  header_.robosim = run.robosim;
  header_.sketch = run.sketch;
  header_.map = run.map;
  header_.robot = run.robot;
  header_.target = run.target;
  header_.script = run.request.script;
  set_robot(header_, run.robot_info);
  if (!run.robots.empty()) header_.name = run.robots.front().name;
  for (std::size_t i = 1; i < run.robots.size(); ++i) {
    const RecordedRobot& robot = run.robots[i];
    RobotRecord& other = header_.others.emplace_back();
    other.name = robot.name;
    other.sketch = robot.sketch;
    other.robot = robot.robot;
    other.target = robot.target;
    other.script = run.request.agents.at(i - 1).script;
    set_robot(other, robot.info);
  }
  while (streams_.size() < header_.robot_count()) streams_.emplace_back(packer_.get());
  std::error_code error;
  const auto bytes = std::filesystem::file_size(run.request.map, error);
  if (error || bytes > kLargestMap_bytes) return;
  map::Map map = map::read_map(run.request.map, {run.request.seed, profile_of(run.request.profile)});
  if (map.image && map.image->png().size() > kLargestPicture_bytes) return;
  header_.map_text = read_file(run.request.map);
  map_ = std::move(map);
}

void Gatherer::add(const wire::Event& event) {
  // Ignores robots that are not in the request.
  const auto is_known = [&](int agent) { return static_cast<std::size_t>(agent) < streams_.size(); };
  if (const auto* columns = std::get_if<wire::Columns>(&event)) {
    if (is_known(columns->agent)) add_columns(*columns);
  } else if (const auto* serial = std::get_if<wire::SerialText>(&event)) {
    if (is_known(serial->agent)) add_serial(*serial);
  } else if (const auto* note = std::get_if<wire::Note>(&event)) {
    if (is_known(note->agent)) header_.notes.push_back(*note);
  } else if (const auto* started = std::get_if<wire::Started>(&event)) {
    if (is_known(started->agent)) record_of(static_cast<std::size_t>(started->agent)).started = *started;
    if (map_ && started->agent == 0) header_.floor = floor_shapes(*map_, *started);
  }
}

void Gatherer::add_columns(const wire::Columns& columns) {
  const auto robot = static_cast<std::size_t>(columns.agent);
  Streams& own = streams_[robot];
  auto& sources = record_of(robot).sources;
  sources.insert(sources.end(), columns.sources.begin(), columns.sources.end());
  for (const wire::Rows& rows : columns.streams) {
    CompressedStream& stream = own.columns.try_emplace(rows.stream, packer_.get()).first->second;
    stream.add(rows);
    if (rows.stream == kSamples)
      watch_line(robot, stream.specs(), rows);
    else if (own.thinned)
      stream.thin(kThinned_ns);
  }
  if (own.thinned) return;
  std::size_t bytes = 0;
  for (const auto& [name, stream] : own.columns)
    if (name != kSamples) bytes += stream.bytes();
  const std::size_t most_bytes = most_changes_bytes_ / streams_.size();
  if (bytes <= most_bytes / 2) return;
  own.thinned = bytes > most_bytes;
  for (auto& [name, stream] : own.columns)
    if (name != kSamples) own.thinned ? stream.thin(kThinned_ns) : stream.prepare_to_thin(kThinned_ns);
}

Gatherer::LineColumns Gatherer::line_columns(std::size_t robot,
                                             const std::vector<wire::ColumnSpec>& columns) {
  std::vector<std::string> sensors;
  std::vector<std::size_t> numbers = {0};
  std::vector<wire::ColumnReader> readers = {wire::ColumnReader(columns[0].order)};
  for (const auto& sensor : record_of(robot).robot_info.sensors) {
    const auto found = std::find_if(columns.begin(), columns.end(),
                                    [&](const auto& column) { return column.name == sensor.name; });
    if (found == columns.end()) continue;
    sensors.push_back(sensor.name);
    numbers.push_back(static_cast<std::size_t>(found - columns.begin()));
    readers.emplace_back(found->order);
  }
  const bool light_line = header_.floor && header_.floor->light_line;
  return {LineWatch(std::move(sensors), light_line), std::move(numbers), std::move(readers)};
}

void Gatherer::watch_line(std::size_t robot, const std::vector<wire::ColumnSpec>& columns,
                          const wire::Rows& rows) {
  auto& line = streams_[robot].line;
  if (!line) line = line_columns(robot, columns);
  if (line->numbers.size() == 1) return;
  std::vector<std::vector<std::int64_t>> values;
  for (std::size_t i = 0; i < line->numbers.size(); ++i) {
    auto read = line->readers[i].read(rows.bytes[line->numbers[i]], static_cast<std::size_t>(rows.count));
    if (!read) throw wire::BadValue("bytes", "expected as many numbers as rows");
    values.push_back(std::move(*read));
  }
  std::vector<float> readings(values.size() - 1);
  for (std::size_t row = 0; row < values[0].size(); ++row) {
    for (std::size_t k = 0; k < readings.size(); ++k)
      readings[k] =
          static_cast<float>(static_cast<double>(values[k + 1][row]) / columns[line->numbers[k + 1]].scale);
    line->watch.add(values[0][row], readings);
  }
}

void Gatherer::add_serial(const wire::SerialText& serial) {
  Streams& own = streams_[static_cast<std::size_t>(serial.agent)];
  if (own.serial_cut || own.serial_text.size() + serial.text.size() > kMostSerial_bytes / streams_.size()) {
    if (!own.serial_cut)
      header_.notes.push_back({serial.t_ns, "the recording stores no more of the sketch's serial output",
                               std::nullopt, serial.agent});
    own.serial_cut = true;
    return;
  }
  const double row[] = {static_cast<double>(serial.t_ns), static_cast<double>(serial.text.size())};
  own.serial_rows.add(row);
  if (own.serial_rows.count() >= kManyRows) own.serial.add(own.serial_rows.take());
  own.serial_text.add(serial.text);
}

void Gatherer::finish(std::size_t robot, const result::RunResult& result,
                      std::vector<const CompressedBytes*>& body) {
  RobotRecord& record = record_of(robot);
  Streams& own = streams_[robot];
  record.result = result;
  record.result.serial.clear();  // the stream contains the text, with times
  record.result.others.clear();  // each robot has its own record
  if (own.line) record.line = own.line->watch.events();
  record.thinned_ns = own.thinned ? kThinned_ns : 0;
  for (auto& [name, stream] : own.columns) record.streams.push_back(stream.finish(name, body));
  if (own.serial_text.size() == 0) return;
  if (own.serial_rows.count() > 0) own.serial.add(own.serial_rows.take());
  StreamInfo& info = record.streams.emplace_back(own.serial.finish("serial", body));
  info.columns.push_back({"text", 1.0, 0, static_cast<std::int64_t>(own.serial_text.size())});
  body.push_back(&own.serial_text);
}

std::string Gatherer::finish(const result::RunResult& result, std::vector<const CompressedBytes*>& body) {
  finish(0, result, body);
  for (std::size_t i = 1; i < streams_.size(); ++i)
    finish(i, i <= result.others.size() ? result.others[i - 1] : result::RunResult{}, body);
  return wire::text_of(wire::to_json(header_)) + "\n";
}

std::string Gatherer::content(const result::RunResult& result) {
  std::vector<const CompressedBytes*> body;
  std::string content = finish(result, body);
  for (const CompressedBytes* bytes : body) content += bytes->all();
  return content;
}

}  // namespace robosim::record
