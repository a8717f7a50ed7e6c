// Defines the requests to an idle runner. They ask for a robot's description, or for a run.
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
  v("robot", d.robot, "name of a stock robot, or path; `@BOARD` at its end selects another board",
    {.not_empty = true});
  v("full", d.full, "`true`: the answer has the key `text`", {.presence = when(d.full)});
}

/// A further robot of a simulation. RunRequest has the settings that are missing here.
struct AgentRequest {
  std::string name;    ///< for messages
  std::string target;  ///< target of the firmware; empty = the runner's target
  std::string image;   ///< RunRequest explains this and the following members
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
    "target of its firmware: `\"host\"`, `\"avr\"` or `\"stm32\"`; the runner must support it",
    {.otherwise = "the runner's", .presence = when(!a.target.empty())});
  v("image", a.image, "path of the firmware image", {.not_empty = true});
  v("robot", a.robot, "name of a stock robot, or path", {.not_empty = true});
  v("start", a.start, "the start: `\"X,Y,DIR\"`",
    {.otherwise = "the map's", .presence = when(!a.start.empty())});
  v("goal", a.goal, "the goal, as on the command line",
    {.otherwise = "the map's", .presence = when(!a.goal.empty())});
  v("clock_ns", a.clock_ns, "initial value of the firmware's clock; chip targets only",
    {.unit = "ns", .presence = when(a.clock_ns > 0), .least = 0});
  v("script", a.script, "text of a scenario", {.otherwise = "empty", .presence = when(!a.script.empty())});
  v("script_file", a.script_file, "name of the script, for messages", {.presence = when(!a.script.empty())});
  v("late", a.late, "delays of the sketch", {.otherwise = "never", .presence = when(!a.late.empty())});
}

/// The point at which a run branches. From there, the run continues in several ways from the same state.
struct Ways {
  std::int64_t at_ns = 0;            ///< time since power-on, a multiple of 1 ms; unused if `after` is set
  std::string after;                 ///< the run branches when the sketch has sent this text; "" = at_ns
  std::vector<std::string> scripts;  ///< for each way, the lines that follow the common script
};

template <class V>
void fields(V& v, Same<V, Ways>& w) {
  v("at_ns", w.at_ns,
    "time at which the run branches, unless `after` is given; a multiple of the tick (1 ms)",
    {.unit = "ns", .presence = kOptional, .least = 0, .multiple_of = 1'000'000});
  v("after", w.after, "the run branches when the sketch has sent this text",
    {.otherwise = "at `at_ns`", .presence = when(!w.after.empty())});
  v("scripts", w.scripts,
    "for each of 1 to 64 ways, the lines that follow the common script. No line may be due before the run "
    "branches; lines may await the text of `after`");
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
  std::vector<Lateness> late;          ///< delays, sorted by time; on the host only
  int gdb_port = 0;                    ///< port to which a debugger connects; 0 = none; chip targets only
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
  std::string counters;              ///< file for how often each line of the sketch ran; empty = none
  std::optional<Ways> ways;          ///< where the run branches; chip targets only
  std::string name;                  ///< name of the first robot, if there are several
  std::string target;                ///< target of the first of several robots; empty = the runner's
  std::vector<AgentRequest> agents;  ///< further robots: number 1, 2 …
};

