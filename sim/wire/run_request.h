// Defines the requests to an idle runner: for a robot's description, or for a run.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "sim/base/profile.h"
#include "sim/result/fields.h"
#include "sim/result/lateness.h"

namespace robosim::wire {
using namespace result;  // the values that messages carry

/// Requests the description of a robot.
struct DescribeRobot {
  static constexpr const char* kDo = "describe_robot";
  std::string robot;
  bool full = false;  ///< includes RobotInfo::text
};

template <class V>
void fields(V& v, Same<V, DescribeRobot>& d) {
  v("robot", d.robot, "a stock robot's name, or a path, either with `@BOARD` for another board",
    {.not_empty = true});
  v("full", d.full, "`true`: the answer has the key `text`", {.presence = when(d.full)});
}

/// A further robot of a simulation. Missing settings are those of the whole run.
struct AgentRequest {
  std::string name;    ///< for messages
  std::string target;  ///< target of the firmware; empty = the runner's target
  std::string image;   ///< for this and the following members see RunRequest
  std::string robot;
  std::string start;
  std::string goal;
  std::int64_t clock_ns = 0;
  std::string script;
  std::string script_file = "script";
  std::vector<Lateness> late;
};

template <class V>
void fields(V& v, Same<V, AgentRequest>& a) {
  v("name", a.name, "name of the robot, for messages", {.not_empty = true});
  v("target", a.target,
    "whose firmware it has: `\"host\"`, `\"avr\"` or `\"stm32\"`, one that the runner has",
    {.otherwise = "the runner's", .presence = when(!a.target.empty())});
  v("image", a.image, "path of the firmware image", {.not_empty = true});
  v("robot", a.robot, "name or path", {.not_empty = true});
  v("start", a.start, "`\"X,Y,DIR\"`", {.otherwise = "the map's", .presence = when(!a.start.empty())});
  v("goal", a.goal, "as on the command line", {.otherwise = "the map's", .presence = when(!a.goal.empty())});
  v("clock_ns", a.clock_ns, "what the firmware's clock begins with; chip targets only",
    {.unit = "ns", .presence = when(a.clock_ns > 0), .least = 0});
  v("script", a.script, "text of a scenario", {.otherwise = "empty", .presence = when(!a.script.empty())});
  v("script_file", a.script_file, "its name, for messages", {.presence = when(!a.script.empty())});
  v("late", a.late, "when the sketch is late", {.otherwise = "never", .presence = when(!a.late.empty())});
}

/// The point at which a run branches. From there, the run continues in several ways from the same state.
struct Ways {
  std::int64_t at_ns = 0;            ///< time since power-on, a multiple of 1 ms; unused if `after` is set
  std::string after;                 ///< the run branches when the sketch has sent this text; "" = at_ns
  std::vector<std::string> scripts;  ///< for each way, the lines that follow the common script
};

template <class V>
void fields(V& v, Same<V, Ways>& w) {
  v("at_ns", w.at_ns, "where the run branches, unless `after` says it; a multiple of the tick (1 ms)",
    {.unit = "ns", .presence = kOptional, .least = 0, .multiple_of = 1'000'000});
  v("after", w.after, "the run branches when the sketch has sent this text",
    {.otherwise = "at `at_ns`", .presence = when(!w.after.empty())});
  v("scripts", w.scripts,
    "for each way, of which there are 1 to 64, lines that come at the end of the script. Nothing in them is "
    "due before the run branches; they may wait for `after`");
}

/// One simulation.
struct RunRequest {
  static constexpr const char* kDo = "run";
  std::string image;                      ///< path of the firmware image
  std::string map;                        ///< path
  std::string robot;                      ///< name or path
  std::string start;                      ///< "X,Y,DIR"; empty = the map's start
  std::string goal;                       ///< empty = the map's goal
  std::int64_t for_ns = 600'000'000'000;  ///< maximum simulated duration
  std::uint64_t seed = 1;
  std::string profile = "typical";     ///< one of kProfileNames
  std::int64_t clock_ns = 0;           ///< initial value of millis(); chip targets only
  std::vector<Lateness> late;          ///< sorted by time; on the host only
  int gdb_port = 0;                    ///< port that waits for a debugger; 0 = none; chip targets only
  std::string script;                  ///< text of a scenario
  std::string script_file = "script";  ///< name of the scenario in messages
  std::int64_t samples_every_ns = 0;   ///< a multiple of 1 ms; 0 = no samples
  std::int64_t columns_every_ns = 0;   ///< period of samples in columns, together with pin events; 0 = none
  bool started = true;                 ///< report Started; clients with a display wait for this event
  bool pins = false;                   ///< stream pin changes
  bool serial = false;                 ///< stream the firmware's output
  bool notes = false;                  ///< stream events: "station 2 visited"
  bool io = false;                     ///< stream the firmware's inputs, and serial bytes in both directions
  /// Streams pins and bytes only between these two times, with the responsible line of the sketch.
  std::optional<std::pair<std::int64_t, std::int64_t>> source_ns;
  bool batches = false;              ///< frequent events come in batches (batch.h), with a delay
  bool interactive = false;          ///< the client drives the run step by step (driven.h)
  bool detect = false;               ///< turns on detectors for the sketches (docs/howto/sanitizers.md)
  bool why = false;                  ///< trace the verdict back to its causes
  std::string counters;              ///< file for the counts of the sketch's lines; empty = none
  std::optional<Ways> ways;          ///< where the run branches; chip targets only
  std::string name;                  ///< name of the first robot, if there are several
  std::string target;                ///< target of the first of several robots; empty = the runner's
  std::vector<AgentRequest> agents;  ///< further robots: number 1, 2 …
};

template <class V>
void fields(V& v, Same<V, RunRequest>& r) {
  v("image", r.image, "path of the firmware image", {.not_empty = true});
  v("map", r.map, "path", {.not_empty = true});
  v("robot", r.robot, "name or path", {.not_empty = true});
  v("start", r.start, "`\"X,Y,DIR\"`", {.otherwise = "the map's", .presence = when(!r.start.empty())});
  v("goal", r.goal, "as on the command line", {.otherwise = "the map's", .presence = when(!r.goal.empty())});
  v("for_ns", r.for_ns, "simulated time", {.unit = "ns", .presence = kOptional, .least = 0});
  v("seed", r.seed, "seed of the noise", {.presence = kOptional});
  v("profile", r.profile, "how real the robot's parts are", {.presence = kOptional, .one_of = kProfileNames});
  v("clock_ns", r.clock_ns, "what the firmware's clock begins with; chip targets only",
    {.unit = "ns", .presence = when(r.clock_ns > 0), .least = 0});
  v("counters", r.counters,
    "file that the runner writes at the end: how often lines ran (`sim/base/archive.h`); on the host only an "
    "image that was built for coverage counts",
    {.otherwise = "none", .presence = when(!r.counters.empty())});
  v("detect", r.detect, "`true`: [detectors](../howto/sanitizers.md#detectors) watch the sketches",
    {.presence = when(r.detect)});
  v("gdb_port", r.gdb_port,
    "port of 127.0.0.1 at which the run waits for gdb before the first instruction; 0 = none; chip targets "
    "only (else an `input` error)",
    {.presence = when(r.gdb_port > 0), .least = 0, .most = 65535});
  v("why", r.why,
    "`true`: the answer has the key `because`; a run of one robot on the target avr only, which is not "
    "driven, and of which "
    "nothing is streamed",
    {.presence = when(r.why)});
  v("ways", r.ways,
    "the run branches: each way goes on like a run whose script ends with its lines. The answer is the first "
    "way's and has the others' under the key `ways`. Counters of the second way are written to `counters` "
    "with `.2` at its end, and so on. Only for a run of one robot on a chip that is neither driven nor "
    "streamed (else an `input` error)",
    {.otherwise = "none"});
  v("script", r.script, "text of a scenario", {.otherwise = "empty", .presence = when(!r.script.empty())});
  v("script_file", r.script_file, "its name, for messages", {.presence = when(!r.script.empty())});
  v("samples_every_ns", r.samples_every_ns,
    "how often a `sample` is sent; a multiple of the tick (1 ms); 0 = never",
    {.unit = "ns", .presence = when(r.samples_every_ns > 0), .least = 0, .multiple_of = 1'000'000});
  v("columns_every_ns", r.columns_every_ns,
    "how often a sample is taken for `columns`, which then hold all that happens at the pins, too; a "
    "multiple "
    "of the tick; 0 = there are no `columns`",
    {.unit = "ns", .presence = when(r.columns_every_ns > 0), .least = 0, .multiple_of = 1'000'000});
  v("started", r.started, "`false`: there is no `started`, for a client that waits for the answer alone",
    {.presence = when(!r.started)});
  v("batches", r.batches,
    "`true`: many `sample`, `pin`, `level`, `volts` and `byte` events come in one `batch`, some of them "
    "late; "
    "the order of all events stays. The client then makes `columns` of these",
    {.presence = when(r.batches)});
  v("interactive", r.interactive, "`true`: the client drives the run step by step (below)",
    {.presence = when(r.interactive)});
  v("source", r.source_ns,
    "`[from, to]`: `pin`, `level`, `volts` and `byte` events are sent only for this span, and have the key "
    "`source`: the line of the sketch that caused the event. For a sent byte, that is the line that printed "
    "it, however long the byte waited in the core's buffer",
    {.unit = "ns", .otherwise = "none"});
  v("stream",
    NameList{std::array{Name{"pin", &r.pins}, Name{"serial", &r.serial}, Name{"note", &r.notes},
                        Name{"io", &r.io}}},
    "which further events are sent; `\"io\"` are `level`, `volts` and `byte` events",
    {.otherwise = "none", .presence = when(r.pins || r.serial || r.notes || r.io)});
  v("name", r.name, "name of the robot, for messages, if there are several",
    {.otherwise = "none", .presence = when(!r.name.empty())});
  v("target", r.target, "target of its firmware, one that the runner supports",
    {.otherwise = "the runner's", .presence = when(!r.target.empty())});
  v("late", r.late,
    "when the sketch is late, as if its code took longer, in the order of these times; on the host only "
    "(else an `input` error)",
    {.otherwise = "never", .presence = when(!r.late.empty())});
  v("agents", r.agents, "further robots on the same map, at most 255: they are number 1, 2 … of its events",
    {.otherwise = "none", .presence = when(!r.agents.empty())});
}

/// The requests that a runner serves while no run is paused.
using Request = std::variant<DescribeRobot, RunRequest>;

}  // namespace robosim::wire
