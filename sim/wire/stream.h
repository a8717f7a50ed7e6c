// Defines the events that a run reports to its client. Times are simulated. Lengths are in millimetres,
// angles in radians. In world coordinates, x points east and y north, from the map's bottom-left corner.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <tuple>
#include <variant>
#include <vector>

#include "sim/result/events.h"
#include "sim/result/run_result.h"
#include "sim/wire/columns.h"

namespace robosim::wire {
using namespace result;  // the values that messages carry

/// The latest possible time of an event: more than a hundred years.
inline constexpr std::int64_t kLatest_ns = 4'000'000'000'000'000'000;

/// Sent once for each robot, before all other events about this robot.
struct Started {
  static constexpr const char* kEvent = "started";
  struct Station {
    int id = 0;
    std::string name;
    int x = 0;  ///< column, from the left
    int y = 0;  ///< row, from the top
  };
  int x = 0;  ///< start: column
  int y = 0;  ///< start: row
  char facing = 'E';
  std::string goal;
  std::vector<Station> stations;
  std::vector<std::string> readings;  ///< names of Sample::readings
  int width = 0;                      ///< width of the map, in cells
  int height = 0;                     ///< height of the map, in cells
  double cell_mm = 0.0;               ///< side of a cell
  int agent = 0;
};

template <class V>
void fields(V& v, Same<V, Started::Station>& s) {
  v("id", s.id, "number of the station");
  v("name", s.name, "name of the station; its number if it has no name");
  v("x", s.x, "column of the station, from the left");
  v("y", s.y, "row of the station, from the top");
}

template <class V>
void fields(V& v, Same<V, Started>& s) {
  v("start", std::tie(s.x, s.y, s.facing), "column, row and direction of the robot's start");
  v("goal", s.goal, "the goal, as on the command line");
  v("stations", s.stations, "stations of the map");
  v("readings", s.readings, "names of the readings in a sample, in their order");
  v("width", s.width, "width of the map, in cells", {.presence = kOptional});
  v("height", s.height, "height of the map, in cells", {.presence = kOptional});
  v("cell", s.cell_mm, "side of a cell", {.unit = "mm", .presence = kOptional});
  agent_field(v, s.agent);
}

/// The state of a robot at a moment, for display.
struct Sample {
  static constexpr const char* kEvent = "sample";
  std::int64_t t_us = 0;
  double x_mm = 0.0;
  double y_mm = 0.0;
  double yaw_rad = 0.0;
  double speed_mm_s = 0.0;
  double cross_track_mm = 0.0;
  double left = 0.0;                    ///< command of the left motor, -1..1
  double right = 0.0;                   ///< command of the right motor, -1..1
  std::vector<double> readings;         ///< sensors: 0 white .. 1 black; LEDs and buttons: 0 or 1
  std::string at_station;               ///< covered station, in a run driven step by step; "" = none
  std::array<double, 2> wheels_mm_s{};  ///< tread speeds of the left and right wheel, even during slip
  int agent = 0;
};

template <class V>
void fields(V& v, Same<V, Sample>& s) {
  v("t_us", s.t_us, "time of the sample", {.unit = "µs", .least = 0, .most = kLatest_ns / 1000});
  v("x", s.x_mm, "position of the axle's centre, east of the map's left edge", {.unit = "mm"});
  v("y", s.y_mm, "position of the axle's centre, north of the map's bottom edge", {.unit = "mm"});
  v("yaw", s.yaw_rad, "heading from east, anticlockwise", {.unit = "rad"});
  v("speed_mm_s", s.speed_mm_s, "speed of the axle's centre, forward", {.unit = "mm/s"});
  v("cross_track", s.cross_track_mm, "distance from the midpoint of the line sensors to the nearest line",
    {.unit = "mm"});
  v("left", s.left, "command of the left motor, -1..1");
  v("right", s.right, "command of the right motor, -1..1");
  v("wheels", s.wheels_mm_s, "speeds of the left and right wheel's tread, even during slip",
    {.unit = "mm/s", .presence = kOptional});
  v("readings", s.readings,
    "noise-free readings in the order of `started`: sensors from 0 (white) to 1 (black), LEDs and buttons 0 "
    "or 1, gauges in their units");
  v("at", s.at_station,
    "in a run that is driven step by step: the station whose centre the body covers; absent if none",
    {.presence = when(!s.at_station.empty())});
  agent_field(v, s.agent);
}

/// The firmware drives a pin differently from before.
struct PinChange {
  static constexpr const char* kEvent = "pin";
  std::int64_t t_ns = 0;
  std::string pin;   ///< "D5"
  std::string mode;  ///< "input", "input_pullup" or "output"
  bool level = false;
  bool pwm = false;
  double duty = 0.0;
  std::uint32_t tone_hz = 0;  ///< 0 = none
  SourceLine source;
  int agent = 0;
};

/// The firmware read a pin, or an edge reached one of its interrupts.
struct LevelSeen {
  static constexpr const char* kEvent = "level";
  std::int64_t t_ns = 0;
  std::string pin;
  bool level = false;
  SourceLine source;
  int agent = 0;
};

/// The ADC sampled a pin.
struct VoltsSeen {
  static constexpr const char* kEvent = "volts";
  std::int64_t t_ns = 0;
  std::string pin;
  double volts = 0.0;
  SourceLine source;
  int agent = 0;
};

/// The UART has sent or received a byte.
struct SerialByte {
  static constexpr const char* kEvent = "byte";
  std::int64_t t_ns = 0;
  std::uint8_t value = 0;
  bool sent = false;  ///< sent by the firmware; otherwise received
  SourceLine source;
  int agent = 0;
};

template <class V>
void source_field(V& v, Same<V, SourceLine>& source) {
  v("source", source, "line of the sketch that caused the event; absent if unknown or not requested",
    {.presence = when(!source.file.empty())});
}

template <class V>
void fields(V& v, Same<V, PinChange>& p) {
  v("t_ns", p.t_ns, "time of the event", {.unit = "ns", .least = 0, .most = kLatest_ns});
  v("pin", p.pin, "the pin: `\"D5\"`");
  v("mode", p.mode, "mode that the firmware has set", {.one_of = {"input", "input_pullup", "output"}});
  v("level", p.level, "for an output: whether the pin is high");
  v("pwm", p.pwm, "whether PWM drives the pin");
  v("duty", p.duty, "share of the time that the pin is high, 0..1");
  v("tone_hz", p.tone_hz, "frequency of `tone()`; 0 = none", {.unit = "Hz", .presence = kOptional});
  source_field(v, p.source);
  agent_field(v, p.agent);
}

template <class V>
void fields(V& v, Same<V, LevelSeen>& l) {
  v("t_ns", l.t_ns, "time of the event", {.unit = "ns", .least = 0, .most = kLatest_ns});
  v("pin", l.pin, "the pin: `\"D2\"`");
  v("level", l.level, "level that the firmware read, or level after an edge that reached an interrupt");
  source_field(v, l.source);
  agent_field(v, l.agent);
}

template <class V>
void fields(V& v, Same<V, VoltsSeen>& s) {
  v("t_ns", s.t_ns, "time of the event", {.unit = "ns", .least = 0, .most = kLatest_ns});
  v("pin", s.pin, "the pin: `\"A0\"`");
  v("volts", s.volts, "voltage that the ADC sampled", {.unit = "V"});
  source_field(v, s.source);
  agent_field(v, s.agent);
}

template <class V>
void fields(V& v, Same<V, SerialByte>& b) {
  v("t_ns", b.t_ns, "time of the event", {.unit = "ns", .least = 0, .most = kLatest_ns});
  v("value", b.value, "value of the byte");
  v("sent", b.sent, "`true`: the firmware has sent the byte; `false`: it has received the byte");
  source_field(v, b.source);
  agent_field(v, b.agent);
}

/// The firmware's output: a line, or part of a line.
struct SerialText {
  static constexpr const char* kEvent = "serial";
  std::int64_t t_ns = 0;
  std::string text;
  int agent = 0;
};

template <class V>
void fields(V& v, Same<V, SerialText>& s) {
  v("t_ns", s.t_ns, "time of the text's last byte", {.unit = "ns", .least = 0, .most = kLatest_ns});
  v("text", s.text, "a line with its end, or a part of a line");
  agent_field(v, s.agent);
}

/// A notable event of the run: `what` is for programs, `text` for people.
struct Note {
  static constexpr const char* kEvent = "note";
  std::int64_t t_ns = 0;
  std::string text;
  std::optional<RunEvent::What> what;  ///< unset if a newer runner sends an unknown kind
  int agent = 0;                       ///< number of the robot

