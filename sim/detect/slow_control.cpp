#include "sim/detect/slow_control.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace robosim::detect {
namespace {

constexpr double kOtherCommand = 0.005;
constexpr SimTime kLeastInterval = 20 * kMillisecond, kJitter = 2 * kMillisecond;
// Changes within this time count as one, because the motors change one after the other: each at the end of a
// period of its PWM.
constexpr SimTime kOneChange = 4 * kMillisecond;
constexpr double kJitterShare = 0.05, kLeastWay_m = 0.02, kGoodWay_m = 0.005;
constexpr int kLeastRow = 4, kLeastReads = 4, kManyLosses = 3;

/// Returns whether an interval is a multiple of another one.
bool is_multiple(SimTime interval, SimTime of) {
  const SimTime times = std::max<SimTime>(1, (interval + of / 2) / of),
                rest = std::abs(interval - times * of);
  return rest <= std::max(kJitter, static_cast<SimTime>(kJitterShare * static_cast<double>(interval)));
}

}  // namespace

SlowControl::SlowControl(exec::Executor&, SnapshotRegistry& snapshots) {
  state_.lost.times = 0;
  snapshots.add(state_);
}

void SlowControl::look(const Steering& now) {
  State& s = state_;
  s.reads += now.asks_floor;
  s.found_again |= now.sees_line;
  s.saw_line |= now.sees_line;
  if (!now.on_its_own) {
    s.shortest = 0;
    s.regular = 0;
    s.changed = now;
  } else if (std::abs(now.left - s.before.left) > kOtherCommand ||
             std::abs(now.right - s.before.right) > kOtherCommand) {
    commands_changed(now);
  }
  s.before = now;
}

void SlowControl::commands_changed(const Steering& now) {
  State& s = state_;
  const SimTime interval = now.t - s.changed.t;
  if (interval <= kOneChange) return;
  const double way = now.distance_m - s.changed.distance_m;
  const bool is_slow = interval >= kLeastInterval && s.reads >= kLeastReads;
  if (is_slow && s.shortest > 0 &&
      is_multiple(std::max(interval, s.shortest), std::min(interval, s.shortest))) {
    ++s.regular;
    s.shortest = std::min(s.shortest, interval);
  } else {
    s.regular = 0;
    s.shortest = is_slow ? interval : 0;
  }
  if (s.regular >= kLeastRow && s.saw_line && !now.sees_line && way >= kLeastWay_m) {
    if (s.lost.times == 0) {
      const double seconds = 1e-9 * static_cast<double>(s.shortest);
      const double step_m = way * static_cast<double>(s.shortest) / static_cast<double>(interval);
      s.lost = {
          result::detector("slow_control"),
          fmt::format(
              "the sensors left the line between two changes of the motors' power: the power "
              "changed only every {:.0f} ms, or {:.0f} mm, although line sensors were read {} times in "
              "between",
              1e3 * seconds, 1e3 * step_m, s.reads),
          fmt::format(
              "Compute and set the motors more often: at this speed, every {:.0f} ms. Some PID libraries "
              "compute only every 100 ms unless SetSampleTime() is called.",
              std::max(1.0, std::floor(1e3 * seconds * kGoodWay_m / step_m))),
          {},
          1e-9 * static_cast<double>(s.changed.t),
          0};
    }
    ++s.lost.times;
    s.found_again = false;
  }
  s.changed = now;
  s.saw_line = now.sees_line;
  s.reads = 0;
}

std::vector<exec::Detected> SlowControl::found(SimTime) const {
  if (state_.lost.times == 0 || (state_.found_again && state_.lost.times < kManyLosses)) return {};
  return {state_.lost};
}

}  // namespace robosim::detect
