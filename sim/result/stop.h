// Defines the stop conditions of a run that is driven step by step.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

#include "sim/result/fields.h"

namespace robosim::result {

/// A stop condition of a run, checked at the end of each tick.
struct Stop {
  enum class Kind {
    serial,   ///< the firmware has sent `text`, at or after byte number `from`
    line,     ///< the firmware has sent, from byte `from` on, a line that matches the regex `text`
    note,     ///< an event has occurred whose text_of() contains `text`
    event,    ///< an event of the kind `text` has occurred: "collision_began" (event_kinds())
    visited,  ///< station `text` has been visited
    at,       ///< the body covers the centre of station `text`
    reading,  ///< part `text` reads at least 0.5 if `level` is true, and less if it is false
    pin,      ///< the firmware drives pin `text`: high or with PWM if `level`, otherwise low
    motors,   ///< `level` is true: a motor is driven; `level` is false: no motor is driven
    rest,     ///< no wheel has turned for `rest_ns`, counted from the last resume of the run
  };
  Kind kind = Kind::rest;
  std::string text;          ///< text, regular expression, station, part or pin
  std::size_t from = 0;      ///< for serial and line: number of the first byte that counts
  bool level = true;         ///< for reading, pin and motors: the expected state
  std::int64_t rest_ns = 0;  ///< for rest: the duration
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
  v.choice(s.kind, Kind::note, "note", s.text, "a `note` whose `text` contains this text has occurred");
  v.choice(s.kind, Kind::event, "event", s.text,
           "an event of this kind has occurred: `\"collision_began\"` or another `kind` of a `note`");
  v.choice(s.kind, Kind::visited, "visited", s.text,
           "this station (number or name) has been visited, at any time");
  v.choice(s.kind, Kind::at, "at", s.text, "the body covers this station's centre");
  v.choice(s.kind, Kind::reading, "reading", s.text, "this part's reading is at least 0.5");
  v.choice(s.kind, Kind::pin, "pin", s.text,
           "the firmware drives this pin high or with PWM, however briefly");
  v.choice(s.kind, Kind::motors, "motors", s.level, "`true`: a motor is driven; `false`: no motor is driven");
  v.choice(s.kind, Kind::rest, "rest_ns", s.rest_ns,
           "no wheel has turned for this duration, counted from the last resume of the run",
           {.unit = "ns", .least = 0});
  if (V::kDescribes || s.kind == Kind::serial || s.kind == Kind::line)
    v("from", s.from, "with `serial` and `line`: number of the first byte that counts",
      {.presence = kOptional});
  if (V::kDescribes || s.kind == Kind::reading || s.kind == Kind::pin)
    v("level", s.level,
      "with `reading` and `pin`; `false`: the reading is below 0.5, or the pin is driven low",
      {.presence = kOptional});
  agent_field(v, s.agent);
}

}  // namespace robosim::result
