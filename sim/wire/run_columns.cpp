#include "sim/wire/run_columns.h"

#include <algorithm>

#include "sim/wire/stream.h"

namespace robosim::wire {

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

const std::vector<ColumnSpec>& pin_columns() {
  static const std::vector<ColumnSpec> columns{{"t_ns", 1, 2}, {"level"}, {"duty", 10'000}, {"tone_hz"}};
  return columns;
}

const std::vector<ColumnSpec>& volts_columns() {
  static const std::vector<ColumnSpec> columns{{"t_ns", 1, 2}, {"volts", 1000}};
  return columns;
}

RunColumns::RunColumns(std::vector<std::string> pins) {
  for (const std::string& pin : pins) {
    pins_.push_back({Stream("pin " + pin, pin_columns())});
    volts_.push_back({Stream("volts " + pin, volts_columns())});
  }
}

void RunColumns::begin(const std::vector<std::string>& readings) {
  samples_.assign(1, Stream("samples", sample_columns(readings)));
}

void RunColumns::add(const Sample& s) {
  if (samples_.empty()) return;
  row_.assign({static_cast<double>(s.t_us), s.x_mm, s.y_mm, s.yaw_rad, s.speed_mm_s, s.cross_track_mm, s.left,
               s.right, s.wheels_mm_s[0], s.wheels_mm_s[1]});
  row_.insert(row_.end(), s.readings.begin(), s.readings.end());
  row_.resize(samples_[0].columns().size());
  samples_[0].add(row_.data());
}

void RunColumns::change(Changes& changes, const std::array<double, 4>& row) {
  if (changes.last[0] >= 0.0 && std::equal(row.begin() + 1, row.end(), changes.last.begin() + 1)) return;
  changes.stream.add(row.data());
  changes.last = row;
}

void RunColumns::add_pin(std::size_t pin, std::int64_t t_ns, PinLevel level, double duty,
                         std::uint32_t tone_hz) {
  change(pins_.at(pin),
         {static_cast<double>(t_ns), static_cast<double>(level), duty, static_cast<double>(tone_hz)});
}

void RunColumns::add_volts(std::size_t pin, std::int64_t t_ns, double volts) {
  change(volts_.at(pin), {static_cast<double>(t_ns), volts, 0.0, 0.0});
}

Columns RunColumns::take() {
  Columns columns;
  for (Stream& stream : samples_)
    if (stream.count() > 0) columns.streams.push_back(stream.take());
  for (auto* all : {&pins_, &volts_})
    for (Changes& changes : *all)
      if (changes.stream.count() > 0) columns.streams.push_back(changes.stream.take());
  return columns;
}

}  // namespace robosim::wire
