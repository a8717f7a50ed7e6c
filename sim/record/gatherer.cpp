#include <filesystem>
#include <system_error>
#include <utility>

#include "hal/board/board_spec.h"
#include "sim/base/file.h"
#include "sim/grid/floor_image.h"
#include "sim/record/recording.h"
#include "sim/wire/json_writer.h"

namespace robosim::record {
namespace {

// A larger map is neither drawn nor kept.
constexpr std::uintmax_t kLargestMap_bytes = 1'000'000;

constexpr const char* kSamples = "samples";

}  // namespace

void Gatherer::begin(const RecordedRun& run) {
  header_.robosim = run.robosim;
  header_.sketch = run.sketch;
  header_.map = run.map;
  header_.robot = run.robot;
  header_.target = run.target;
  header_.script = run.request.script;
  header_.robot_info = run.robot_info;
  header_.robot_info.file = std::filesystem::path(run.robot_info.file).filename();
  if (const BoardSpec* board = find_board(run.robot_info.board.name.c_str()))
    for (Pin pin = 0; pin < board->pin_count; ++pin) header_.pins.push_back(board->pins[pin].name);
  std::error_code error;
  const auto bytes = std::filesystem::file_size(run.request.map, error);
  if (error || bytes > kLargestMap_bytes) return;
  grid::Map map = grid::read_map(run.request.map);
  if (map.image && map.image->png().size() > kLargestPicture_bytes) return;
  header_.map_text = read_file(run.request.map);
  map_ = std::move(map);
}

void Gatherer::add(const wire::Event& event) {
  if (const auto* columns = std::get_if<wire::Columns>(&event)) {
    add_columns(*columns);
  } else if (const auto* serial = std::get_if<wire::SerialText>(&event)) {
    add_serial(*serial);
  } else if (const auto* note = std::get_if<wire::Note>(&event)) {
    header_.notes.push_back(*note);
  } else if (const auto* started = std::get_if<wire::Started>(&event)) {
    header_.started = *started;
    if (map_) header_.floor = floor_shapes(*map_, *started);
  }
}

void Gatherer::add_columns(const wire::Columns& columns) {
  header_.sources.insert(header_.sources.end(), columns.sources.begin(), columns.sources.end());
  for (const wire::Rows& rows : columns.streams) {
    KeptStream& stream = streams_[rows.stream];
    stream.add(rows);
    if (thinned_ && rows.stream != kSamples) stream.thin(kThinned_ns);
  }
  if (thinned_) return;
  std::size_t bytes = 0;
  for (const auto& [name, stream] : streams_)
    if (name != kSamples) bytes += stream.bytes();
  if (bytes <= most_changes_bytes_) return;
  thinned_ = true;
  for (auto& [name, stream] : streams_)
    if (name != kSamples) stream.thin(kThinned_ns);
}

void Gatherer::add_serial(const wire::SerialText& serial) {
  if (!serial_) serial_.emplace("serial", std::vector<wire::ColumnSpec>{{"t_ns"}, {"bytes"}});
  if (serial_cut_ || serial_text_.size() + serial.text.size() > kMostSerial_bytes) {
    if (!serial_cut_)
      header_.notes.push_back(
          {serial.t_ns, "the recording keeps no more of what the sketch sends", std::nullopt, 0});
    serial_cut_ = true;
    return;
  }
  const double row[] = {static_cast<double>(serial.t_ns), static_cast<double>(serial.text.size())};
  serial_->add(row);
  serial_text_ += serial.text;
}

std::vector<LineEvent> Gatherer::line_events() const {
  const auto samples = streams_.find(kSamples);
  if (samples == streams_.end()) return {};
  std::vector<SensorReadings> sensors;
  for (const auto& sensor : header_.robot_info.sensors)
    if (auto values = samples->second.column(sensor.name); !values.empty())
      sensors.push_back({sensor.name, std::move(values)});
  return record::line_events(samples->second.column("t_us"), std::move(sensors),
                             header_.floor && header_.floor->light_line);
}

std::string Gatherer::content(const wire::RunResult& result) {
  header_.result = result;
  header_.result.serial.clear();  // it is in the stream, with its times
  header_.line = line_events();
  header_.thinned_ns = thinned_ ? kThinned_ns : 0;
  std::string body;
  for (auto& [name, stream] : streams_) header_.streams.push_back(stream.write(name, body));
  if (serial_) {
    StreamInfo& info = header_.streams.emplace_back(StreamInfo{"serial", serial_->count(), {}});
    for (const wire::Column& column : serial_->columns()) {
      info.columns.push_back({column.spec().name, 1.0, 1, static_cast<std::int64_t>(column.bytes().size())});
      body += column.bytes();
    }
    info.columns.push_back({"text", 1.0, 0, static_cast<std::int64_t>(serial_text_.size())});
    body += serial_text_;
  }
  return wire::text_of(wire::to_json(header_)) + "\n" + body;
}

}  // namespace robosim::record
