#include "sim/judge/maze_tries.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "sim/base/deterministic_trig.h"
#include "sim/base/error.h"
#include "sim/world/world.h"

namespace robosim::judge {
namespace {

constexpr double kLeft = 0.01;            // in m: at this distance from the start, a try begins
constexpr double kAtStart = 0.05;         // in m: within this distance, the robot is at the start
constexpr double kByHand = 0.02;          // in m: a larger movement in one tick is a manual move
constexpr SimTime kStopped = kSecond;     // time at rest on the disc that counts as a stop
constexpr double kOffForStopping = 10.0;  // in seconds: deduction for a stop on the disc

std::vector<Vec2> points_of(const map::Area& disc) {
  constexpr int kRound = 24;
  std::vector<Vec2> points{disc.middle.position};
  for (const double share : {0.5, 1.0})
    for (int i = 0; i < kRound; ++i)
      points.push_back(disc.middle.position +
                       unit_vector(2.0 * std::numbers::pi * i / kRound) * (share * disc.radius));
  return points;
}

double seconds_between(SimTime from, SimTime to) { return static_cast<double>(to - from) / 1e9; }

}  // namespace

double MazeTries::Try::score() const { return stopped ? time_s - kOffForStopping : time_s; }

MazeTries::MazeTries(const map::Map& map, Vec2 start, int tries) : start_(start), tries_(tries) {
  const auto station = std::find_if(map.stations.begin(), map.stations.end(),
                                    [](const map::NamedStation& s) { return s.name == "goal"; });
  if (!map.goal_cell && station == map.stations.end())
    throw InputError({map.file}, "the goal line-maze requires the maze's end: a G, or a station named goal");
  const Vec2 end = map.centre(map.goal_cell ? *map.goal_cell : station->cell);
  const auto disc =
      std::find_if(map.course.areas.begin(), map.course.areas.end(),
                   [&](const map::Area& area) { return area.radius > 0.0 && area.contains(end); });
  if (disc == map.course.areas.end())
    throw InputError(
        {map.file},
        fmt::format("the goal line-maze requires a disc where the maze ends: an [[area]] at {:.10g} mm, "
                    "{:.10g} mm with a radius",
                    1e3 * end.x, 1e3 * end.y));
  disc_ = points_of(*disc);
}

bool MazeTries::touches_disc(const world::Body& body) const {
  return std::any_of(disc_.begin(), disc_.end(), [&](Vec2 p) { return body.covers(p); });
}

void MazeTries::finish_try(bool stopped, Events& events) {
  phase_ = Phase::over;
  ++done_;
  finished_.push_back({seconds_between(began_, touched_), stopped});
  events.push_back(result::Scored{fmt::format("try {}, {:.2f} s{}", done_, finished_.back().time_s,
                                              stopped ? ", stopped on the disc" : ""),
                                  finished_.back().score(), "s"});
}

void MazeTries::look(const RulesInput& now, Events& events) {
  const Vec2 at = now.body.pose().position;
  const bool by_hand = now.body.in_hand() || (seen_at_ && length(at - *seen_at_) > kByHand);
  if (!seen_at_) waited_at_ = at;
  seen_at_ = at;
  if (by_hand) {
    if (phase_ == Phase::driving) ++done_;
    if (phase_ == Phase::on_disc) finish_try(false, events);
    phase_ = length(at - start_) < kAtStart && done_ < tries_ ? Phase::waiting : Phase::over;
    waited_at_ = at;
    return;
  }
  if (phase_ == Phase::waiting) {
    if (length(at - waited_at_) < kLeft) return;
    phase_ = Phase::driving;
    began_ = now.t;
  }
  if (phase_ == Phase::driving && now.moved && touches_disc(now.body)) {
    phase_ = Phase::on_disc;
    touched_ = now.t;
    at_rest_since_ = kNever;
  }
  if (phase_ != Phase::on_disc) return;
  if (!now.at_rest) at_rest_since_ = kNever;
  if (now.at_rest && at_rest_since_ == kNever) at_rest_since_ = now.t;
  if (now.at_rest && now.t - at_rest_since_ >= kStopped)
    finish_try(true, events);
  else if (now.moved && !touches_disc(now.body))
    finish_try(false, events);
}

const MazeTries::Try* MazeTries::best() const {
  const auto best = std::min_element(finished_.begin(), finished_.end(),
                                     [](const Try& a, const Try& b) { return a.score() < b.score(); });
  return best == finished_.end() ? nullptr : &*best;
}

std::string MazeTries::summary() const {
  const std::string tries = tries_ == 1 ? "" : fmt::format("{} of {} tries made, ", done_, tries_);
  const Try* const best = this->best();
  if (!best) return tries + (phase_ == Phase::on_disc ? "the disc is touched" : "the disc was not reached");
  return fmt::format("{}the disc was reached after {:.2f} s{}: {:.2f} s count", tries, best->time_s,
                     best->stopped ? ", 10 s off for stopping on it" : "", best->score());
}

void MazeTries::score(result::Metrics& metrics) const {
  metrics.score_unit = "s";
  for (const Try& one : finished_) {
    metrics.score_parts.push_back({"time", 1, one.time_s});
    if (one.stopped) metrics.score_parts.push_back({"stopped on the disc", 1, -kOffForStopping});
  }
  if (!best()) return;
  metrics.run_s = best()->time_s;
  metrics.score = best()->score();
}

}  // namespace robosim::judge
