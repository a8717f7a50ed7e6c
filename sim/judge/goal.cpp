#include "sim/judge/goal.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "sim/base/did_you_mean.h"
#include "sim/base/error.h"
#include "sim/base/goal_forms.h"
#include "sim/world/world.h"

namespace robosim::judge {
namespace {

constexpr SimTime kRestAtStation = 500 * kMillisecond;
constexpr SimTime kStandsStill = kSecond;

bool wheels_turn(const world::Body& body) {
  return body.wheel_rate(world::left) != 0.0 || body.wheel_rate(world::right) != 0.0;
}

[[noreturn]] void unknown_goal(std::string_view text) {
  throw InputError(fmt::format("goal: {}", expected_goal(std::string(text))));
}

int parse_count(std::string_view digits, int most, std::string_view text) {
  int n = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), n);
  if (error != std::errc() || end != digits.data() + digits.size() || n < 1 || n > most) unknown_goal(text);
  return n;
}

}  // namespace

Goal parse_goal(std::string_view text) {
  Goal goal;
  const std::size_t colon = text.find(':');
  const std::string_view word = text.substr(0, colon);
  const std::string_view rest = colon == std::string_view::npos ? std::string_view() : text.substr(colon + 1);
  const bool bare = colon == std::string_view::npos;
  if (word == "tour" && bare) {
    goal.kind = Goal::Kind::tour;
  } else if (word == "robotrace" && bare) {
    goal.kind = Goal::Kind::robotrace;
  } else if (word == "ukmars" && bare) {
    goal.kind = Goal::Kind::ukmars;
  } else if (word == "drag-race" && bare) {
    goal.kind = Goal::Kind::drag_race;
  } else if (word == "rescue-line" && bare) {
    goal.kind = Goal::Kind::rescue_line;
  } else if (word == "line-maze") {
    goal.kind = Goal::Kind::line_maze;
    if (!bare) goal.tries = parse_count(rest, MazeTries::kMost, text);
  } else if (word == "still" && bare) {
    goal.kind = Goal::Kind::still;
  } else if (word == "none" && bare) {
    goal.kind = Goal::Kind::none;
  } else if (word == "station" && !rest.empty()) {
    goal.kind = Goal::Kind::station;
    goal.station = rest;
  } else if (word == "laps") {
    goal.kind = Goal::Kind::laps;
    goal.laps = parse_count(rest, std::numeric_limits<int>::max(), text);
  } else {
    unknown_goal(text);
  }
  return goal;
}

std::string to_string(const Goal& goal) {
  switch (goal.kind) {
    case Goal::Kind::tour:
      return "tour";
    case Goal::Kind::laps:
      return fmt::format("laps:{}", goal.laps);
    case Goal::Kind::station:
      return "station:" + goal.station;
    case Goal::Kind::robotrace:
      return "robotrace";
    case Goal::Kind::ukmars:
      return "ukmars";
    case Goal::Kind::drag_race:
      return "drag-race";
    case Goal::Kind::rescue_line:
      return "rescue-line";
    case Goal::Kind::line_maze:
      return goal.tries == 1 ? "line-maze" : fmt::format("line-maze:{}", goal.tries);
    case Goal::Kind::still:
      return "still";
    case Goal::Kind::none:
      return "none";
  }
  return "";
}

Goal default_goal(const map::Map& map, const map::Network& network) {
  if (!map.goal.empty()) return parse_goal(map.goal);
  Goal goal;
  if (network.has_laps()) goal.kind = Goal::Kind::laps;
  return goal;
}

Progress::Progress(const Goal& goal, const map::Map& map, const map::Stripes& stripes,
                   const map::Network& network, const map::Start& start)
    : goal_(goal),
      start_(stripes.pose_of(start).position),
      contest_(goal, map, start_),
      takes_time_(contest_ || goal.kind == Goal::Kind::station || goal.kind == Goal::Kind::still) {
  for (const map::Station& station : network.stations) {
    stations_.push_back({station.name, stripes.point_of(station.cell), false});
    if (goal.kind == Goal::Kind::station &&
        (goal.station == station.name || goal.station == std::to_string(station.id)))
      goal_station_ = static_cast<int>(stations_.size()) - 1;
  }
  for (const map::CellAt& cell : network.junctions) junctions_.push_back({"", stripes.point_of(cell), false});
  for (const map::CellAt& cell : network.loop) loop_.push_back(stripes.point_of(cell));
  loop_.insert(loop_.end(), network.lap.begin(), network.lap.end());
  if (goal.kind == Goal::Kind::station && goal_station_ < 0) {
    std::vector<std::string> names;
    for (const Waypoint& station : stations_) names.push_back(station.name);
    throw InputError(
        {map.file}, names.empty() ? fmt::format("unknown station {}: the map has no stations", goal.station)
                                  : fmt::format("unknown station: {}", expected_one_of(goal.station, names)));
  }
  if (goal.kind == Goal::Kind::laps && loop_.empty())
    throw InputError({map.file},
                     fmt::format("the goal {} requires a line that is one closed loop, but this line has {} "
                                 "stations and {} junctions; try the goal tour",
                                 to_string(goal), stations_.size(), junctions_.size()));
}

