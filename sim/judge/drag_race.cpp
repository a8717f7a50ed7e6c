#include "sim/judge/drag_race.h"

#include <fmt/format.h>

#include <cmath>

#include "sim/base/error.h"
#include "sim/world/world.h"

namespace robosim::judge {
namespace {

constexpr double kGone = 0.01;     // in metres: distance at which the robot has left the start
constexpr double kPenalty = 5.0;   // in seconds, for each overrun or touch
constexpr double kAcross = 0.02;   // in metres: distance between the checked points of a line across the lane
constexpr double kHalfLane = 0.2;  // in metres
constexpr SimTime kStandsBehind = 500 * kMillisecond;

// Returns whether the outline has reached a line across the lane.
bool has_reached(const world::Body& body, Vec2 middle, Vec2 direction) {
  if (dot(body.pose().position - middle, direction) >= 0.0) return true;
  for (double across = -kHalfLane; across <= kHalfLane; across += kAcross)
    if (body.covers(middle + left_of(direction) * across)) return true;
  return false;
}

}  // namespace

DragRace::DragRace(const map::Map& map) {
  if (!map.course.race || map.course.race->braking == 0.0)
    throw InputError({map.file},
                     "the goal drag-race requires a map with a path and, in [race], start, goal and braking");
  const map::RaceLines& lines = *map.course.race;
  const map::Path& path = map.course.paths[static_cast<std::size_t>(lines.path)];
  const Pose finish = path.at(lines.goal, false);
  finish_ = finish.position;
  direction_ = finish.heading;
  limit_ = path.at(lines.goal + lines.braking, false).position;
  if (lines.signal > 0.0) began_ = signal_ = static_cast<SimTime>(std::llround(lines.signal * 1e9));
}

void DragRace::look(const RulesInput& now, Events& events) {
  const Vec2 at = now.body.pose().position;
  if (!origin_) origin_ = at;
  const bool gone = length(at - *origin_) >= kGone;
  if (gone && signal_ != kNever && now.t < signal_) jumped_ = true;
  if (gone && began_ == kNever) began_ = now.t;
  if (gone && now.body.in_hand() && !in_hand_) ++hands_;
  in_hand_ = now.body.in_hand();
  touches_ = now.body.collisions();
  if (now.moved) {
    if (passed_ == kNever && now.body.covers(finish_)) {
      passed_ = now.t;
      events.push_back(result::Scored{"finish line", time_s(), "s"});
    }
    if (!overran_ && passed_ != kNever && has_reached(now.body, limit_, direction_)) {
      overran_ = true;
      events.push_back(result::Scored{"braking distance overrun", kPenalty, "s"});
    }
  }
  if (passed_ == kNever || !now.at_rest) at_rest_since_ = kNever;
  if (passed_ != kNever && now.at_rest && at_rest_since_ == kNever) at_rest_since_ = now.t;
  rested_ = !jumped_ && at_rest_since_ != kNever && now.t - at_rest_since_ >= kStandsBehind;
}

double DragRace::score_s() const { return time_s() + kPenalty * (overran_ + touches_ + hands_); }

std::string DragRace::summary() const {
  if (jumped_) return "the robot left before the starting signal and is disqualified";
  if (passed_ == kNever) return "the finish line was not passed";
  const std::string passed = fmt::format("the finish line was passed after {:.2f} s", time_s());
  if (!rested_) return passed + ", but the robot did not stop after it";
  const int penalties = overran_ + touches_ + hands_;
  if (penalties == 0) return passed + ", and the robot stopped within the braking distance";
  return fmt::format("{}, {} × 5 s were added{}: {:.2f} s count", passed, penalties,
                     overran_ ? ", because the braking distance was overrun" : "", score_s());
}

void DragRace::score(result::Metrics& metrics) const {
  metrics.score_unit = "s";
  if (passed_ == kNever || jumped_) return;
  metrics.run_s = time_s();
  metrics.score_parts.push_back({"time", 1, time_s()});
  if (overran_) metrics.score_parts.push_back({"braking distance overrun", 1, kPenalty});
  if (touches_ > 0) metrics.score_parts.push_back({"barrier touched", touches_, kPenalty * touches_});
  if (hands_ > 0) metrics.score_parts.push_back({"touched by hand", hands_, kPenalty * hands_});
  if (rested_) metrics.score = score_s();
}

}  // namespace robosim::judge
