#include "sim/record/line_left.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

namespace robosim::record {
namespace {

// The line counts as left when no sensor has seen it for so long: a gap that is just crossed does not.
constexpr double kLeft_us = 20'000;
// Each sensor has its own idea of the floor, so the line begins a tenth above the least that it ever read.
// One that always reads the same was over the line throughout, or never.
constexpr double kSpread = 0.2, kBegins = 0.1, kAlways = 0.5;

/// Above it a sensor sees line.
double threshold(const std::vector<double>& values) {
  const double least = *std::min_element(values.begin(), values.end());
  const double spread = *std::max_element(values.begin(), values.end()) - least;
  if (spread > kSpread) return least + kBegins * spread;
  return least > kAlways ? kAlways : std::numeric_limits<double>::infinity();
}

}  // namespace

std::vector<LineEvent> line_events(const std::vector<double>& t_us, std::vector<SensorReadings> sensors,
                                   bool light_line) {
  std::vector<LineEvent> events;
  if (t_us.empty()) return events;
  std::vector<double> from;
  for (SensorReadings& sensor : sensors) {
    if (light_line)
      for (double& value : sensor.values) value = 1.0 - value;
    from.push_back(threshold(sensor.values));
  }
  bool left = false;
  std::optional<std::size_t> last;
  const SensorReadings* by = nullptr;
  for (std::size_t i = 0; i < t_us.size(); ++i) {
    const SensorReadings* best = nullptr;
    for (std::size_t k = 0; k < sensors.size(); ++k)
      if (sensors[k].values[i] > from[k] && (!best || sensors[k].values[i] > best->values[i]))
        best = &sensors[k];
    if (best) {
      if (left) events.push_back({static_cast<std::int64_t>(t_us[i]), best->name, false});
      left = false;
      last = i;
      by = best;
    } else if (!left && last && t_us[i] - t_us[*last] > kLeft_us) {
      left = true;
      events.push_back({static_cast<std::int64_t>(t_us[*last]), by->name, true});
    }
  }
  return events;
}

}  // namespace robosim::record
