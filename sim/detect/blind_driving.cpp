#include "sim/detect/blind_driving.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace robosim::detect {
namespace {

constexpr double kSamePower = 0.02;
// The number of ticks that a sketch may need to convert a reading to motor commands.
constexpr int kTicksToSteer = 3;
// A sketch steers along the line only if it reads its sensors in at least this number of ticks.
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
  return "Read the sensors in this code as well, or return from loop() in between.";
}

}  // namespace

BlindDriving::BlindDriving(exec::Executor& executor, SnapshotRegistry& snapshots, double lever_m,
                           double line_m)
    : executor_(executor), most_m_(std::max(lever_m, 0.0) + line_m) {
  snapshots.add(state_);
}

void BlindDriving::look(const Steering& now) {
  Stretch& stretch = state_.stretch;
  if (now.asks_floor || !now.on_its_own) {
    state_.reads += now.asks_floor;
    if (now.on_its_own) state_.end(now);
    stretch = {now.t, now.distance_m, now.sees_line, false, 0.0, 0.0, 0, false, {}};
  } else if (stretch.ticks++; stretch.ticks <= kTicksToSteer) {
    stretch.left = now.left;
    stretch.right = now.right;
  } else {
    stretch.planned |=
        std::abs(now.left - stretch.left) > kSamePower || std::abs(now.right - stretch.right) > kSamePower;
    const bool is_driven =
        std::abs(now.left) > kSamePower || std::abs(now.right) > kSamePower;  // it does not coast
    const bool is_too_long = stretch.saw_line && is_driven && !stretch.planned && !now.sees_line &&
                             now.distance_m - stretch.from_m > most_m_;
    if (is_too_long && !stretch.is_too_long) {
      stretch.busy = executor_.activity();
      // A call that did not last for most of the stretch is not the reason.
      if (2 * (now.t - stretch.busy.last_call) < now.t - stretch.began) stretch.busy.call.clear();
    }
    stretch.is_too_long |= is_too_long;
  }
  state_.before = now;
}

void BlindDriving::State::end(const Steering& now) {
  if (!stretch.is_too_long || stretch.planned || now.sees_line || reads < kFewLooks) return;
  const exec::Detected here = told(now);
  const auto known = std::find_if(found.begin(), found.end(), [&](const exec::Detected& other) {
    return other.where.file == here.where.file && other.where.line == here.where.line;
  });
  if (known != found.end()) {
    ++known->times;
  } else if (found.size() < kMostPlaces) {
    found.push_back(here);
  }
}

exec::Detected BlindDriving::State::told(const Steering& now) const {
  const double seconds = 1e-9 * static_cast<double>(now.t - stretch.began);
  const std::string call = waiting_call(stretch.busy);
  exec::Detected told;
  told.detector = result::detector("blind");
  told.where = stretch.busy.where;
  told.first_s = 1e-9 * static_cast<double>(stretch.began);
  told.what = fmt::format(
      "the robot drove {:.0f} mm ({:.2f} s) without reading a line sensor, and the sensors left the line{}",
      1e3 * (now.distance_m - stretch.from_m), seconds, call.empty() ? "" : ": the sketch was in " + call);
  told.mend = mend_for(call);
  return told;
}

std::vector<exec::Detected> BlindDriving::found(SimTime) const {
  State all = state_;
  all.end(all.before);
  return all.found;
}

}  // namespace robosim::detect
