// When a robot left the line, and which sensor saw it last: what everybody asks first.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim/wire/fields.h"

namespace robosim::record {

/// It was left at the last sample that saw it, and found at the first that does again.
struct LineEvent {
  std::int64_t t_us = 0;
  std::string sensor;  ///< that saw it then, best of all
  bool left = false;   ///< else found again
};

template <class V>
void fields(V& v, wire::Same<V, LineEvent>& e) {
  v("t_us", e.t_us, "of the sample", {.unit = "µs"});
  v("sensor", e.sensor, "that saw it last, or first");
  v("left", e.left, "false: it is found again");
}

/// What one line sensor read in each sample: 0 light .. 1 dark.
struct SensorReadings {
  std::string name;
  std::vector<double> values;
};

/// `t_us`: of the samples.
std::vector<LineEvent> line_events(const std::vector<double>& t_us, std::vector<SensorReadings> sensors,
                                   bool light_line);

}  // namespace robosim::record
