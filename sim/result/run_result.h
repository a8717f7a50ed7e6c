// Defines the result of a run, such as its verdict, measurements, resources of the chip, or a crash. The
// simulation sets these values, and every client reads them.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "sim/result/fields.h"

namespace robosim::result {

/// A line of the sketch. If the line is unknown, `function` and `file` are empty, and `line` is 0.
struct SourceLine {
  std::string function;
  std::string file;  ///< as the user named it ("Blink.ino")
  int line = 0;
};

template <class V>
void fields(V& v, Same<V, SourceLine>& s) {
  v("function", s.function, "the function; empty if unknown", {.presence = kOptional});
  v("file", s.file, "the file, as the user named it; empty if unknown", {.presence = kOptional});
  v("line", s.line, "the line, from 1; 0 if unknown", {.presence = kOptional});
}

/// The reason why firmware cannot continue.
struct Crash {
  std::string reason;  ///< a clause: "division by zero", "read of address 0x0 (null pointer)"
  SourceLine where;
  std::vector<SourceLine> calls;  ///< innermost first, with calls in the Arduino core; chip targets only
  std::string registers;          ///< registers of the chip's processor, for display; else empty
  std::string check;              ///< the check that found the crash: "mul_overflow", "sandbox"; else empty
};

template <class V>
void fields(V& v, Same<V, Crash>& c) {
  v("reason", c.reason, "the reason, a clause: \"division by zero\"");
  fields(v, c.where);
  v("check", c.check,
    "the check that found the crash: one that is built into the image, or `\"sandbox\"` "
    "([security](../explanation/security.md)); else absent",
    {.presence = when(!c.check.empty())});
  v("calls", c.calls, "on a chip: calls that led to the crash, innermost first, including the core's",
    {.presence = when(!c.registers.empty())});
  v("registers", c.registers, "on a chip: the processor's registers, as lines for people",
    {.presence = when(!c.registers.empty())});
}

/// The first check that failed in a second run, whose firmware is built with checks (--sanitize).
struct Finding {
  Crash fault;
  double time_s = 0.0;  ///< simulated time of the finding
  std::string advice;   ///< may be empty
};

template <class V>
void fields(V& v, Same<V, Finding>& f) {
  v("check", f.fault.check, "the check that failed: `\"mul_overflow\"`");
  v("reason", f.fault.reason, "the reason, a clause");
  fields(v, f.fault.where);
  v("time_s", f.time_s, "simulated time of the finding", {.unit = "s"});
}

/// A line of the sketch that divided an integer by zero and continued, as on a chip. Only runs on the host
/// report this.
struct DivisionByZero {
  SourceLine where;
  double first_s = 0.0;  ///< simulated time of the first division
  std::int64_t times = 0;
};

template <class V>
void fields(V& v, Same<V, DivisionByZero>& d) {
  fields(v, d.where);
  v("first_s", d.first_s, "time of the first division", {.unit = "s"});
  v("times", d.times, "number of divisions");
}

/// A feature of the chip that the sketch used, but that the run's target lacks. After the first use, the run
/// may differ from the chip's behaviour. Only runs on the host report this.
struct Lack {
  std::string what;  ///< name of the feature in a sketch: "CLKPR"
  SourceLine where;
  double first_s = 0.0;  ///< simulated time of the first use
};

template <class V>
void fields(V& v, Same<V, Lack>& l) {
  v("what", l.what, "name of the feature in a sketch: `\"CLKPR\"`");
  fields(v, l.where);
  v("first_s", l.first_s, "time of the first use", {.unit = "s"});
}

/// A finding of a detector (docs/howto/sanitizers.md): the sketch works in the simulation, but would fail on
/// a real robot. The run continued.
struct Detected {
  std::string detector;  ///< "blind"
  std::string what;      ///< a sentence: the finding and its effect
  std::string mend;      ///< a sentence: the fix
  SourceLine where;
  double first_s = 0.0;  ///< simulated time of the first occurrence
  std::int64_t times = 1;
};

template <class V>
void fields(V& v, Same<V, Detected>& d) {
  v("detector", d.detector, "name of the detector: `\"blind\"`");
  v("what", d.what, "a sentence: the finding and its effect");
  v("mend", d.mend, "a sentence: the fix");
  fields(v, d.where);
  v("first_s", d.first_s, "time of the first occurrence", {.unit = "s"});
  v("times", d.times, "number of occurrences at this line");
}

/// Returns "the robot drove … in loop, Follow.ino:9 (3 times, first at 0.31 s). Let loop() …"
std::string text_of(const Detected& seen);

/// The firmware's use of its chip, measured since power-on.
struct Resources {
  std::int64_t flash_bytes = 0;      ///< code, constants, initial values of variables
  std::int64_t ram_bytes = 0;        ///< variables
  std::int64_t stack_bytes_max = 0;  ///< the maximum in use, including handlers
  std::int64_t free_bytes_min = 0;   ///< RAM that variables, heap and stack never used
  std::int64_t loops = 0;            ///< number of passes of loop(); 0 = this and the next two are unknown
  double loop_us_max = 0.0;          ///< longest time from one beginning of loop() to the next or to the end
  double loop_us_mean = 0.0;
  double interrupt_share = 0.0;  ///< share of the time in interrupt handlers: 0..1
  double cpu_load = 0.0;         ///< share of the time awake, including waiting loops: 0..1
};

template <class V>
void fields(V& v, Same<V, Resources>& r) {
  const Presence if_loops = when(r.loops > 0);
  v("flash_bytes", r.flash_bytes, "code, constants and the variables' initial values");
  v("ram_bytes", r.ram_bytes, "variables");
  v("stack_bytes_max", r.stack_bytes_max,
    "maximum stack use, including interrupt handlers; measured at every change of the stack pointer");
  v("free_bytes_min", r.free_bytes_min,
    "bytes of RAM between the highest end of variables and heap, and the deepest stack",
    {.presence = kOptional});
  v("interrupt_share", r.interrupt_share, "share of the time in interrupt handlers, 0..1");
  v("cpu_load", r.cpu_load, "share of the time not asleep, 0..1; waiting loops count as load");
  v("loops", r.loops,
    "number of passes of `loop()`, or of the endless loop of a `main()` without `loop()`; absent, like the "
    "next two keys, if no pass has ended, or the image does not distinguish inner loops",
    {.presence = if_loops});
  v("loop_us_max", r.loop_us_max,
    "longest time from one beginning of `loop()` to the next, or to the end of the run",
    {.unit = "µs", .presence = if_loops});
  v("loop_us_mean", r.loop_us_mean, "mean of these times", {.unit = "µs", .presence = if_loops});
}

/// A part of the score under a competition's rules.
struct ScorePart {
  std::string part;    ///< "gap", "time"
  int count = 0;       ///< number of such parts
  double value = 0.0;  ///< sum of their values, in the score's unit
};

template <class V>
void fields(V& v, Same<V, ScorePart>& p) {
  v("part", p.part, "name of the part: `\"time\"`, `\"gap\"` …");
  v("count", p.count, "number of such parts");
  v("value", p.value, "sum of their values in the score; negative = deducted");
}

/// Measurements of a run.
struct Metrics {
  double distance_m = 0.0;          ///< path of the axle's centre
  std::vector<double> laps_s;       ///< duration of each lap, on a loop
  double cross_track_rms_mm = 0.0;  ///< RMS distance of the sensors' midpoint from the nearest centre line
  double cross_track_max_mm = 0.0;  ///< maximum of this distance; both values ignore the first 0.5 s
  double off_line_s = 0.0;          ///< time with no sensor over a line
  int collisions = 0;
  double energy_j = 0.0;              ///< energy drawn by the motors
  std::vector<std::string> stations;  ///< visited stations, in the order of the first visit
  int junctions = 0;                  ///< number of different junctions visited
  double score = kNone;               ///< competition score, s or points; kNone = none yet
  std::string score_unit;             ///< "s" or "points"; empty = no competition
  double run_s = kNone;               ///< time on the competition's clock
  std::vector<ScorePart> score_parts;
  double energy_back_j = 0.0;  ///< energy recovered from the motors

  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
};

template <class V>
void fields(V& v, Same<V, Metrics>& m) {
  v("distance_m", m.distance_m, "path of the axle's centre", {.unit = "m"});
  v("laps_s", m.laps_s, "duration of each complete lap, on a loop", {.unit = "s"});
  v("cross_track_rms_mm", m.cross_track_rms_mm,
    "distance from the midpoint of the line sensors to the nearest centre line: root mean square over all "
    "ticks after the first 0.5 s",
    {.unit = "mm"});
  v("cross_track_max_mm", m.cross_track_max_mm, "maximum of this distance", {.unit = "mm"});
  v("off_line_s", m.off_line_s, "time with no sensor over a line", {.unit = "s"});
  v("collisions", m.collisions,
    "contacts with walls, obstacles, robots and the map's edge; a lasting contact counts once");
  v("energy_j", m.energy_j, "energy that the motors drew from the battery", {.unit = "J"});
  v("energy_back_j", m.energy_back_j,
    "energy that braking motors returned to the battery; absent if zero, for example if the "
    "[motors](robots.md#motors) have no `inductance`",
    {.unit = "J", .presence = when(m.energy_back_j != 0.0)});
  v("stations", m.stations, "names of the visited stations, in the order of the first visit");
  v("junctions", m.junctions, "number of different junctions visited");
  v("score", m.score,
    "score in the goal's [competition](courses.md), in s or points; absent if there is no competition, or no "
    "score yet",
    {.presence = when(!std::isnan(m.score))});
  v("score_unit", m.score_unit, "`\"s\"` (less is better) or `\"points\"`; absent if there is no competition",
    {.presence = when(!m.score_unit.empty())});
  v("run_s", m.run_s, "time on the competition's clock at the end of the run",
    {.unit = "s", .presence = when(!std::isnan(m.run_s))});
  v("score_parts", m.score_parts, "parts of the score; absent if there are none yet",
    {.presence = when(!m.score_parts.empty())});
}

/// Lists where the firmware's use of pins and parts differs from the robot's wiring.
struct Usage {
  struct Loose {
    std::string pin;  ///< "D7"
    std::string how;  ///< "driven" or "read"
  };
  struct Steady {
    std::string part;   ///< name of the part, or of the element of an array
    std::string reads;  ///< "HIGH", "LOW" or "4.3 V"
  };
  std::vector<Loose> unwired;       ///< pins that the firmware used, although nothing is wired to them
  std::vector<std::string> unused;  ///< parts that were never driven, read or awaited
  std::vector<Steady> steady;       ///< buttons and sensors that were read and never changed
};

template <class V>
void fields(V& v, Same<V, Usage::Loose>& l) {
  v("pin", l.pin, "the pin: `\"D7\"`");
  v("how", l.how, "use of the pin: `\"driven\"` or `\"read\"`");
}

template <class V>
void fields(V& v, Same<V, Usage::Steady>& s) {
  v("part", s.part, "name of the part, or of the element of an array");
  v("reads", s.reads,
    "the reading: `\"HIGH\"`, `\"LOW\"` or `\"4.3 V\"`, with `\", last read at 1.02 s\"` if reads ended "
    "early");
}

template <class V>
void fields(V& v, Same<V, Usage>& u) {
  v("unwired", u.unwired, "pins that the sketch used, though nothing is wired to them");
  v("unused", u.unused, "names of parts and sensors that the sketch neither drove nor read");
  v("steady", u.steady, "buttons and sensors that the sketch read, and whose readings never changed");
}

/// The robot's pose: the axle's centre, x east and y north of the map's bottom-left corner.
struct Pose {
  double x_mm = 0.0;
  double y_mm = 0.0;
  double yaw_rad = 0.0;  ///< from east, anticlockwise
};

template <class V>
void fields(V& v, Same<V, Pose>& p) {
  v("x", p.x_mm, "position of the axle's centre, east of the map's left edge", {.unit = "mm"});
  v("y", p.y_mm, "position of the axle's centre, north of the map's bottom edge", {.unit = "mm"});
  v("yaw", p.yaw_rad, "heading from east, anticlockwise", {.unit = "rad"});
}

/// The text of a cause whose lines ran long before those of the other causes. Also used for lines that
/// declare a variable that never changed.
inline constexpr const char* kSetBefore = "set earlier, unchanged since";

/// One element of the chain of causes that leads back from a verdict.
struct Cause {
  double t_s = 0.0;
  std::string text;               ///< "read S1 0.31 V"
  std::vector<SourceLine> lines;  ///< lines of the sketch, nearest first
};

template <class V>
void fields(V& v, Same<V, Cause>& c) {
  v("t_s", c.t_s, "simulated time; 0 = since the start", {.unit = "s"});
  v("text", c.text, "the event at this time: `\"read S1 0.31 V\"`");
  v("lines", c.lines, "responsible lines of the sketch, nearest first");
}

struct RunResult {
  struct Entry {
    double t_s = 0.0;
    std::string text;
  };
  static constexpr const char* kKey = "result";

