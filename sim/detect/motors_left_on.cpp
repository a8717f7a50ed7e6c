#include "sim/detect/motors_left_on.h"

#include <fmt/format.h>

#include <cmath>

#include "sim/judge/judge.h"

namespace robosim::detect {
namespace {

constexpr double kLeftOn_m = 0.5;
constexpr double kUnchanged = 0.02;
// A sketch steers along the line only if it reads its sensors in at least this number of ticks.
constexpr int kHardlyEver = 2;

}  // namespace

void MotorsLeftOn::look(const Steering& now) {
  Stretch& stretch = state_.stretch;
  state_.reads += now.asks_floor;
  if (!now.on_its_own) {
    stretch.counts = false;
    return;
  }
  if (now.sees_line) {
    stretch = {true, now.t, now.travel_m, now.travel_m, now.left, now.right};
    return;
  }
  if (!stretch.counts) return;
  const bool same =
      std::abs(now.left - stretch.left) <= kUnchanged && std::abs(now.right - stretch.right) <= kUnchanged;
  const bool driven = now.left != 0.0 || now.right != 0.0;
  if (now.asks_floor || !same || !driven) stretch.unchanged_from_m = now.travel_m;
  stretch.left = now.left;
  stretch.right = now.right;
  if (now.travel_m - stretch.from_m < judge::kLostAfter) return;
  stretch.counts = false;
  const double on_m = now.travel_m - stretch.unchanged_from_m;
  if (state_.reads >= kHardlyEver && on_m >= kLeftOn_m && waiting_call(executor_.activity()).empty())
    tell(on_m);
}

void MotorsLeftOn::tell(double on_m) {
  if (!state_.found.empty()) {
    ++state_.found.front().times;
    return;
  }
  exec::Detected& told = state_.found.emplace_back();
  told.detector = result::detector("motors_left_on");
  told.what = fmt::format(
      "the line was gone, and the robot's wheels turned another {:.0f} mm at unchanged power, while the "
      "sketch no longer read any line sensor",
      1e3 * on_m);
  told.mend = "When the sketch stops steering, also stop the motors: they keep their last command.";
  told.first_s = 1e-9 * static_cast<double>(state_.stretch.began);
}

}  // namespace robosim::detect
