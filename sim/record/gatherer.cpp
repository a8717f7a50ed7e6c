#include <filesystem>
#include <system_error>

#include "hal/board/board_spec.h"
#include "sim/base/file.h"
#include "sim/record/compressed.h"
#include "sim/record/pin_level.h"
#include "sim/record/recording.h"
#include "sim/wire/json_writer.h"

namespace robosim::record {
namespace {

// A larger map is neither drawn nor kept.
constexpr std::uintmax_t kLargestMap_bytes = 1'000'000;

const std::vector<ColumnSpec> kPinColumns{{"t_ns"}, {"level"}, {"duty", 10'000}, {"tone_hz"}};
const std::vector<ColumnSpec> kVoltsColumns{{"t_ns"}, {"volts", 1000}};
const std::vector<ColumnSpec> kSerialColumns{{"t_ns"}, {"bytes"}};

std::vector<ColumnSpec> sample_columns(const std::vector<std::string>& readings) {
  std::vector<ColumnSpec> columns{{"t_us", 1, 2},          {"x_mm", 100, 2},   {"y_mm", 100, 2},
                                  {"yaw_rad", 10'000, 2},  {"speed_mm_s", 10}, {"cross_track_mm", 100},
                                  {"left", 1000},          {"right", 1000},    {"wheel_left_mm_s", 10},
                                  {"wheel_right_mm_s", 10}};
  for (const std::string& reading : readings) columns.push_back({reading, 1000});
  return columns;
}

}  // namespace

Stream::Stream(std::string name, std::vector<ColumnSpec> columns) : name_(std::move(name)) {
  for (ColumnSpec& column : columns) columns_.emplace_back(std::move(column));
}

void Stream::add(const std::vector<double>& row) {
  for (std::size_t i = 0; i < columns_.size(); ++i) columns_[i].add(i < row.size() ? row[i] : 0.0);
  ++count_;
}

std::size_t Stream::bytes() const {
  std::size_t bytes = 0;
  for (const Column& column : columns_) bytes += column.bytes().size();
  return bytes;
}

StreamInfo Stream::write(std::string& body) const {
  StreamInfo info{name_, count_, {}};
  for (const Column& column : columns_) {
    const ColumnSpec& spec = column.spec();
    info.columns.push_back(
        {spec.name, spec.scale, spec.order, static_cast<std::int64_t>(column.bytes().size())});
    body += column.bytes();
  }
  return info;
}

void Changes::add(const std::vector<double>& row) {
  const auto span = [](double t_ns) { return static_cast<std::int64_t>(t_ns) / Gatherer::kThinned_ns; };
  if (!last_.empty()) {
    if (std::equal(row.begin() + 1, row.end(), last_.begin() + 1, last_.end())) return;
    if (span(row[0]) != span(last_[0])) flush();
  }
  if (!thinned_) all_.add(row);
  last_ = row;
  pending_ = true;
}

void Changes::flush() {
  if (pending_) few_.add(last_);
  pending_ = false;
}

StreamInfo Changes::write(std::string& body) {
  flush();
  return (thinned_ ? few_ : all_).write(body);
}

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
  header_.map_text = read_file(run.request.map);
  map_ = grid::parse_map(header_.map_text, run.map);
}

void Gatherer::add(const wire::Event& event) {
  if (const auto* sample = std::get_if<wire::Sample>(&event)) {
    add_sample(*sample);
  } else if (const auto* volts = std::get_if<wire::VoltsSeen>(&event)) {
    add_change("volts " + volts->pin, kVoltsColumns, {static_cast<double>(volts->t_ns), volts->volts});
  } else if (const auto* pin = std::get_if<wire::PinChange>(&event)) {
    add_change("pin " + pin->pin, kPinColumns,
               {static_cast<double>(pin->t_ns), static_cast<double>(level_of(*pin)), pin->duty,
                static_cast<double>(pin->tone_hz)});
  } else if (const auto* level = std::get_if<wire::LevelSeen>(&event)) {
    const double high = level->level ? 1.0 : 0.0;
    add_change("pin " + level->pin, kPinColumns, {static_cast<double>(level->t_ns), high, high, 0.0});
  } else if (const auto* serial = std::get_if<wire::SerialText>(&event)) {
    add_serial(*serial);
  } else if (const auto* note = std::get_if<wire::Note>(&event)) {
    header_.notes.push_back(*note);
  } else if (const auto* started = std::get_if<wire::Started>(&event)) {
    header_.started = *started;
    if (map_) header_.floor = floor_shapes(*map_, *started);
    samples_.emplace("samples", sample_columns(started->readings));
  }
}

void Gatherer::add_sample(const wire::Sample& s) {
  if (!samples_) return;
  row_.assign({static_cast<double>(s.t_us), s.x_mm, s.y_mm, s.yaw_rad, s.speed_mm_s, s.cross_track_mm, s.left,
               s.right, s.wheels_mm_s[0], s.wheels_mm_s[1]});
  row_.insert(row_.end(), s.readings.begin(), s.readings.end());
  samples_->add(row_);
}

void Gatherer::add_change(const std::string& stream, const std::vector<ColumnSpec>& columns,
                          const std::vector<double>& row) {
  Changes& changes = changes_.try_emplace(stream, stream, columns).first->second;
  const std::size_t before = changes.bytes();
  if (thinned_) changes.thin();
  changes.add(row);
  changes_bytes_ += changes.bytes() - before;
  if (thinned_ || changes_bytes_ <= most_changes_bytes_) return;
  thinned_ = true;
  for (auto& [name, each] : changes_) each.thin();
}

void Gatherer::add_serial(const wire::SerialText& serial) {
  if (!serial_) serial_.emplace("serial", kSerialColumns);
  if (serial_cut_ || serial_text_.size() + serial.text.size() > kMostSerial_bytes) {
    if (!serial_cut_)
      header_.notes.push_back(
          {serial.t_ns, "the recording keeps no more of what the sketch sends", std::nullopt, 0});
    serial_cut_ = true;
    return;
  }
  serial_->add({static_cast<double>(serial.t_ns), static_cast<double>(serial.text.size())});
  serial_text_ += serial.text;
}

std::string Gatherer::encoded(const wire::RunResult& result) {
  header_.result = result;
  header_.result.serial.clear();  // it is in the stream, with its times
  header_.thinned_ns = thinned_ ? kThinned_ns : 0;
  std::string body;
  if (samples_) header_.streams.push_back(samples_->write(body));
  for (auto& [name, changes] : changes_) header_.streams.push_back(changes.write(body));
  if (serial_) {
    StreamInfo info = serial_->write(body);
    info.columns.push_back({"text", 1.0, 0, static_cast<std::int64_t>(serial_text_.size())});
    body += serial_text_;
    header_.streams.push_back(std::move(info));
  }
  const std::string head = wire::text_of(wire::to_json(header_)) + "\n";
  return kRecordingMagic + deflated(head + body);
}

}  // namespace robosim::record
