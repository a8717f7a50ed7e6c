// Describes the header of a recording, as JSON. docs/reference/recordings.md describes the whole format.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/record/floor_shapes.h"
#include "sim/record/line_left.h"
#include "sim/wire/messages.h"

namespace robosim::record {

/// The first line of a recording's file.
inline constexpr const char* kRecordingMagic = "robosim.rec/1\n";

/// Returns whether a file begins like a recording, of any version.
inline bool is_recording(std::string_view content) { return content.starts_with("robosim.rec/"); }

/// One column of a stream. Its bytes follow those of the previous columns.
struct ColumnInfo {
  std::string name;
  double scale = 1.0;  ///< divisor of the stored integers
  int order = 1;       ///< encoding of the integers (sim/wire/columns.h); 0 = raw bytes (text)
  std::int64_t bytes = 0;
};

/// Rows with the same columns: samples, changes of a pin …
struct StreamInfo {
  std::string name;        ///< "samples", "pin D5", "volts A0", "serial"
  std::int64_t count = 0;  ///< number of rows
  std::vector<ColumnInfo> columns;
};

/// The recorded data of one robot.
struct RobotRecord {
  std::string name;  ///< empty if there is only one robot
  std::string sketch, robot, target;
  std::string script;  ///< the scenario: events from outside the robot
  wire::RobotInfo robot_info;
  std::vector<std::string> pins;  ///< names of the board's pins, by number
  wire::Started started;
  result::RunResult result;
  std::vector<LineEvent> line;  ///< when the robot left the line, and found it again
  /// Lines of the sketch that drove pins. The column `source` of a pin's stream contains indices of this
  /// list, from 1.
  std::vector<result::SourceLine> sources;
  /// Only the last change of a pin or voltage in each span of this length is stored; 0 = every change.
  std::int64_t thinned_ns = 0;
  std::vector<StreamInfo> streams;
};

/// Describes the run, and its first robot.
struct RecordingHeader : RobotRecord {
  std::string robosim;  ///< version of Robosim that wrote the recording
  std::string map;
  std::string map_text;  ///< empty, like `floor`, if the map is too large
  std::optional<FloorShapes> floor;
  std::vector<wire::Note> notes;    ///< notes about all robots
  std::vector<RobotRecord> others;  ///< further robots, in the order of their numbers

  std::size_t robot_count() const { return 1 + others.size(); }
  const RobotRecord& of(std::size_t number) const { return number == 0 ? *this : others.at(number - 1); }
};

template <class V>
void fields(V& v, result::Same<V, ColumnInfo>& c) {
  v("name", c.name, "column name, with its unit");
  v("scale", c.scale, "divisor of the stored integers");
  v("order", c.order, "order of the stored differences", {.least = 0, .most = 2});
  v("bytes", c.bytes, "size in the file", {.least = 0});
}

template <class V>
void fields(V& v, result::Same<V, StreamInfo>& s) {
  v("name", s.name, "name of the stream");
  v("count", s.count, "number of rows", {.least = 0});
  v("columns", s.columns, "in the order of their bytes");
}

template <class V>
void fields(V& v, result::Same<V, RobotRecord>& r) {
  v("name", r.name, "the robot's name, if there are several", {.presence = result::when(!r.name.empty())});
  v("sketch", r.sketch, "as the user named it");
  v("robot", r.robot, "as the user named it");
  v("target", r.target, "host, avr or stm32");
  v("script", r.script, "text of the scenario");
  v("robot_info", r.robot_info, "the answer to `describe_robot`");
  v("pins", r.pins, "names of the board's pins, by number");
  v("started", r.started, "the event `started`");
  v("result", r.result, "result of the run");
  v("line", r.line, "when the line was left, and found again", {.presence = result::when(!r.line.empty())});
  v("sources", r.sources, "lines of the sketch that drove pins",
    {.presence = result::when(!r.sources.empty())});
  v("thinned_ns", r.thinned_ns, "span of which only the last change is stored; 0 = every change",
    {.presence = result::kOptional});
  v("streams", r.streams, "streams that follow the header");
}

template <class V>
void fields(V& v, result::Same<V, RecordingHeader>& h) {
  v("robosim", h.robosim, "version of Robosim");
  v("map", h.map, "as the user named it");
  v("map_text", h.map_text, "the map's file");
  v("floor", h.floor, "geometry of the map");
  v("notes", h.notes, "notes about all robots");
  fields(v, static_cast<result::Same<V, RobotRecord>&>(h));
  v("others", h.others, "further robots", {.presence = result::when(!h.others.empty())});
}

}  // namespace robosim::record