  std::string verdict;  ///< "reached", "lost", …
  std::string why;      ///< one sentence
  std::string next;     ///< the suggested next step; may be empty
  std::string next_by;  ///< kind of that step: "host" (a run on the host), "watching", "script"; else empty
  int status = 0;       ///< exit status of the verdict
  double time_s = 0.0;
  Metrics metrics;
  std::optional<Crash> crash;
  std::vector<DivisionByZero> divisions_by_zero;
  std::vector<Lack> lacks;
  int watchdog_resets = 0;             ///< number of resets by the watchdog
  std::vector<Detected> detected;      ///< only if the request turned on detectors
  std::optional<Resources> resources;  ///< only on a chip
  Usage usage;
  std::vector<Cause> because;  ///< causes of the verdict; empty = not requested, or no cause found
  std::vector<Entry> events;   ///< the last events
  std::string serial;
  std::string shown;
  Pose end;                         ///< the robot's pose at the end
  std::uint64_t eeprom_writes = 0;  ///< bytes that the firmware wrote to its EEPROM
  std::string trace_hash;
  std::string goal;
  double for_s = 0.0;
  std::uint64_t seed = 1;
  std::string profile;
  std::string map_sha256;
  std::string robot_sha256;
  std::string image_sha256;
  std::vector<RunResult> others;  ///< results of all robots except the first
  std::vector<RunResult> ways;    ///< results of the second and further branches (wire::Ways)
};

template <class V>
void fields(V& v, Same<V, RunResult::Entry>& e) {
  v("t_s", e.t_s, "time of the event", {.unit = "s"});
  v("text", e.text, "the event: `\"station 2 visited\"`");
}

template <class V>
void fields(V& v, Same<V, RunResult>& r) {
  v("verdict", r.verdict, "the verdict: `\"reached\"`, `\"lost\"` …");
  v("why", r.why, "reason for the verdict, one sentence");
  v("next", r.next, "what to try next; may be empty", {.presence = kOptional});
  v("next_by", r.next_by,
    "kind of that step: a run on the `\"host\"`, `\"watching\"`, or a `\"script\"`; absent for other steps",
    {.presence = when(!r.next_by.empty())});
  v("status", r.status, "exit status of the verdict");
  v("time_s", r.time_s, "simulated time at the end", {.unit = "s"});
  v("metrics", r.metrics, "measurements of the run");
  v("crash", r.crash, "absent unless the firmware crashed");
  v("divisions_by_zero", r.divisions_by_zero,
    "on the host: the first 8 lines that divided an integer by zero; the run continued with the chip's "
    "result",
    {.presence = when(!r.divisions_by_zero.empty())});
  v("lacks", r.lacks,
    "on the host: chip features that the firmware used and that the host lacks; after the first use, the run "
    "may differ from the chip",
    {.presence = when(!r.lacks.empty())});
  v("watchdog_resets", r.watchdog_resets, "how often the watchdog reset the chip; absent if never",
    {.presence = when(r.watchdog_resets > 0)});
  v("detected", r.detected,
    "findings of the [detectors](../howto/sanitizers.md#detectors); absent if there are none",
    {.presence = when(!r.detected.empty())});
  v("resources", r.resources, "resources of the chip that the firmware used; absent on the host");
  v("usage", r.usage, "differences between the robot's wiring and the firmware's use of it",
    {.presence = kOptional});
  v("because", r.because,
    "chain of causes that leads back from the verdict ([why](../howto/why.md)); absent unless requested",
    {.presence = when(!r.because.empty())});
  v("events", r.events, "the last events, at most 8");
  v("serial", r.serial, "text that the firmware sent, up to 1 MiB");
  v("shown", r.shown, "texts of displays and Bluetooth modules, up to 64 KiB, one per line: `lcd: \"Lap 2\"`",
    {.presence = when(!r.shown.empty())});
  v("end", r.end, "the robot's pose at the end", {.presence = kOptional});
  v("eeprom_writes", r.eeprom_writes, "number of bytes that the firmware wrote to its EEPROM",
    {.presence = kOptional});
  v("trace_hash", r.trace_hash, "fingerprint of the run: equal inputs give equal hashes");
  v("goal", r.goal, "the goal, as on the command line");
  v("for_s", r.for_s, "maximum simulated time", {.unit = "s"});
  v("seed", r.seed, "seed of the noise");
  v("profile", r.profile, "the profile with its version: `\"ideal\"`, `\"typical@1\"` …");
  v("map_sha256", r.map_sha256, "SHA-256 of the map's file");
  v("robot_sha256", r.robot_sha256, "SHA-256 of the robot's file");
  v("image_sha256", r.image_sha256, "SHA-256 of the firmware image");
  v("others", r.others,
    "results of the further robots of the request, each with these keys; absent if there are none",
    {.presence = when(!r.others.empty())});
  v("ways", r.ways, "results of the second and further ways of a run with several ways; else absent",
    {.presence = when(!r.ways.empty())});
}

}  // namespace robosim::result
