#include "sim/campaign/calibrate/tape_crossings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/base/error.h"
#include "sim/robot/parts/encoder.h"

namespace robosim::calibrate {
namespace {

constexpr double kCodes = 1024.0;           // number of codes of analogRead() on all boards
constexpr double kTapeShare = 0.03;         // minimum share of a sweep's readings over the tape
constexpr double kMostSaturated = 0.3;      // maximum share of saturated readings, over floor or over tape
constexpr double kLeastContrast = 0.03;     // minimum range of readings, as a share of the converter's range
constexpr double kMostDisagreement = 0.35;  // maximum relative error of the tape's width from wheel counts

/// Converts a reading to a signal. `late` is the mean delay in us until the sketch notices that a pin is low.
double signal(double reading, const robot::ReflectanceSpec& part, double supply, double late) {
  if (part.read == robot::ReflectanceSpec::Read::rc) return 1e6 / std::max(reading - late, 1.0);
  return (reading + 0.5) * supply / kCodes;
}

bool black_is_more(const robot::ReflectanceSpec& part) {
  return part.read != robot::ReflectanceSpec::Read::rc && part.black_high;
}

/// Returns the slope of y over t for the samples `first` to `last`.
double slope(const std::vector<double>& t, const std::vector<double>& y, std::size_t first,
             std::size_t last) {
  double n = 0.0, st = 0.0, sy = 0.0, stt = 0.0, sty = 0.0;
  for (std::size_t i = first; i <= last; ++i) {
    const double dt = t[i] - t[first];
    n += 1.0;
    st += dt;
    sy += y[i];
    stt += dt * dt;
    sty += dt * y[i];
  }
  return (n * sty - st * sy) / (n * stt - st * st);
}

const robot::EncoderSpec* encoder_of(const robot::Description& robot, int side) {
  for (const auto& part : robot.parts)
    if (const auto* encoder = dynamic_cast<const robot::EncoderSpec*>(part.get());
        encoder && encoder->wheel == side)
      return encoder;
  return nullptr;
}

}  // namespace

Trace make_trace(const Log& log, const Sweep& sweep, std::size_t column, const robot::ReflectanceSpec& part,
                 std::size_t element, const robot::Description& robot) {
  Trace trace{&sweep, &log.file, {}, {}, 0.0, 0.0, 0.0};
  const bool rc = part.read == robot::ReflectanceSpec::Read::rc;
  const double supply = robot.board->supply_volts;
  if (!rc) trace.step = supply / kCodes;
  if (rc) trace.timing = log.timing_step;
  for (std::size_t i = 0; i < sweep.t.size(); ++i) {
    const double reading = sweep.readings[column][i];
    if (!rc && reading > kCodes - 1.0)
      throw InputError({log.file, sweep.lines[i]},
                       fmt::format("{}: expected a code of analogRead() from 0 to 1023, got {}",
                                   sweep.names[column], reading));
    trace.y.push_back(signal(reading, part, supply, 0.5e6 * trace.timing));
  }
  const robot::EncoderSpec* encoders[2] = {encoder_of(robot, 0), encoder_of(robot, 1)};
  if (!sweep.counted || !encoders[0] || !encoders[1] || !log.counts_per_period) return trace;
  double path[2][2] = {};  // m, of each wheel, at the beginning and the end
  const double radius = 0.5 * robot.chassis.wheel.value;
  const auto travelled = [&](std::size_t side, std::size_t i) {
    return sweep.count[side][i] / (encoders[side]->periods * *log.counts_per_period) * 2.0 *
           std::numbers::pi * radius;
  };
  for (std::size_t i = 0; i < sweep.t.size(); ++i)
    trace.angle.push_back((travelled(1, i) - travelled(0, i)) / robot.chassis.track.value);
  for (const std::size_t side : {0u, 1u}) {
    path[side][0] = travelled(side, 0);
    path[side][1] = travelled(side, sweep.t.size() - 1);
  }
  const double left = path[0][1] - path[0][0], right = path[1][1] - path[1][0];
  if (std::fabs(right - left) < 1.0 * robot.chassis.track.value)
    throw InputError(
        {log.file, sweep.line},
        fmt::format("the wheels turn too little in this sweep: expected at least a sixth of a turn, got "
                    "{:.0f} and {:.0f} counts; check whether each motor turns and each encoder counts",
                    sweep.count[0].back() - sweep.count[0].front(),
                    sweep.count[1].back() - sweep.count[1].front()));
  // The robot turns about the stationary point of the axle. `centre` is that point's distance to the right of
  // the axle's middle; it is negative in a left turn.
  const double centre = 0.5 * robot.chassis.track.value * (left + right) / (left - right);
  const Vec2 at = part.elements[element].at;
  trace.radius = std::hypot(at.x, at.y + centre);
  return trace;
}

Levels rough_levels(const Trace& trace, const std::string& name, const robot::ReflectanceSpec& part) {
  std::vector<double> sorted = trace.y;
  std::sort(sorted.begin(), sorted.end());
  const double sign = black_is_more(part) ? 1.0 : -1.0;
  const auto at = [&](double share) {  // 0 = whitest, 1 = blackest
    const double place = sign > 0.0 ? share : 1.0 - share;
    return sorted[static_cast<std::size_t>(place * static_cast<double>(sorted.size() - 1))];
  };
  const Place place{*trace.file, trace.sweep->line};
  const Levels levels{at(0.5), at(1.0 - kTapeShare)};
  const double range = sorted.back() - sorted.front();
  const double whole = trace.step > 0.0 ? kCodes * trace.step : std::max(sorted.back(), 1.0);
  if (range < kLeastContrast * whole)
    throw InputError(
        place,
        fmt::format(
            "{}: expected readings over floor and tape, got nearly the same value throughout this sweep",
            name));
  if (std::fabs(levels.black - levels.white) < 0.5 * range && std::fabs(at(0.0) - levels.white) > 0.7 * range)
    throw InputError(
        place, fmt::format("{} reads {} over the tape than next to it, but by this robot file, a sensor "
                           "reads {} over black; check that the tape is black and the floor white",
                           name, sign > 0.0 ? "less" : "more", sign > 0.0 ? "more" : "less"));
  if (std::fabs(levels.black - levels.white) < 0.5 * range)
    throw InputError(
        place, fmt::format("{} is over the tape in less than {:.0f} % of this sweep; check that it crosses "
                           "the tape",
                           name, 100.0 * kTapeShare));
  if (trace.step == 0.0) return levels;
  const double half = 0.5 * (levels.white + levels.black);
  double over[2] = {}, at_end[2] = {};
  for (const double y : trace.y) {
    const std::size_t dark = (y - half) * sign > 0.0;
    over[dark] += 1.0;
    at_end[dark] += y < trace.step || y > (kCodes - 1.0) * trace.step;
  }
  for (const std::size_t dark : {0u, 1u})
    if (at_end[dark] > kMostSaturated * over[dark])
      throw InputError(
          place, fmt::format("{0} reads {1} in {2:.0f} % of its readings over the {3}: the sensor is "
                             "saturated there, so that it does not show how {4} the {3} is",
                             name, (dark == 1) == (sign > 0.0) ? 1023 : 0, 100.0 * at_end[dark] / over[dark],
                             dark ? "tape" : "floor", dark ? "dark" : "bright"));
  return levels;
}

std::vector<Crossing> find_crossings(const Trace& trace, const std::string& name, const Levels& levels,
                                     double tape_m) {
  const std::vector<double>& t = trace.sweep->t;
  std::vector<Crossing> found;
  const auto dark = [&](std::size_t i) {
    return (trace.y[i] - levels.white) / (levels.black - levels.white);
  };
  const auto half_at = [&](std::size_t i) {  // time of half depth, between the samples i - 1 and i
    const double before = dark(i - 1), after = dark(i);
    const double share = after == before ? 0.5 : (0.5 - before) / (after - before);
    return t[i - 1] + std::clamp(share, 0.0, 1.0) * (t[i] - t[i - 1]);
  };
  bool inside = false, seen_white = false;
  Crossing now;
  for (std::size_t i = 1; i < t.size(); ++i) {
    seen_white = seen_white || dark(i) < 0.3;
    if (!inside && seen_white && dark(i) >= 0.5 && dark(i - 1) < 0.5) {
      inside = true;
      now = {half_at(i), 0.0, i, i, 0.0};
    } else if (inside && dark(i) < 0.5 && dark(i - 1) >= 0.5) {
      now.leaves = half_at(i);
      now.last = i - 1;
      inside = false;
      const double duration = now.leaves - now.enters;
      if (now.last < now.first + 4) continue;  // too few readings: a spot, or noise
      if (now.enters - 0.5 * duration < t.front() || now.leaves + 0.5 * duration > t.back()) continue;
      found.push_back(now);
    }
  }
  const Place place{*trace.file, trace.sweep->line};
  if (found.empty())
    throw InputError(
        place,
        fmt::format("{} never crosses the tape completely in this sweep: expected floor, tape and floor, "
                    "with at least 5 readings on the tape",
                    name));
  double seen = 0.0;
  for (Crossing& crossing : found) {
    const double duration = crossing.leaves - crossing.enters;
    crossing.speed = tape_m / duration;
    if (trace.angle.empty()) continue;
    std::size_t first = crossing.first, last = crossing.last;
    while (first > 0 && t[first - 1] > crossing.enters - duration) --first;
    while (last + 1 < t.size() && t[last + 1] < crossing.leaves + duration) ++last;
    const double width = std::fabs(slope(t, trace.angle, first, last)) * trace.radius * duration;
    seen += width / static_cast<double>(found.size());
    // An implausible width means that the wheels stopped for a moment. In this case, the speed stays tape_m /
    // duration.
    if (width > 0.5 * tape_m && width < 2.0 * tape_m) crossing.speed = width / duration;
  }
  if (!trace.angle.empty() && std::fabs(seen / tape_m - 1.0) > kMostDisagreement)
    throw InputError(
        place,
        fmt::format("{}: expected a tape {:.1f} mm wide by --tape, got {:.1f} mm by the wheels' counts; "
                    "check --tape and, in the robot file, the encoders' periods, wheel, track and the "
                    "sensor's place",
                    name, 1e3 * tape_m, 1e3 * seen));
  return found;
}

}  // namespace robosim::calibrate
