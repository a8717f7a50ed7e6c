#include "sim/judge/race.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/base/error.h"
#include "sim/world/world.h"

namespace robosim::judge {
namespace {

constexpr double kStep = 0.04;  // in m: largest distance between two points of the course
constexpr SimTime kRestInArea = 2 * kSecond;

std::vector<Vec2> points_of(const map::Path& path, double from, double length) {
  const int count = std::max(1, static_cast<int>(std::ceil(length / kStep)));
  std::vector<Vec2> points;
  for (int i = 0; i <= count; ++i) points.push_back(path.at(from + length * i / count, true).position);
  return points;
}

}  // namespace

Race::Race(const map::Map& map, Finish finish) : finish_(finish) {
  if (!map.course.race || map.course.race->braking > 0.0)
    throw InputError(
        {map.file},
        fmt::format("the goal {} requires a map with a closed path and, in [race], its start and goal lines",
                    finish == Finish::line ? "ukmars" : "robotrace"));
  const map::RaceLines& lines = *map.course.race;
  const map::Path& path = map.course.paths[static_cast<std::size_t>(lines.path)];
  double length = lines.goal - lines.start;
  if (length <= 0.0) length += path.length();
  course_ = {points_of(path, lines.start, length), points_of(path, lines.goal, path.length() - length),
             length};
}

void Race::look(const RulesInput& now, Events& events) {
  rested_ = rests(now);
  if (now.moved) advance(now, events);
}

void Race::advance(const RulesInput& now, Events& events) {
  if (ended_ != kNever) return;
  while (next_ < course_.points.size() && now.body.covers(course_.points[next_]))
    if (next_++ == 0) began_ = now.t;
  if (next_ < course_.points.size()) return;
  ended_ = now.t;
  events.push_back(result::LapDone{1, time_s()});
}

bool Race::rests(const RulesInput& now) {
  if (finish_ == Finish::line) return ended_ != kNever && now.t - ended_ >= kRestInArea;
  const bool there =
      ended_ != kNever && now.at_rest &&
      std::any_of(course_.area.begin(), course_.area.end(), [&](Vec2 p) { return now.body.covers(p); });
  if (!there) at_rest_since_ = kNever;
  if (there && at_rest_since_ == kNever) at_rest_since_ = now.t;
  return there && now.t - at_rest_since_ >= kRestInArea;
}

std::string Race::summary() const {
  if (next_ == 0) return "the start line was not passed";
  if (ended_ == kNever)
    return fmt::format(
        "{:.2f} of {:.2f} m from the start line to the goal line",
        course_.length * static_cast<double>(next_ - 1) / static_cast<double>(course_.points.size() - 1),
        course_.length);
  const std::string passed = fmt::format("the goal line was passed after {:.2f} s", time_s());
  if (finish_ == Finish::line) return passed;
  return passed + (rested_
                       ? ", and the robot stopped in the area"
                       : ", but the robot was not at rest for 2 s between the goal line and the start line");
}

void Race::score(result::Metrics& metrics) const {
  metrics.score_unit = "s";
  if (ended_ == kNever) return;
  metrics.run_s = time_s();
  if (rested_ || finish_ == Finish::line) metrics.score = time_s();
}

}  // namespace robosim::judge
