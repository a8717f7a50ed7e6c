#include "sim/judge/blind_driving.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace robosim::judge {
namespace {

constexpr double kSamePower = 0.02;
// The number of ticks within which a sketch converts a reading to motor commands.
constexpr int kTicksToSteer = 3;
// A sketch that reads its sensors less often than this in a run does not steer along the line.
constexpr int kFewLooks = 2;
constexpr std::size_t kMostPlaces = 8;

std::string mend_for(const std::string& call) {
  const auto is = [&](const char* name) { return call.starts_with(name); };
  if (is("delay"))
    return "Return from loop() and check with millis() whether the time has passed, instead of calling "
           "delay().";
  if (is("pulseIn"))
    return "Give pulseIn() a timeout, its third argument, no longer than the echo of the greatest distance "
           "of interest.";
  if (is("write") || is("print") || is("flush") || is("Serial")) return kPrintLess;
  return "Read the sensors in there as well, or return from loop() in between.";
}

}  // namespace

BlindDriving::BlindDriving(exec::Executor& executor, double lever_m, double line_m)
    : executor_(&executor), most_m_(std::max(lever_m, 0.0) + line_m) {}

void BlindDriving::look(const Steering& now) {
  if (now.asks_floor || !now.on_its_own) {
    looks_ += now.asks_floor;
    if (now.on_its_own) end(now);
    stretch_ = {now.t, now.distance_m, now.sees_line, false, 0.0, 0.0, 0, false, {}};
  } else if (stretch_.ticks++; stretch_.ticks <= kTicksToSteer) {
    stretch_.left = now.left;
    stretch_.right = now.right;
  } else {
    stretch_.planned |=
        std::abs(now.left - stretch_.left) > kSamePower || std::abs(now.right - stretch_.right) > kSamePower;
    const bool is_too_long = stretch_.saw_line && !stretch_.planned && !now.sees_line &&
                             now.distance_m - stretch_.from_m > most_m_;
    if (is_too_long && !stretch_.is_too_long) stretch_.busy = executor_->activity();
    stretch_.is_too_long |= is_too_long;
  }
  before_ = now;
}

void BlindDriving::end(const Steering& now) {
  if (!stretch_.is_too_long || stretch_.planned || now.sees_line || looks_ < kFewLooks) return;
  const exec::Detected here = told(now);
  const auto known = std::find_if(found_.begin(), found_.end(), [&](const exec::Detected& other) {
    return other.where.file == here.where.file && other.where.line == here.where.line;
  });
  if (known != found_.end()) {
    ++known->times;
  } else if (found_.size() < kMostPlaces) {
    found_.push_back(here);
  }
}

exec::Detected BlindDriving::told(const Steering& now) const {
  const double seconds = 1e-9 * static_cast<double>(now.t - stretch_.began);
  const std::string call = waiting_call(stretch_.busy);
  exec::Detected told;
  told.detector = "blind";
  told.where = stretch_.busy.where;
  told.first_s = 1e-9 * static_cast<double>(stretch_.began);
  told.what = fmt::format(
      "the robot drove {:.0f} mm ({:.2f} s) without reading a line sensor, and the line went out from under "
      "the sensors{}",
      1e3 * (now.distance_m - stretch_.from_m), seconds, call.empty() ? "" : ": the sketch was in " + call);
  told.mend = mend_for(call);
  return told;
}

std::vector<exec::Detected> BlindDriving::found() const {
  BlindDriving all = *this;
  all.end(before_);
  return all.found_;
}

}  // namespace robosim::judge
