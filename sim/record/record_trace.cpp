#include "sim/record/record_trace.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <iterator>

#include "sim/wire/json_writer.h"
#include "sim/wire/run_columns.h"

namespace robosim::record {
namespace {

// "Processes" and "threads" are what the viewers call groups and rows. Each robot has a group, and its pins
// have one.
constexpr int group_of(std::size_t robot) { return static_cast<int>(2 * robot) + 1; }
constexpr int pins_of(std::size_t robot) { return group_of(robot) + 1; }
constexpr int kHappened = 1, kSerial = 2;  // rows of a robot's group

class Trace {
 public:
  void name_group(int group, const std::string& name) {
    put(R"({{"ph":"M","pid":{},"name":"process_name","args":{{"name":{}}}}})", group, quoted(name));
  }
  void name_row(int group, int row, const std::string& name) {
    put(R"({{"ph":"M","pid":{},"tid":{},"name":"thread_name","args":{{"name":{}}}}})", group, row,
        quoted(name));
  }
  void counter(int group, const std::string& quoted_name, double t_us, double value) {
    put(R"({{"ph":"C","pid":{},"name":{},"ts":{},"args":{{"value":{}}}}})", group, quoted_name, t_us, value);
  }
  void moment(int group, int row, double t_us, const std::string& text) {
    put(R"({{"ph":"i","s":"t","pid":{},"tid":{},"ts":{},"name":{}}})", group, row, t_us, quoted(text));
  }
  void span(int group, int row, double from_us, double to_us, const std::string& text) {
    put(R"({{"ph":"X","pid":{},"tid":{},"ts":{},"dur":{},"name":{}}})", group, row, from_us, to_us - from_us,
        quoted(text));
  }
  std::string text() { return "{\"displayTimeUnit\":\"ms\",\"traceEvents\":[\n" + text_ + "\n]}\n"; }

  static std::string quoted(const std::string& text) { return wire::text_of(wire::OrderedJson(text)); }

 private:
  template <class... Values>
  void put(fmt::format_string<Values...> format, Values&&... values) {
    if (!text_.empty()) text_ += ",\n";
    fmt::format_to(std::back_inserter(text_), format, std::forward<Values>(values)...);
  }

  std::string text_;
};

/// Of a column's name what stands before its unit: "speed_mm_s" is "speed, mm/s".
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

/// A sample that says what the one before said adds nothing to a counter.
void add_counter(Trace& trace, int group, const std::string& name, const std::vector<double>& times,
                 const std::vector<double>& values, double times_in_us) {
  const std::string quoted = Trace::quoted(name);
  for (std::size_t i = 0; i < times.size(); ++i)
    if (i == 0 || values[i] != values[i - 1]) trace.counter(group, quoted, times[i] * times_in_us, values[i]);
}

std::string pulses(double duty, double tone_hz) {
  return tone_hz > 0.0 ? fmt::format("{} Hz", tone_hz) : fmt::format("PWM {:.0f} %", 100.0 * duty);
}

/// High, and pulsing, as bars; low and not driven as nothing.
void add_pin(Trace& trace, int group, int row, const std::vector<std::vector<double>>& pin, double end_us) {
  for (std::size_t i = 0; i < pin[0].size(); ++i) {
    const auto level = static_cast<wire::PinLevel>(pin[1][i]);
    const double from_us = pin[0][i] / 1000.0;
    const double to_us = i + 1 < pin[0].size() ? pin[0][i + 1] / 1000.0 : std::max(end_us, from_us);
    if (level == wire::PinLevel::high) trace.span(group, row, from_us, to_us, "high");
    if (level == wire::PinLevel::pulsing)
      trace.span(group, row, from_us, to_us, pulses(pin[2][i], pin[3][i]));
  }
}

void add_robot(Trace& trace, const Recording& recording, std::size_t robot) {
  const RobotRecord& record = recording.header().of(robot);
  const int group = group_of(robot), pins = pins_of(robot);
  const std::string name = record.name.empty() ? "" : record.name + ": ";
  const double end_us = record.result.time_s * 1e6;
  trace.name_group(group, fmt::format("{}{} · {} on {}, seed {}", name, record.sketch, record.robot,
                                      recording.header().map, record.result.seed));
  trace.name_row(group, kHappened, "events");
  trace.name_row(group, kSerial, "serial");
  trace.name_group(pins, name + "pins of the " + record.robot_info.board.name);
  int row = 0;
  for (const StreamInfo& info : record.streams) {
    const auto stream = recording.stream(info.name, robot);
    if (info.name == "samples") {
      for (std::size_t i = 1; i < stream.size(); ++i)
        add_counter(trace, group, with_unit(info.columns[i].name), stream[0], stream[i], 1.0);
    } else if (info.name.starts_with("volts ") && stream.size() == 2) {
      add_counter(trace, group, info.name.substr(6) + ", V", stream[0], stream[1], 0.001);
    } else if (info.name.starts_with("pin ") && stream.size() >= 4) {
      trace.name_row(pins, ++row, info.name.substr(4));
      add_pin(trace, pins, row, stream, end_us);
    }
  }
}

}  // namespace

std::string trace_of(const Recording& recording) {
  const RecordingHeader& header = recording.header();
  Trace trace;
  for (std::size_t robot = 0; robot < header.robot_count(); ++robot) add_robot(trace, recording, robot);
  recording.play([&](const wire::Event& event) {
    if (const auto* note = std::get_if<wire::Note>(&event))
      trace.moment(group_of(static_cast<std::size_t>(note->agent)), kHappened,
                   static_cast<double>(note->t_ns) / 1000.0, note->text);
    if (const auto* serial = std::get_if<wire::SerialText>(&event))
      trace.moment(group_of(static_cast<std::size_t>(serial->agent)), kSerial,
                   static_cast<double>(serial->t_ns) / 1000.0,
                   serial->text.substr(0, serial->text.find_last_not_of("\r\n") + 1));
  });
  for (std::size_t robot = 0; robot < header.robot_count(); ++robot) {
    const wire::RunResult& result = header.of(robot).result;
    trace.moment(group_of(robot), kHappened, result.time_s * 1e6, result.verdict + ": " + result.why);
  }
  return trace.text();
}

std::string TraceRecorder::content(const std::string& recording) const {
  return trace_of(Recording::decode(recording, "the recording"));
}

}  // namespace robosim::record
