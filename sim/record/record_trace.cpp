#include "sim/record/record_trace.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/record/number_text.h"
#include "sim/wire/json_reader.h"
#include "sim/wire/json_writer.h"
#include "sim/wire/run_columns.h"

namespace robosim::record {
namespace {

// Viewers call groups and rows "processes" and "threads". Each robot has one group for itself and one for its
// pins.
constexpr int group_of(std::size_t robot) { return static_cast<int>(2 * robot) + 1; }
constexpr int pins_of(std::size_t robot) { return group_of(robot) + 1; }
constexpr int kHappened = 1, kSerial = 2;  // rows of a robot's group
constexpr int kWholeGroup = 0;             // used instead of a row, to name the group
constexpr std::string_view kNext = ",\n";
constexpr int kDecimalsOfMicroseconds = 3;

std::string quoted_name(const std::string& text) { return wire::text_of(wire::OrderedJson(text)); }

/// Converts the unit in a column's name: "speed_mm_s" becomes "speed, mm/s".
std::string with_unit(const std::string& column) {
  struct Unit {
    const char *ending, *unit;
  };
  for (const auto& [ending, unit] : {Unit{"_mm_s", "mm/s"}, Unit{"_mm", "mm"}, Unit{"_rad", "rad"}}) {
    if (!column.ends_with(ending)) continue;
    std::string name = column.substr(0, column.size() - std::string_view(ending).size());
    std::replace(name.begin(), name.end(), '_', ' ');
    return name + ", " + unit;
  }
  return column;
}

/// Returns the number of decimals for integers with this `scale`; -1 if it is not a power of ten.
int decimals_of(double scale) {
  int decimals = 0;
  for (double power = 1.0; power <= 1e6; power *= 10.0, ++decimals)
    if (scale == power) return decimals;
  return -1;
}

std::string pulses(double duty, double tone_hz) {
  return tone_hz > 0.0 ? fmt::format("{} Hz", tone_hz) : fmt::format("PWM {:.0f} %", 100.0 * duty);
}

/// Multiplies with wraparound, because damaged recordings may contain any values. Signed overflow would be
/// undefined behaviour.
std::int64_t product(std::int64_t a, std::int64_t b) {
  return static_cast<std::int64_t>(static_cast<std::uint64_t>(a) * static_cast<std::uint64_t>(b));
}
std::int64_t difference(std::int64_t a, std::int64_t b) {
  return static_cast<std::int64_t>(static_cast<std::uint64_t>(a) - static_cast<std::uint64_t>(b));
}

std::int64_t end_ns(const result::RunResult& result) { return std::llround(result.time_s * 1e9); }

}  // namespace

TraceFile::TraceFile(const std::filesystem::path& path, const std::string& map, std::uint64_t seed,
                     const std::vector<Robot>& robots)
    : file_(path), robots_(robots.size()) {
  file_.add("{\"displayTimeUnit\":\"ms\",\"traceEvents\":[\n");
  for (std::size_t i = 0; i < robots.size(); ++i) {
    const Robot& robot = robots[i];
    if (i > 0) put(kNext);
    const std::string whose = robot.name.empty() ? "" : robot.name + ": ";
    put(fmt::format(
        R"({{"ph":"M","pid":{},"name":"process_name","args":{{"name":{}}}}})", group_of(i),
        quoted_name(fmt::format("{}{} · {} on {}, seed {}", whose, robot.sketch, robot.robot, map, seed))));
    name(group_of(i), kHappened, "events");
    name(group_of(i), kSerial, "serial");
    name(pins_of(i), kWholeGroup, whose + "pins of the " + robot.board);
  }
}

void TraceFile::put(std::string_view text) { file_.add(text); }

void TraceFile::put(std::string_view head, std::int64_t t_ns) {
  char* to = file_.room(head.size() + kLongestNumber);
  to = std::copy(head.begin(), head.end(), to);
  file_.added(put_decimal(to, t_ns, kDecimalsOfMicroseconds));
}

void TraceFile::name(int group, int row, const std::string& name) {
  const std::string which = row == kWholeGroup ? "" : fmt::format(R"("tid":{},)", row);
  put(kNext);
  put(fmt::format(R"({{"ph":"M","pid":{},{}"name":"{}","args":{{"name":{}}}}})", group, which,
                  row == kWholeGroup ? "process_name" : "thread_name", quoted_name(name)));
}

void TraceFile::add(std::size_t robot, const std::string& stream, const std::vector<wire::ColumnSpec>& specs,
                    const std::vector<std::vector<std::int64_t>>& columns) {
  if (robot >= robots_.size()) return;  // the request contains no such robot
  if (stream == "samples" || (stream.starts_with("volts ") && columns.size() == 2))
    add_counters(robot, stream, specs, columns);
  else if (stream.starts_with("pin ") && columns.size() >= 4)
    add_pin(robot, stream, specs, columns);
}

void TraceFile::add_counters(std::size_t robot, const std::string& stream,
                             const std::vector<wire::ColumnSpec>& specs,
                             const std::vector<std::vector<std::int64_t>>& columns) {
  std::vector<Counter>& counters = robots_[robot].counters[stream];
  const bool is_sample = stream == "samples";
  if (counters.empty()) {
    for (const wire::ColumnSpec& spec : specs)
      counters.push_back(
          {fmt::format(R"({}{{"ph":"C","pid":{},"name":{},"ts":)", kNext, group_of(robot),
                       quoted_name(is_sample ? with_unit(spec.name) : stream.substr(6) + ", V")),
           spec.scale, decimals_of(spec.scale)});
  }
  const std::int64_t ns = is_sample ? 1000 : 1;
  for (std::size_t row = 0; row < columns[0].size(); ++row)
    for (std::size_t i = 1; i < columns.size(); ++i)
      count(counters[i], product(columns[0][row], ns), columns[i][row]);
}

/// Writes a value, unless it equals the previous one.
void TraceFile::count(Counter& counter, std::int64_t t_ns, std::int64_t steps) {
  if (counter.is_told && steps == counter.last) return;
  counter.is_told = true;
  counter.last = steps;
  constexpr std::string_view kArguments = R"(,"args":{"value":)", kEnd = "}}";
  char* to = file_.room(counter.head.size() + 2 * kLongestNumber + kArguments.size() + kEnd.size());
  to = std::copy(counter.head.begin(), counter.head.end(), to);
  to = put_decimal(to, t_ns, kDecimalsOfMicroseconds);
  to = std::copy(kArguments.begin(), kArguments.end(), to);
  to = counter.decimals >= 0 ? put_decimal(to, steps, counter.decimals)
                             : put_number(to, static_cast<double>(steps) / counter.scale);
  file_.added(std::copy(kEnd.begin(), kEnd.end(), to));
}

/// Draws the states of a pin: a high or pulsing pin as a bar, any other state as a gap.
void TraceFile::add_pin(std::size_t robot, const std::string& stream,
                        const std::vector<wire::ColumnSpec>& specs,
                        const std::vector<std::vector<std::int64_t>>& columns) {
  auto& pins = robots_[robot].pins;
  Pin& pin = pins[stream];
  if (pin.head.empty()) {
    const int row = static_cast<int>(pins.size());
    name(pins_of(robot), row, stream.substr(4));
    pin.head = fmt::format(R"({}{{"ph":"X","pid":{},"tid":{},"ts":)", kNext, pins_of(robot), row);
  }
  for (std::size_t row = 0; row < columns[0].size(); ++row) {
    end_bar(pin, columns[0][row]);
    pin.from_ns = columns[0][row];
    const auto level = static_cast<wire::PinLevel>(columns[1][row]);
    if (level == wire::PinLevel::high) pin.text = R"(,"name":"high"})";
    if (level == wire::PinLevel::pulsing)
      pin.text =
          fmt::format(R"(,"name":"{}"}})", pulses(static_cast<double>(columns[2][row]) / specs[2].scale,
                                                  static_cast<double>(columns[3][row]) / specs[3].scale));
  }
}

void TraceFile::end_bar(Pin& pin, std::int64_t t_ns) {
  if (pin.text.empty()) return;
  put(pin.head, pin.from_ns);
  put(R"(,"dur":)", difference(t_ns, pin.from_ns));
  put(pin.text);
  pin.text.clear();
}

void TraceFile::moment(std::size_t robot, int row, std::int64_t t_ns, const std::string& text) {
  put(fmt::format(R"({}{{"ph":"i","s":"t","pid":{},"tid":{},"ts":)", kNext, group_of(robot), row), t_ns);
  put(fmt::format(R"(,"name":{}}})", quoted_name(text)));
}

void TraceFile::add(const wire::Event& event) {
  const auto is_known = [&](int agent) { return static_cast<std::size_t>(agent) < robots_.size(); };
  if (const auto* note = std::get_if<wire::Note>(&event); note && is_known(note->agent))
    moment(static_cast<std::size_t>(note->agent), kHappened, note->t_ns, note->text);
  if (const auto* serial = std::get_if<wire::SerialText>(&event); serial && is_known(serial->agent))
    moment(static_cast<std::size_t>(serial->agent), kSerial, serial->t_ns,
           serial->text.substr(0, serial->text.find_last_not_of("\r\n") + 1));
}

void TraceFile::finish(std::size_t robot, const result::RunResult& result) {
  for (auto& [stream, pin] : robots_[robot].pins) end_bar(pin, std::max(end_ns(result), pin.from_ns));
  moment(robot, kHappened, end_ns(result), result.verdict + ": " + result.why);
}

void TraceFile::finish(const result::RunResult& result) {
  finish(0, result);
  for (std::size_t i = 1; i < robots_.size() && i <= result.others.size(); ++i)
    finish(i, result.others[i - 1]);
  put("\n]}\n");
  file_.finish();
}

void TraceRecorder::ask(wire::RunRequest& request) const {
  request.columns_every_ns = kRecordEvery_ns;
  request.serial = request.notes = true;
}

void TraceRecorder::begin(const RecordedRun& run) {
  std::vector<TraceFile::Robot> robots;
  for (const RecordedRobot& robot : run.robots)
    robots.push_back({robot.name, robot.sketch, robot.robot, robot.info.board.name});
  if (robots.empty()) robots.push_back({"", run.sketch, run.robot, run.robot_info.board.name});
  streams_.resize(robots.size());
  trace_ = std::make_unique<TraceFile>(path_, run.map, run.request.seed, robots);
}

void TraceRecorder::add(const wire::Event& event) {
  trace_->add(event);
  const auto* columns = std::get_if<wire::Columns>(&event);
  if (!columns || static_cast<std::size_t>(columns->agent) >= streams_.size()) return;
  const auto robot = static_cast<std::size_t>(columns->agent);
  for (const wire::Rows& rows : columns->streams) {
    Stream& stream = streams_[robot][rows.stream];
    if (stream.specs.empty()) {
      stream.specs = rows.columns;
      for (const wire::ColumnSpec& spec : stream.specs) stream.readers.emplace_back(spec.order);
    }
    if (rows.bytes.size() != stream.readers.size() || rows.bytes.empty())
      throw wire::BadValue("bytes", "expected one text for each column of " + rows.stream);
    std::vector<std::vector<std::int64_t>> values;
    for (std::size_t i = 0; i < stream.readers.size(); ++i) {
      auto read = stream.readers[i].read(rows.bytes[i], static_cast<std::size_t>(rows.count));
      if (!read) throw wire::BadValue("bytes", "expected as many numbers as rows");
      values.push_back(std::move(*read));
    }
    trace_->add(robot, rows.stream, stream.specs, values);
  }
}

void TraceRecorder::finish(const result::RunResult& result) { trace_->finish(result); }

void write_trace(const Recording& recording, const std::filesystem::path& file) {
  const RecordingHeader& header = recording.header();
  std::vector<TraceFile::Robot> robots;
  result::RunResult result = header.result;
  for (std::size_t i = 0; i < header.robot_count(); ++i) {
    const RobotRecord& robot = header.of(i);
    robots.push_back({robot.name, robot.sketch, robot.robot, robot.robot_info.board.name});
    if (i > 0) result.others.push_back(robot.result);
  }
  TraceFile trace(file, header.map, result.seed, robots);
  for (std::size_t i = 0; i < robots.size(); ++i) {
    for (const StreamInfo& info : header.of(i).streams) {
      std::vector<wire::ColumnSpec> specs;
      for (const ColumnInfo& column : info.columns)
        if (column.order != 0) specs.push_back({column.name, column.scale, column.order});
      if (!specs.empty()) trace.add(i, info.name, specs, recording.steps(info.name, i));
    }
  }
  recording.play([&](const wire::Event& event) { trace.add(event); });
  trace.finish(result);
}

}  // namespace robosim::record
