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

int SourceNumbers::of(const SourceLine& line) {
  if (line.file.empty()) return 0;
  const auto [known, fresh] =
      numbers_.try_emplace({line.file, line.line, line.function}, static_cast<int>(numbers_.size()) + 1);
  if (fresh) new_.push_back(line);
  return known->second;
}

std::vector<SourceLine> SourceNumbers::take_new() { return std::exchange(new_, {}); }

RunColumns::RunColumns(const std::vector<std::string>& pins, bool sources) : has_sources_(sources) {
  for (const std::string& pin : pins) add_board_pin(pin);
}

std::size_t RunColumns::add_board_pin(const std::string& name) {
  pins_.push_back({Stream("pin " + name, pin_columns(has_sources_))});
  volts_.push_back({Stream("volts " + name, volts_columns())});
  return pins_.size() - 1;
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
  const double with_source[] = {row[0], row[1], row[2], row[3],
                                source ? static_cast<double>(sources_.of(*source)) : 0.0};
  changes.stream.add(with_source);
  changes.last = row;
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
  columns.sources = sources_.take_new();
  for (Stream& stream : samples_)
    if (stream.count() > 0) columns.streams.push_back(stream.take());
  for (auto* all : {&pins_, &volts_})
    for (Changes& changes : *all)
      if (changes.stream.count() > 0) columns.streams.push_back(changes.stream.take());
  return columns;
}

}  // namespace robosim::wire