template <class V>
void fields(V& v, Same<V, RunRequest>& r) {
  v("image", r.image, "path of the firmware image", {.not_empty = true});
  v("map", r.map, "path of the map's file", {.not_empty = true});
  v("robot", r.robot, "name of a stock robot, or path", {.not_empty = true});
  v("start", r.start, "the start: `\"X,Y,DIR\"`",
    {.otherwise = "the map's", .presence = when(!r.start.empty())});
  v("goal", r.goal, "the goal, as on the command line",
    {.otherwise = "the map's", .presence = when(!r.goal.empty())});
  v("for_ns", r.for_ns, "maximum simulated time", {.unit = "ns", .presence = kOptional, .least = 0});
  v("seed", r.seed, "seed of the noise", {.presence = kOptional});
  v("profile", r.profile, "how realistic the robot's parts are",
    {.presence = kOptional, .one_of = kProfileNames});
  v("clock_ns", r.clock_ns, "initial value of the firmware's clock; chip targets only",
    {.unit = "ns", .presence = when(r.clock_ns > 0), .least = 0});
  v("counters", r.counters,
    "file to which the runner writes how often each line ran (`sim/base/archive.h`), at the end; on the "
    "host, only for an image that was built for coverage",
    {.otherwise = "none", .presence = when(!r.counters.empty())});
  v("detect", r.detect, "`true`: [detectors](../howto/sanitizers.md#detectors) watch the sketches",
    {.presence = when(r.detect)});
  v("gdb_port", r.gdb_port,
    "port of 127.0.0.1 on which the run waits for gdb before the first instruction; 0 = none; chip targets "
    "only (else an `input` error)",
    {.presence = when(r.gdb_port > 0), .least = 0, .most = 65535});
  v("why", r.why,
    "`true`: the answer has the key `because`; only for a run of one robot on the target `avr` that is "
    "neither driven nor streamed",
    {.presence = when(r.why)});
  v("ways", r.ways,
    "the run branches: each way continues like a run whose script ends with the way's lines. The answer is "
    "the first way's result; its key `ways` has the other results. The second way's counters are written to "
    "the path in `counters`, followed by `.2`, and so on. Only for a run of one robot on a chip that is "
    "neither driven nor streamed (else an `input` error)",
    {.otherwise = "none"});
  v("script", r.script, "text of a scenario", {.otherwise = "empty", .presence = when(!r.script.empty())});
  v("script_file", r.script_file, "name of the script, for messages", {.presence = when(!r.script.empty())});
  v("samples_every_ns", r.samples_every_ns,
    "how often a `sample` is sent; a multiple of the tick (1 ms); 0 = never",
    {.unit = "ns", .presence = when(r.samples_every_ns > 0), .least = 0, .multiple_of = 1'000'000});
  v("columns_every_ns", r.columns_every_ns,
    "how often a sample is added to the `columns`, which also contain all events at the pins; a multiple of "
    "the tick; 0 = no `columns`",
    {.unit = "ns", .presence = when(r.columns_every_ns > 0), .least = 0, .multiple_of = 1'000'000});
  v("started", r.started, "`false`: no `started` event is sent; for clients that only wait for the answer",
    {.presence = when(!r.started)});
  v("batches", r.batches,
    "`true`: many `sample`, `pin`, `level`, `volts` and `byte` events come in one `batch`, some of them with "
    "a delay; the order of all events stays. The client then computes the `columns` from these events",
    {.presence = when(r.batches)});
  v("interactive", r.interactive, "`true`: the client drives the run step by step (below)",
    {.presence = when(r.interactive)});
  v("source", r.source_ns,
    "`[from, to]`: `pin`, `level`, `volts` and `byte` events are sent only for this time span. Their key "
    "`source` is the line of the sketch that caused the event. For a sent byte, this is the line that "
    "printed it, however long the byte waited in the core's buffer",
    {.unit = "ns", .otherwise = "none"});
  v("stream",
    NameList{std::array{Name{"pin", &r.pins}, Name{"serial", &r.serial}, Name{"note", &r.notes},
                        Name{"io", &r.io}}},
    "which further events are sent; `\"io\"` are `level`, `volts` and `byte` events",
    {.otherwise = "none", .presence = when(r.pins || r.serial || r.notes || r.io)});
  v("name", r.name, "name of the robot, for messages, if there are several",
    {.otherwise = "none", .presence = when(!r.name.empty())});
  v("target", r.target, "target of the firmware; the runner must support it",
    {.otherwise = "the runner's", .presence = when(!r.target.empty())});
  v("late", r.late,
    "delays of the sketch, as if its code took longer, sorted by time; on the host only (else an `input` "
    "error)",
    {.otherwise = "never", .presence = when(!r.late.empty())});
  v("agents", r.agents,
    "further robots on the same map, at most 255; in events, they have the numbers 1, 2 …",
    {.otherwise = "none", .presence = when(!r.agents.empty())});
}

/// The requests that a runner serves while no run is paused.
using Request = std::variant<DescribeRobot, RunRequest>;

}  // namespace robosim::wire
