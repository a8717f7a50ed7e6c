// Records a run up to its present time. A Drive is a view of a part of this record.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "robosim/testing/simulation.h"
#include "sim/wire/messages.h"

namespace robosim::testing {

struct RunLog {
  struct Entry {
    std::int64_t t_ns = 0;
    std::string text;
    bool collision = false;  ///< the entry is a collision
  };
  /// The part of a run between two pauses.
  struct Leg {
    std::int64_t begin_ns = 0, end_ns = 0;
    double worst_mm = 0.0;
    std::int64_t worst_ns = 0;
    double worst_x_mm = 0.0, worst_y_mm = 0.0;
    result::Metrics at_end;
  };
  struct Said {
    std::int64_t t_ns = 0;
    std::size_t end = 0;  ///< length of `serial` at t_ns
  };

  Trial trial;
  std::string name;  ///< name of the robot if there are several; else empty
  std::string sketch_name, map_name, robot_name;
  wire::Started started;
  std::vector<wire::Sample> samples;  ///< every 10 ms and at each pause; no moment twice
  std::vector<Leg> legs;
  std::string serial;
  std::vector<Said> said;
  std::vector<Entry> events;  ///< actions, notes and the sketch's output
  std::vector<bool> is_line_sensor;
  bool has_light_line = false;  ///< the map's line is white, and its floor black
  std::optional<result::Resources> resources;
  std::optional<result::RunResult> result;
  std::string replay;                  ///< the command without its duration
  std::string artifacts;               ///< the folder that is saved if the test fails; "" = none
  mutable bool verdict_asked = false;  ///< the test has checked the verdict, or waits for it

  /// Inserts an entry at its time. Notes of a tick arrive at the tick's end, after the sketch's output in
  /// that tick.
  void add(Entry entry);
};

/// Converts a sample to a Moment for tests.
Moment moment_of(const RunLog& log, const wire::Sample& sample);
/// Returns "12.34 s".
std::string seconds(std::int64_t ns);
std::string seconds(Duration time);
/// Returns "column 5, row 2 (x 512 mm, y 340 mm)".
std::string place_of(const Pose& pose);
/// Returns the text on one line: replaces each line feed by \n and each carriage return by \r.
std::string on_one_line(const std::string& text);
/// Returns `text` in double quotes, with line ends and similar characters escaped.
std::string in_quotes(const std::string& text);

}  // namespace robosim::testing
