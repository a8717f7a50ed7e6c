#include "sim/record/line_left.h"

#include <algorithm>
#include <limits>
#include <optional>

namespace robosim::record {
namespace {

// The robot has left the line if no sensor has seen the line for this duration. Crossing a gap in the line
// takes less time.
constexpr std::int64_t kLeft_us = 20'000;
// Each sensor has its own range of readings. A sensor sees the line if its reading exceeds the smallest
// reading by more than kBegins of the range. If the range is kSpread or less, the sensor saw the line during
// the whole run, or never: its smallest reading is then compared with kAlways.
constexpr float kSpread = 0.2f, kBegins = 0.1f, kAlways = 0.5f;

/// Returns the reading above which a sensor sees the line.
float threshold(float least, float most) {
  const float spread = most - least;
  if (spread > kSpread) return least + kBegins * spread;
  return least > kAlways ? kAlways : std::numeric_limits<float>::infinity();
}

}  // namespace

void LineWatch::add(std::int64_t t_us, const std::vector<float>& readings) {
  for (std::size_t k = 0; k < names_.size(); ++k) {
    const float reading = light_line_ ? 1.0f - readings[k] : readings[k];
    least_[k] = t_us_.empty() ? reading : std::min(least_[k], reading);
    most_[k] = t_us_.empty() ? reading : std::max(most_[k], reading);
    readings_.push_back(reading);
  }
  t_us_.push_back(t_us);
}

std::vector<LineEvent> LineWatch::events() const {
  std::vector<float> from;
  for (std::size_t k = 0; k < names_.size(); ++k) from.push_back(threshold(least_[k], most_[k]));
  const float* of_sample = readings_.data();
  const auto sees = [&](std::size_t k) { return of_sample[k] > from[k]; };
  const auto best_of = [&](std::size_t sample) {
    of_sample = readings_.data() + sample * names_.size();
    std::size_t best = names_.size();
    for (std::size_t k = 0; k < names_.size(); ++k)
      if (sees(k) && (best == names_.size() || of_sample[k] > of_sample[best])) best = k;
    return names_[best];
  };

  std::vector<LineEvent> events;
  bool left = false;
  std::optional<std::size_t> last;  // the last sample that saw the line
  std::size_t by = 0;               // a sensor that sees the line in the current sample
  for (std::size_t i = 0; i < t_us_.size(); ++i) {
    of_sample = readings_.data() + i * names_.size();
    if (!(by < names_.size() && sees(by)))
      for (by = 0; by < names_.size() && !sees(by);) ++by;
    if (by < names_.size()) {
      if (left) events.push_back({t_us_[i], best_of(i), false});
      left = false;
      last = i;
    } else if (!left && last && t_us_[i] - t_us_[*last] > kLeft_us) {
      left = true;
      events.push_back({t_us_[*last], best_of(*last), true});
    }
  }
  return events;
}

}  // namespace robosim::record
