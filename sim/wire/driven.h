// Defines the messages that drive a run step by step: the client's requests during a pause, and the answers.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "sim/result/run_result.h"
#include "sim/result/stop.h"
#include "sim/wire/stream.h"

namespace robosim::wire {
using namespace result;  // the values that messages carry

/// Executes lines of the scenario language, written without times, as soon as the run continues.
struct Act {
  static constexpr const char* kDo = "script";
  std::string lines;
  int agent = 0;
};

template <class V>
void fields(V& v, Same<V, Act>& a) {
  v("lines", a.lines, "lines of the scenario language, without their times: `press start 100ms`",
    {.not_empty = true});
  agent_field(v, a.agent);
}

/// Continues the run until the first of these conditions holds, or until the verdict.
struct GoOn {
  static constexpr const char* kDo = "continue";
  std::optional<std::int64_t> to_ns;  ///< unset = no limit
  std::vector<Stop> until;
};

template <class V>
void fields(V& v, Same<V, GoOn>& g) {
  v("to_ns", g.to_ns, "simulated time at which the run pauses again",
    {.unit = "ns", .otherwise = "never", .least = 0});
  v("until", g.until, "stop conditions; the run pauses at the first that is met",
    {.otherwise = "none", .presence = when(!g.until.empty())});
}

/// Requests the content of the non-volatile memory.
struct ReadEeprom {
  static constexpr const char* kDo = "eeprom";
  int agent = 0;
};
template <class V>
void fields(V& v, Same<V, ReadEeprom>& r) {
  agent_field(v, r.agent);
}

/// Ends the run at its present time, with the verdict `interrupted`.
struct End {
  static constexpr const char* kDo = "end";
};
template <class V>
void fields(V&, Same<V, End>&) {}

/// The requests that a run serves during a pause.
using DrivenRequest = std::variant<Act, GoOn, ReadEeprom, End>;

/// The largest cross-track error of all ticks since the last resume, with its time and place.
struct Worst {
  double cross_track_mm = 0.0;
  std::int64_t t_ns = 0;
  double x_mm = 0.0;
  double y_mm = 0.0;
};

template <class V>
void fields(V& v, Same<V, Worst>& w) {
  v("cross_track", w.cross_track_mm, "largest cross-track error", {.unit = "mm"});
  v("t_ns", w.t_ns, "time of this error", {.unit = "ns"});
  v("x", w.x_mm, "position of the axle's centre at this time", {.unit = "mm"});
  v("y", w.y_mm, "position of the axle's centre at this time", {.unit = "mm"});
}

/// The state of a paused run, at the beginning of a tick.
struct Paused {
  static constexpr const char* kKey = "paused";
  std::int64_t t_ns = 0;
  Sample sample;
  int stop = -1;  ///< index of the condition that paused the run; -1 = none
  Worst worst;    ///< largest cross-track error since the last resume
  bool powered = true;
  bool driven = false;           ///< a motor is commanded
  std::size_t serial_bytes = 0;  ///< number of bytes that the firmware has sent so far
  Metrics metrics;
  std::optional<Resources> resources;  ///< only on a chip
  std::string verdict;                 ///< this robot's verdict while others continue; empty = none yet
  std::string why;                     ///< reason for the verdict, one sentence
  std::vector<Paused> others;          ///< the run's further robots
};

template <class V>
void fields(V& v, Same<V, Paused>& p) {
  v("t_ns", p.t_ns, "simulated time of the pause", {.unit = "ns"});
  v("sample", p.sample, "state of the robot at this time");
  v("stop", p.stop, "index in `until`, from 0, of the stop that was met; absent if none was",
    {.presence = when(p.stop >= 0)});
  v("worst", p.worst, "largest cross-track error since the last resume");
  v("powered", p.powered, "whether the robot has power");
  v("driven", p.driven, "whether a motor is commanded");
  v("serial_bytes", p.serial_bytes, "number of bytes that the firmware has sent so far");
  v("metrics", p.metrics, "measurements so far");
  v("resources", p.resources, "resources of the chip that the firmware used so far; absent on the host");
  v("verdict", p.verdict, "this robot's verdict, while other robots continue; else absent",
    {.presence = when(!p.verdict.empty())});
  v("why", p.why, "reason for that verdict, one sentence", {.presence = when(!p.verdict.empty())});
  v("others", p.others, "the further robots of the request, each with these keys; absent if there are none",
    {.presence = when(!p.others.empty())});
}

/// Lines that a paused run will execute, with their times.
struct Accepted {
  static constexpr const char* kKey = "accepted";
  std::string lines;
  int agent = 0;
};

template <class V>
void fields(V& v, Same<V, Accepted>& a) {
  v("lines", a.lines, "the accepted lines, with their times");
  agent_field(v, a.agent);
}

/// The non-volatile memory.
struct Eeprom {
  std::vector<std::uint8_t> bytes;
};

/// Rejects an invalid request. The request has had no effect.
struct Refused {
  std::string message;
};

}  // namespace robosim::wire
