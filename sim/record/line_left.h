// Finds when a robot left the line, and which sensor saw it last.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim/wire/fields.h"

namespace robosim::record {

/// The line was left at the last sample that saw it, and found at the first that sees it again.
struct LineEvent {
  std::int64_t t_us = 0;
  std::string sensor;  ///< the sensor that saw it best
  bool left = false;   ///< else found again
};

template <class V>
void fields(V& v, wire::Same<V, LineEvent>& e) {
  v("t_us", e.t_us, "of the sample", {.unit = "µs"});
  v("sensor", e.sensor, "that saw it last, or first");
  v("left", e.left, "false: it is found again");
}

/// Examines the samples of a run as they arrive.
class LineWatch {
 public:
  /// `sensors`: names.
  LineWatch(std::vector<std::string> sensors, bool light_line)
      : names_(std::move(sensors)), light_line_(light_line), least_(names_.size()), most_(names_.size()) {}

  const std::vector<std::string>& sensors() const { return names_; }
  /// Adds the readings of all sensors: 0 light .. 1 dark.
  void add(std::int64_t t_us, const std::vector<float>& readings);
  /// Returns the events in all samples until now: the threshold of line depends on the extremes of all
  /// readings.
  std::vector<LineEvent> events() const;

 private:
  std::vector<std::string> names_;
  bool light_line_;
  std::vector<float> least_, most_;  ///< of each sensor
  std::vector<std::int64_t> t_us_;
  std::vector<float> readings_;  ///< by sample: 0 no line .. 1 line
};

}  // namespace robosim::record
