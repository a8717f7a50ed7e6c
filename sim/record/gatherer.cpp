#include <filesystem>
#include <system_error>
#include <utility>

#include "hal/board/board_spec.h"
#include "sim/base/file.h"
#include "sim/base/profile.h"
#include "sim/grid/floor_image.h"
#include "sim/record/recording.h"
#include "sim/wire/json_writer.h"

namespace robosim::record {
namespace {

// A larger map is neither drawn nor kept.
constexpr std::uintmax_t kLargestMap_bytes = 1'000'000;

constexpr const char* kSamples = "samples";

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

std::vector<LineEvent> line_events_of(const RobotRecord& record, const KeptStream& samples, bool light_line) {
  std::vector<SensorReadings> sensors;
  for (const auto& sensor : record.robot_info.sensors)
    if (auto values = samples.column(sensor.name); !values.empty())
      sensors.push_back({sensor.name, std::move(values)});
  return line_events(samples.column("t_us"), std::move(sensors), light_line);
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
  streams_.resize(header_.robot_count());
  std::error_code error;
  const auto bytes = std::filesystem::file_size(run.request.map, error);
  if (error || bytes > kLargestMap_bytes) return;
  grid::Map map = grid::read_map(run.request.map, {run.request.seed, profile_of(run.request.profile)});
  if (map.image && map.image->png().size() > kLargestPicture_bytes) return;
  header_.map_text = read_file(run.request.map);
  map_ = std::move(map);
}

void Gatherer::add(const wire::Event& event) {
  // A robot that nobody has asked for is none.
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
    KeptStream& stream = own.columns[rows.stream];
    stream.add(rows);
    if (own.thinned && rows.stream != kSamples) stream.thin(kThinned_ns);
  }
  if (own.thinned) return;
  std::size_t bytes = 0;
  for (const auto& [name, stream] : own.columns)
    if (name != kSamples) bytes += stream.bytes();
  if (bytes <= most_changes_bytes_ / streams_.size()) return;
  own.thinned = true;
  for (auto& [name, stream] : own.columns)
    if (name != kSamples) stream.thin(kThinned_ns);
}

void Gatherer::add_serial(const wire::SerialText& serial) {
  Streams& own = streams_[static_cast<std::size_t>(serial.agent)];
  if (!own.serial) own.serial.emplace("serial", std::vector<wire::ColumnSpec>{{"t_ns"}, {"bytes"}});
  if (own.serial_cut || own.serial_text.size() + serial.text.size() > kMostSerial_bytes / streams_.size()) {
    if (!own.serial_cut)
      header_.notes.push_back(
          {serial.t_ns, "the recording keeps no more of what the sketch sends", std::nullopt, serial.agent});
    own.serial_cut = true;
    return;
  }
  const double row[] = {static_cast<double>(serial.t_ns), static_cast<double>(serial.text.size())};
  own.serial->add(row);
  own.serial_text += serial.text;
}

void Gatherer::finish(std::size_t robot, const wire::RunResult& result, std::string& body) {
  RobotRecord& record = record_of(robot);
  Streams& own = streams_[robot];
  record.result = result;
  record.result.serial.clear();  // it is in the stream, with its times
  record.result.others.clear();  // each has its own
  const auto samples = own.columns.find(kSamples);
  if (samples != own.columns.end())
    record.line = line_events_of(record, samples->second, header_.floor && header_.floor->light_line);
  record.thinned_ns = own.thinned ? kThinned_ns : 0;
  for (auto& [name, stream] : own.columns) record.streams.push_back(stream.write(name, body));
  if (!own.serial) return;
  StreamInfo& info = record.streams.emplace_back(StreamInfo{"serial", own.serial->count(), {}});
  for (const wire::Column& column : own.serial->columns()) {
    info.columns.push_back({column.spec().name, 1.0, 1, static_cast<std::int64_t>(column.bytes().size())});
    body += column.bytes();
  }
  info.columns.push_back({"text", 1.0, 0, static_cast<std::int64_t>(own.serial_text.size())});
  body += own.serial_text;
}

std::string Gatherer::content(const wire::RunResult& result) {
  std::string body;
  finish(0, result, body);
  for (std::size_t i = 1; i < streams_.size(); ++i)
    finish(i, i <= result.others.size() ? result.others[i - 1] : wire::RunResult{}, body);
  return wire::text_of(wire::to_json(header_)) + "\n" + body;
}

}  // namespace robosim::record