bool Progress::is_visited(const std::string& station) const {
  for (const Waypoint& waypoint : stations_)
    if (waypoint.name == station) return waypoint.visited;
  return false;
}

void Progress::visit_places(const world::Body& body, Events& events) {
  for (std::size_t i = 0; i < stations_.size(); ++i) {
    if (stations_[i].visited || !body.covers(stations_[i].centre)) continue;
    stations_[i].visited = true;
    visited_.push_back(static_cast<int>(i));
    events.push_back(result::StationVisited{stations_[i].name});
  }
  for (Waypoint& junction : junctions_) {
    if (junction.visited || !body.covers(junction.centre)) continue;
    junction.visited = true;
    ++junctions_visited_;
  }
}

void Progress::begin_at(Vec2 position) {
  origin_ = position;
  const auto is_nearer = [&](Vec2 a, Vec2 b) { return square(a - position) < square(b - position); };
  node_ = std::min_element(loop_.begin(), loop_.end(), is_nearer) - loop_.begin();
  if (2 * node_ > static_cast<std::int64_t>(loop_.size())) node_ -= static_cast<std::int64_t>(loop_.size());
}

/// Moves node_ to the node nearest to `position`. Must be called whenever the body has moved by a fraction of
/// the distance between two nodes.
void Progress::follow_loop(Vec2 position) {
  const auto count = static_cast<std::int64_t>(loop_.size());
  // Begins another lap if the body went round without passing all nodes in order.
  if (node_ - lap_node_ >= count) lap_node_ += count;
  if (lap_node_ - node_ >= count) lap_node_ -= count;
  const auto distance = [&](std::int64_t node) {
    return square(loop_[static_cast<std::size_t>((node % count + count) % count)] - position);
  };
  for (const std::int64_t step : {1, -1})
    while (distance(node_ + step) < distance(node_)) node_ += step;
}

/// Returns whether a robot that has passed all nodes in order has also gone round the loop. A robot that
/// turned back on its way may have passed all nodes without going round. If the robot has gone round, begins
/// the next lap.
bool Progress::has_gone_round(bool backwards) {
  const auto count = static_cast<std::int64_t>(loop_.size());
  const std::int64_t ahead = node_ - lap_node_;
  // At the last node, the body is near the beginning of a lap: it has gone round once or not at all.
  if (2 * (backwards ? -ahead : ahead) < count) return false;
  lap_node_ += backwards ? -count : count;
  return true;
}

Vec2 Progress::loop_point(const Lap& lap, bool backwards) const {
  const std::size_t count = loop_.size();
  return loop_[backwards ? (count - lap.next) % count : lap.next % count];
}

bool Progress::advance(Lap& lap, bool backwards, const world::Body& body, SimTime t, Events& events) {
  const std::size_t count = loop_.size();
  while (lap.next <= count && body.covers(loop_point(lap, backwards))) ++lap.next;
  if (lap.next <= count) return false;
  lap.next = 1;
  if (!has_gone_round(backwards)) return false;
  ++lap.complete;
  laps_s_.push_back(static_cast<double>(t - lap.began) * 1e-9);
  events.push_back(result::LapDone{lap.complete, laps_s_.back()});
  lap.began = t;
  return lap.complete >= goal_.laps;
}

bool Progress::tour_done(const world::Body& body) {
  const bool covers_start = body.covers(start_);
  if (!covers_start) left_start_ = true;
  return left_start_ && covers_start && visited_.size() == stations_.size();
}

bool Progress::rests_at_station(const world::Body& body, SimTime t) {
  const bool there = at_rest(body) && body.covers(stations_[static_cast<std::size_t>(goal_station_)].centre);
  if (!there) at_rest_since_ = kNever;
  if (there && at_rest_since_ == kNever) at_rest_since_ = t;
  return there && t - at_rest_since_ >= kRestAtStation;
}

bool Progress::stands_still(const world::Body& body, SimTime t) {
  if (wheels_turn(body)) {
    has_moved_ = true;
    at_rest_since_ = kNever;
    return false;
  }
  if (at_rest_since_ == kNever) at_rest_since_ = t;
  return has_moved_ && t - at_rest_since_ >= kStandsStill;
}

