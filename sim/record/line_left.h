// Finds when a robot left the line, and which sensor was the last to see it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim/result/fields.h"

namespace robosim::record {

/// Records that the robot left the line, or found it again. The time is the time of the last sample that saw
/// the line, or of the first sample that sees it again.
struct LineEvent {
  std::int64_t t_us = 0;
  std::string sensor;  ///< the sensor that saw the line best
  bool left = false;   ///< false: found again
};

template <class V>
void fields(V& v, result::Same<V, LineEvent>& e) {
  v("t_us", e.t_us, "time of the sample", {.unit = "µs"});
  v("sensor", e.sensor, "the sensor that saw the line last, or first");
  v("left", e.left, "false: the line is found again");
}

/// Collects the samples of a run as they arrive, and finds the events in them.
class LineWatch {
 public:
  /// `sensors` are the sensors' names.
  LineWatch(std::vector<std::string> sensors, bool light_line)
      : names_(std::move(sensors)), light_line_(light_line), least_(names_.size()), most_(names_.size()) {}

  const std::vector<std::string>& sensors() const { return names_; }
  /// Adds the readings of all sensors: 0 light .. 1 dark.
  void add(std::int64_t t_us, const std::vector<float>& readings);
  /// Returns the events in all samples so far. The threshold of each sensor depends on the extremes of all
  /// its readings.
  std::vector<LineEvent> events() const;

 private:
  std::vector<std::string> names_;
  bool light_line_;
  std::vector<float> least_, most_;  ///< per sensor
  std::vector<std::int64_t> t_us_;
  std::vector<float> readings_;  ///< sample by sample: 0 no line .. 1 line
};

}  // namespace robosim::record
