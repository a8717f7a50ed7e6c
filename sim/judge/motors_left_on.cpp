#include "sim/judge/motors_left_on.h"

#include <fmt/format.h>

#include <cmath>

#include "sim/judge/judge.h"

namespace robosim::judge {
namespace {

constexpr double kLeftOn_m = 0.5;
constexpr double kUnchanged = 0.02;
// A sketch that reads its sensors less often than this in a run does not steer along the line.
constexpr int kHardlyEver = 2;

}  // namespace

void MotorsLeftOn::look(const Steering& now) {
  looks_ += now.asks_floor;
  if (!now.on_its_own) {
    stretch_.counts = false;
    return;
  }
  if (now.sees_line) {
    stretch_ = {true, now.t, now.travel_m, now.travel_m, now.left, now.right};
    return;
  }
  if (!stretch_.counts) return;
  const bool same =
      std::abs(now.left - stretch_.left) <= kUnchanged && std::abs(now.right - stretch_.right) <= kUnchanged;
  const bool driven = now.left != 0.0 || now.right != 0.0;
  if (now.asks_floor || !same || !driven) stretch_.unchanged_from_m = now.travel_m;
  stretch_.left = now.left;
  stretch_.right = now.right;
  if (now.travel_m - stretch_.from_m < kLostAfter) return;
  stretch_.counts = false;
  const double on_m = now.travel_m - stretch_.unchanged_from_m;
  if (looks_ >= kHardlyEver && on_m >= kLeftOn_m && waiting_call(executor_->activity()).empty()) tell(on_m);
}

void MotorsLeftOn::tell(double on_m) {
  if (!found_.empty()) {
    ++found_.front().times;
    return;
  }
  exec::Detected& told = found_.emplace_back();
  told.detector = "motors_left_on";
  told.what = fmt::format(
      "the line was gone, and the robot's wheels turned another {:.0f} mm at unchanged power, while the "
      "sketch no longer read any line sensor",
      1e3 * on_m);
  told.mend = "When the sketch stops steering, also stop the motors: they keep their last command.";
  told.first_s = 1e-9 * static_cast<double>(stretch_.began);
}

}  // namespace robosim::judge