  /// Returns `what` if the note is of this kind, else null: `note.is<StationVisited>()`.
  template <class What>
  const What* is() const {
    return what ? std::get_if<What>(&*what) : nullptr;
  }
};

inline Note note_of(const RunEvent& event) { return {event.t_ns, text_of(event), event.what, event.agent}; }

template <class V>
void fields(V& v, Same<V, Note>& n) {
  v("t_ns", n.t_ns, "time of the event", {.unit = "ns", .least = 0, .most = kLatest_ns});
  v("text", n.text, "the event, for people: `\"station 2 visited\"`");
  agent_field(v, n.agent);
  v.kinds("kind", n.what,
          "kind of the event; each key below is present for the kinds that its meaning names");
}

/// The run waits for a debugger before the firmware's first instruction.
struct DebuggerAwaited {
  static constexpr const char* kEvent = "debugger_awaited";
  int port = 0;
};

template <class V>
void fields(V& v, Same<V, DebuggerAwaited>& d) {
  v("port", d.port, "port of 127.0.0.1 on which the runner listens now");
}

/// Many events at once (batch.h), if the request allows batches. The raw bytes follow the line, which states
/// the number of bytes. Listeners of a run get the events one by one.
struct Batch {
  static constexpr const char* kEvent = "batch";
  static constexpr std::int64_t kMost_bytes = std::int64_t{1} << 30;
  std::int64_t size = 0;   ///< after reading a line: the number of bytes that follow it
  std::string bytes = {};  ///< set only to write a batch
};

template <class V>
void fields(V& v, Same<V, Batch>& b) {
  v("size", b.size, "number of bytes that follow the line; the next line comes after these bytes",
    {.least = 0, .most = Batch::kMost_bytes});
}

using Event = std::variant<Started, Sample, PinChange, SerialText, Note, LevelSeen, VoltsSeen, SerialByte,
                           DebuggerAwaited, Columns, Batch>;
/// Receives every event, in the order of simulated time. The order is only approximate for LevelSeen and
/// SerialByte. Until the call returns, a full pipe may delay the runner. No result depends on this delay.
using OnEvent = std::function<void(const Event&)>;

}  // namespace robosim::wire
