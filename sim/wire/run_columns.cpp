#include "sim/wire/run_columns.h"

#include <algorithm>
#include <utility>

#include "sim/wire/stream.h"

namespace robosim::wire {

namespace {

constexpr const char* kSamples = "samples";

}  // namespace

PinLevel pin_level(const PinChange& pin) {
  return pin_level(pin.mode == "output", pin.mode == "input_pullup", pin.pwm, pin.duty, pin.tone_hz);
}

std::vector<ColumnSpec> sample_columns(const std::vector<std::string>& readings) {
  std::vector<ColumnSpec> columns{{"t_us", 1, 2},          {"x_mm", 100, 2},   {"y_mm", 100, 2},
                                  {"yaw_rad", 10'000, 2},  {"speed_mm_s", 10}, {"cross_track_mm", 100},
                                  {"left", 1000},          {"right", 1000},    {"wheel_left_mm_s", 10},
                                  {"wheel_right_mm_s", 10}};
  for (const std::string& reading : readings) columns.push_back({reading, 1000});
  return columns;
}

std::vector<ColumnSpec> pin_columns(bool sources) {
  std::vector<ColumnSpec> columns{{"t_ns", 1, 2}, {"level"}, {"duty", 10'000}, {"tone_hz"}};
  if (sources) columns.push_back({"source"});
  return columns;
}

const std::vector<ColumnSpec>& volts_columns() {
  static const std::vector<ColumnSpec> columns{{"t_ns", 1, 2}, {"volts", 1000}};
  return columns;
}

std::vector<Sample> PoseReader::take(const Columns& columns) {
  constexpr std::size_t kPose = 4;
  std::vector<Sample> samples;
  for (const Rows& rows : columns.streams) {
    if (rows.stream != kSamples) continue;
    for (std::size_t i = specs_.size(); i < std::min(kPose, rows.columns.size()); ++i) {
      specs_.push_back(rows.columns[i]);
      readers_.emplace_back(rows.columns[i].order);
    }
    const auto count = static_cast<std::size_t>(rows.count);
    std::vector<std::vector<std::int64_t>> values;
    for (std::size_t i = 0; i < std::min(readers_.size(), rows.bytes.size()); ++i)
      if (auto column = readers_[i].read(rows.bytes[i], count)) values.push_back(std::move(*column));
    if (values.size() != kPose) return {};  // the recorder says what is wrong with them
    const auto at = [&](std::size_t column, std::size_t row) {
      return static_cast<double>(values[column][row]) / specs_[column].scale;
    };
    for (std::size_t row = 0; row < count; ++row) {
      Sample& sample = samples.emplace_back();
      sample.t_us = values[0][row];
      sample.x_mm = at(1, row);
      sample.y_mm = at(2, row);
      sample.yaw_rad = at(3, row);
    }
  }
  return samples;
}

RunColumns::RunColumns(const std::vector<std::string>& pins, bool sources) {
  for (const std::string& pin : pins) {
    pins_.push_back({Stream("pin " + pin, pin_columns(sources))});
    volts_.push_back({Stream("volts " + pin, volts_columns())});
  }
}

void RunColumns::begin(const std::vector<std::string>& readings) {
  samples_.assign(1, Stream(kSamples, sample_columns(readings)));
}

void RunColumns::add(const Sample& s) {
  if (samples_.empty()) return;
  const std::array<double, 10> first = {static_cast<double>(s.t_us),
                                        s.x_mm,
                                        s.y_mm,
                                        s.yaw_rad,
                                        s.speed_mm_s,
                                        s.cross_track_mm,
                                        s.left,
                                        s.right,
                                        s.wheels_mm_s[0],
                                        s.wheels_mm_s[1]};
  const std::size_t known = std::min(s.readings.size(), samples_[0].width() - first.size());
  double* row = samples_[0].add();
  double* const end = row + samples_[0].width();
  row = std::copy(first.begin(), first.end(), row);
  row = std::copy_n(s.readings.begin(), known, row);
  std::fill(row, end, 0.0);
}

void RunColumns::change(Changes& changes, const std::array<double, 4>& row, const SourceLine* source) {
  if (changes.last[0] >= 0.0 && std::equal(row.begin() + 1, row.end(), changes.last.begin() + 1)) return;
  const double with_source[] = {row[0], row[1], row[2], row[3], static_cast<double>(number_of(source))};
  changes.stream.add(with_source);
  changes.last = row;
}

int RunColumns::number_of(const SourceLine* source) {
  if (!source || source->file.empty()) return 0;
  const auto [known, fresh] = sources_.try_emplace({source->file, source->line, source->function},
                                                   static_cast<int>(sources_.size()) + 1);
  if (fresh) new_sources_.push_back(*source);
  return known->second;
}

void RunColumns::add_pin(std::size_t pin, std::int64_t t_ns, PinLevel level, double duty,
                         std::uint32_t tone_hz, const SourceLine* source) {
  change(pins_.at(pin),
         {static_cast<double>(t_ns), static_cast<double>(level), duty, static_cast<double>(tone_hz)}, source);
}

void RunColumns::add_volts(std::size_t pin, std::int64_t t_ns, double volts) {
  Changes& changes = volts_.at(pin);
  if (changes.last[0] >= 0.0 && changes.last[1] == volts) return;
  double* row = changes.stream.add();
  row[0] = static_cast<double>(t_ns);
  row[1] = volts;
  changes.last = {row[0], volts};
}

Columns RunColumns::take() {
  Columns columns;
  columns.sources = std::exchange(new_sources_, {});
  for (Stream& stream : samples_)
    if (stream.count() > 0) columns.streams.push_back(stream.take());
  for (auto* all : {&pins_, &volts_})
    for (Changes& changes : *all)
      if (changes.stream.count() > 0) columns.streams.push_back(changes.stream.take());
  return columns;
}

}  // namespace robosim::wire