void Progress::compete(const RulesInput& now, Events& events) {
  const std::size_t before = events.size();
  contest_.look(now, events);
  for (std::size_t i = before; i < events.size(); ++i)
    if (const auto* lap = std::get_if<result::LapDone>(&events[i])) laps_s_.push_back(lap->lap_s);
  reached_ = contest_.reached();
}

// Sets the result for a body that covers none of the remaining places.
void Progress::find_nothing() {
  if (goal_.kind == Goal::Kind::tour) left_start_ = true;
  if (goal_.kind == Goal::Kind::tour || goal_.kind == Goal::Kind::laps) reached_ = false;
}

void Progress::look(const world::Body& body, SimTime t, Events& events) {
  if (goal_.kind == Goal::Kind::station) reached_ = rests_at_station(body, t);
  if (goal_.kind == Goal::Kind::still) reached_ = stands_still(body, t);

  const Pose& pose = body.pose();
  if (!origin_) begin_at(pose.position);
  if (may_depart(pose)) {
    // Restarts the clock of each lap of which less than half is done. If more than half of a lap is done, the
    // body is returning to the start.
    for (Lap* lap : {&forwards_, &backwards_})
      if (2 * lap->next < loop_.size()) lap->began = t;
  }
  const auto has_stopped = [&] { return square(pose.position - checked_at_) > 0.0 && at_rest(body); };
  const bool looks = !is_near(pose) || has_stopped();
  if (looks) {
    checked_at_ = pose.position;
    checked_heading_ = pose.heading;
    if (!contest_ && !loop_.empty()) follow_loop(pose.position);
    constexpr double kAway = kDeparture + 2.0 * kCheckEvery;
    is_around_origin_ = square(pose.position - *origin_) < kAway * kAway;
    if (!contest_ && is_far_from_places(pose.position)) return find_nothing();
    visit_places(body, events);
  }
  if (contest_) compete({body, t, at_rest(body), looks}, events);
  if (!looks) return;
  if (!contest_ && !loop_.empty()) {
    const bool forwards = advance(forwards_, false, body, t, events);
    const bool backwards = advance(backwards_, true, body, t, events);
    if (goal_.kind == Goal::Kind::laps) reached_ = forwards || backwards;
  }
  if (goal_.kind == Goal::Kind::tour) reached_ = tour_done(body);
  search_places(body);
}

// Computes how far the body may move before it can cover any remaining place. Most checks happen between two
// places and can therefore end early.
void Progress::search_places(const world::Body& body) {
  constexpr double kSure = 1e-3;  // in metres: allowance for rounding errors
  searched_at_ = body.pose().position;
  double nearest = std::numeric_limits<double>::infinity();
  const auto add = [&](Vec2 place) { nearest = std::min(nearest, square(place - searched_at_)); };
  for (const Waypoint& station : stations_)
    if (!station.visited) add(station.centre);
  for (const Waypoint& junction : junctions_)
    if (!junction.visited) add(junction.centre);
  if (!loop_.empty()) {
    add(loop_point(forwards_, false));
    add(loop_point(backwards_, true));
  }
  if (goal_.kind == Goal::Kind::tour) add(start_);
  const double body_reach = length(body.circle_centre() - searched_at_) + body.bound_radius() + kSure;
  free_reach_ = std::max(std::sqrt(nearest) - body_reach, 0.0);
}

bool Progress::is_settled(const world::Body& body) const {
  return !takes_time_ && square(body.pose().position - checked_at_) == 0.0 &&
         dot(body.pose().heading, checked_heading_) > kCheckTurn;
}

std::string Progress::summary() const {
  switch (goal_.kind) {
    case Goal::Kind::laps:
      return fmt::format("{} of {} laps", std::max(forwards_.complete, backwards_.complete), goal_.laps);
    case Goal::Kind::tour:
      return visited_.size() == stations_.size()
                 ? fmt::format("all {} stations visited, {}", stations_.size(),
                               reached_ ? "and back at the start" : "but not back at the start")
                 : fmt::format("{} of {} stations visited", visited_.size(), stations_.size());
    case Goal::Kind::station:
      return fmt::format("station {} {}", goal_.station,
                         reached_ ? "reached, and at rest there"
                         : stations_[static_cast<std::size_t>(goal_station_)].visited
                             ? "visited, but not at rest there for 0.5 s"
                             : "not visited");
    case Goal::Kind::robotrace:
    case Goal::Kind::ukmars:
    case Goal::Kind::drag_race:
    case Goal::Kind::rescue_line:
    case Goal::Kind::line_maze:
      return contest_.summary();
    case Goal::Kind::still:
      return reached_     ? "it moved, and then stood still for 1 s"
             : has_moved_ ? "it moved, but did not stop for 1 s"
                          : "it never moved";
    case Goal::Kind::none:
      return "no goal was set";
  }
  return "";
}

}  // namespace robosim::judge
