// Defines the messages that drive a run step by step: the client's requests during a pause, and the answers.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "sim/wire/run_result.h"
#include "sim/wire/stream.h"

namespace robosim::wire {

/// A stop condition of a run, checked at the end of each tick.
struct Stop {
  enum class Kind {
    serial,   ///< the firmware has sent `text`, at or after byte number `from`
    line,     ///< it has sent a line, at or after byte `from`, that matches the regular expression `text`
    note,     ///< an event has occurred whose text_of() contains `text`
    event,    ///< an event of this kind has occurred: "collision_began" (event_kinds())
    visited,  ///< station `text` has been visited
    at,       ///< the body covers the centre of station `text`
    reading,  ///< the part `text` reads at least 0.5 (`level`), or less (not `level`)
    pin,      ///< the firmware drives pin `text` high or with PWM (`level`), or low (not `level`)
    motors,   ///< a motor is driven (`level`), or no motor is (not `level`)
    rest,     ///< no wheel has turned for `rest_ns`, counted from the last resume
  };
  Kind kind = Kind::rest;
  std::string text;          ///< text, regular expression, station, part or pin
  std::size_t from = 0;      ///< serial, line: number of the first byte that counts
  bool level = true;         ///< reading, pin, motors
  std::int64_t rest_ns = 0;  ///< rest
  int agent = 0;             ///< number of the robot

  static Stop serial(std::string text, std::size_t from = 0) { return {Kind::serial, std::move(text), from}; }
  static Stop line(std::string regex, std::size_t from = 0) { return {Kind::line, std::move(regex), from}; }
  static Stop note(std::string text) { return {Kind::note, std::move(text)}; }
  static Stop event(std::string kind) { return {Kind::event, std::move(kind)}; }
  static Stop visited(std::string station) { return {Kind::visited, std::move(station)}; }
  static Stop at(std::string station) { return {Kind::at, std::move(station)}; }
  static Stop reading(std::string part, bool on) { return {Kind::reading, std::move(part), 0, on}; }
  static Stop pin(std::string pin, bool high) { return {Kind::pin, std::move(pin), 0, high}; }
  static Stop motors(bool driven) { return {Kind::motors, "", 0, driven}; }
  static Stop rest(std::int64_t ns) { return {Kind::rest, "", 0, true, ns}; }
};

template <class V>
void fields(V& v, Same<V, Stop>& s) {
  using Kind = Stop::Kind;
  v.choice(s.kind, Kind::serial, "serial", s.text, "the firmware has sent this text");
  v.choice(s.kind, Kind::line, "line", s.text,
           "a complete line sent by the firmware matches this regular expression (RE2) somewhere; only its "
           "first 1000 bytes count");
  v.choice(s.kind, Kind::note, "note", s.text, "a note whose `text` contains this has occurred");
  v.choice(s.kind, Kind::event, "event", s.text,
           "something of this kind happened: `\"collision_began\"` or another `kind` of a note");
  v.choice(s.kind, Kind::visited, "visited", s.text,
           "that station (number or name) has been visited, at any time");
  v.choice(s.kind, Kind::at, "at", s.text, "the body covers that station's centre");
  v.choice(s.kind, Kind::reading, "reading", s.text, "that part's reading is at least 0.5");
  v.choice(s.kind, Kind::pin, "pin", s.text,
           "the firmware drives that pin high, or with PWM, however briefly");
  v.choice(s.kind, Kind::motors, "motors", s.level, "`true`: a motor is driven; `false`: none is");
  v.choice(s.kind, Kind::rest, "rest_ns", s.rest_ns,
           "no wheel has turned for this time, counted from when the run went on",
           {.unit = "ns", .least = 0});
  if (V::kDescribes || s.kind == Kind::serial || s.kind == Kind::line)
    v("from", s.from, "with `serial` and `line`: number of the first byte that counts",
      {.presence = kOptional});
  if (V::kDescribes || s.kind == Kind::reading || s.kind == Kind::pin)
    v("level", s.level, "with `reading` and `pin`; `false`: the reading is less, the pin is driven low",
      {.presence = kOptional});
  agent_field(v, s.agent);
}

/// Runs lines of the scenario language, without their times, as soon as the run continues.
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

/// Continues the run until the first of these conditions, or to its verdict.
struct GoOn {
  static constexpr const char* kDo = "continue";
  std::optional<std::int64_t> to_ns;  ///< unset = no limit
  std::vector<Stop> until;
};

template <class V>
void fields(V& v, Same<V, GoOn>& g) {
  v("to_ns", g.to_ns, "simulated time at which it stands still again",
    {.unit = "ns", .otherwise = "never", .least = 0});
  v("until", g.until, "stops; it stands still at the first that is met",
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

/// When and where the cross-track error was largest. Every tick counts.
struct Worst {
  double cross_track_mm = 0.0;
  std::int64_t t_ns = 0;
  double x_mm = 0.0;
  double y_mm = 0.0;
};

template <class V>
void fields(V& v, Same<V, Worst>& w) {
  v("cross_track", w.cross_track_mm, "the largest cross-track error", {.unit = "mm"});
  v("t_ns", w.t_ns, "when that was", {.unit = "ns"});
  v("x", w.x_mm, "position of the axle's centre then", {.unit = "mm"});
  v("y", w.y_mm, "position of the axle's centre then", {.unit = "mm"});
}

/// The state of a paused run, at the beginning of a tick.
struct Paused {
  static constexpr const char* kKey = "paused";
  std::int64_t t_ns = 0;
  Sample sample;
  int stop = -1;  ///< index of the condition that paused the run; -1 = none
  Worst worst;    ///< since the last resume
  bool powered = true;
  bool driven = false;           ///< a motor is commanded
  std::size_t serial_bytes = 0;  ///< sent by the firmware so far
  Metrics metrics;
  std::optional<Resources> resources;  ///< only on a chip
  std::string verdict;                 ///< this robot's verdict while others continue; empty = none yet
  std::string why;                     ///< reason for the verdict, one sentence
  std::vector<Paused> others;          ///< the run's further robots
};

template <class V>
void fields(V& v, Same<V, Paused>& p) {
  v("t_ns", p.t_ns, "where it stands", {.unit = "ns"});
  v("sample", p.sample, "the state there");
  v("stop", p.stop, "number, from 0, of the stop that was met; absent at the start and when the time was up",
    {.presence = when(p.stop >= 0)});
  v("worst", p.worst, "the largest cross-track error since the run went on last");
  v("powered", p.powered, "whether the robot has power");
  v("driven", p.driven, "whether a motor is commanded");
  v("serial_bytes", p.serial_bytes, "how many bytes the firmware has sent");
  v("metrics", p.metrics, "figures so far");
  v("resources", p.resources, "resources of the chip that the firmware used so far; absent on the host");
  v("verdict", p.verdict, "verdict of a robot that has one while others go on; else absent",
    {.presence = when(!p.verdict.empty())});
  v("why", p.why, "reason of that verdict, one sentence", {.presence = when(!p.verdict.empty())});
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

/// The request was invalid: nothing happened.
struct Refused {
  std::string message;
};

}  // namespace robosim::wire
