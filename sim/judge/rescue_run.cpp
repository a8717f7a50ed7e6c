#include "sim/judge/rescue_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "sim/base/error.h"
#include "sim/world/world.h"

namespace robosim::judge {
namespace {

constexpr double kAlong = 0.005;        // in m: distance between two points of the path
constexpr double kLeastStep = 0.01;     // in m: a shorter part of the path on a tile is not a visit
constexpr double kCrossing = 0.1;       // in m: least distance along the path between a crossing's two points
constexpr double kRoundObstacle = 1.5;  // in tiles: within this distance of an obstacle, any place is allowed
constexpr double kOffTheStart = 0.01;   // in m
constexpr double kMostOfAllPaths = 1000.0;  // in m: limit for the total length of all paths
constexpr SimTime kRestAtEnd = 5 * kSecond;
constexpr int kLacksToGoOn = 3;
constexpr int kStartPoints = 5, kTilePoints = 5, kTileLess = 2, kEndPoints = 60, kEndLess = 5;
constexpr int kThingPoints = 10, kLineObstaclePoints = 20, kSeesawPoints = 20;
constexpr double kUneven = 0.003, kBump = 0.010;  // in m: greatest heights of an unevenness and a bump
constexpr double kRounding = 1e-6;                // in m

// Stores points of all paths, sorted into squares with sides of kAlong.
class PathPoints {
 public:
  explicit PathPoints(const map::Map& map) {
    double length = 0.0;
    for (const map::Path& path : map.course.paths) length += path.length();
    if (length > kMostOfAllPaths)
      throw InputError({map.file},
                       fmt::format("the paths are too long for the goal rescue-line: expected at most "
                                   "{:.10g} m together, got {:.10g} m",
                                   kMostOfAllPaths, length));
    for (std::size_t i = 0; i < map.course.paths.size(); ++i)
      for (double at = 0.0; at <= map.course.paths[i].length(); at += kAlong) {
        const Vec2 p = map.course.paths[i].at(at, false).position;
        points_.push_back({square(p.x), square(p.y), p, i, at});
      }
    std::sort(points_.begin(), points_.end(), before);
  }

  /// Returns whether another path passes through `p`, or the first path passes through `p` again. `along` is
  /// the distance of `p` along the first path.
  bool meet(Vec2 p, double along) const {
    for (std::int64_t x = square(p.x) - 1; x <= square(p.x) + 1; ++x)
      for (std::int64_t y = square(p.y) - 1; y <= square(p.y) + 1; ++y)
        for (auto it = std::lower_bound(points_.begin(), points_.end(), Point{x, y, {}, 0, 0.0}, before);
             it != points_.end() && it->x == x && it->y == y; ++it)
          if (length(it->at - p) < kAlong && (it->path > 0 || std::fabs(it->along - along) > kCrossing))
            return true;
    return false;
  }

 private:
  struct Point {
    std::int64_t x, y;
    Vec2 at;
    std::size_t path;
    double along;
  };
  static std::int64_t square(double metres) { return static_cast<std::int64_t>(std::floor(metres / kAlong)); }
  static bool before(const Point& a, const Point& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); }

  std::vector<Point> points_;
};

}  // namespace

RescueRun::RescueRun(const map::Map& map, Vec2 start) : path_({}), start_(start) {
  if (!map.course.rescue)
    throw InputError({map.file}, "the goal rescue-line requires a map with a path and a [rescue]");
  const map::RescueCourse& rescue = *map.course.rescue;
  path_ = map.course.paths.front();
  tile_ = rescue.tile;
  origin_ = rescue.origin;
  is_entry_ = rescue.is_entry;
  to_zone_ = rescue.to_zone;
  time_limit_ = (is_entry_ ? 6 : 8) * 60 * kSecond;
  make_steps();
  if (steps_.size() < 2)
    throw InputError(path_.place, "the goal rescue-line requires a path over at least two tiles");
  for (const double along : rescue.checkpoints) step_at(along)->checkpoint = true;
  steps_.front().checkpoint = steps_.back().checkpoint = false;
  mark(map);
  mark_hills(map);
}

int RescueRun::column_of(Vec2 at) const { return static_cast<int>(std::floor((at.x - origin_.x) / tile_)); }
int RescueRun::row_of(Vec2 at) const { return static_cast<int>(std::floor((at.y - origin_.y) / tile_)); }

void RescueRun::make_steps() {
  const int count = static_cast<int>(path_.length() / kAlong);
  std::vector<Step> visits;
  for (int i = 0; i <= count; ++i) {
    const double along = i * kAlong;
    const Vec2 p = path_.at(along, false).position;
    const int column = column_of(p), row = row_of(p);
    if (visits.empty() || visits.back().column != column || visits.back().row != row)
      visits.push_back({column, row, along, along});
    visits.back().to = along;
  }
  visits.back().to = path_.length();
  for (const Step& visit : visits)
    if (visit.to - visit.from >= kLeastStep) steps_.push_back(visit);
}

RescueRun::Step* RescueRun::step_at(double along) {
  for (Step& step : steps_)
    if (along <= step.to) return &step;
  return &steps_.back();
}

void RescueRun::mark(const map::Map& map) {
  double along = 0.0;
  for (const map::PathPiece& piece : path_.pieces()) {
    if (piece.is_gap) step_at(along + 0.5 * piece.length)->gap = true;
    along += piece.length;
  }
  const PathPoints points(map);
  std::vector<Vec2> own;
  for (double at = 0.0; at <= path_.length(); at += kAlong) own.push_back(path_.at(at, false).position);
  double last_crossing = -1.0;
  bool on_wall = false;
  for (std::size_t i = 0; i < own.size(); ++i) {
    const double now = static_cast<double>(i) * kAlong;
    const bool crosses = points.meet(own[i], now);
    if (crosses && (last_crossing < 0.0 || now - last_crossing > kCrossing)) ++step_at(now)->intersections;
    if (crosses) last_crossing = now;
    const auto column = static_cast<int>(std::floor(own[i].x / map.cell_m));
    const auto row = map.height - 1 - static_cast<int>(std::floor(own[i].y / map.cell_m));
    const bool wall = map.contains({column, row}) && map.at({column, row}) == map::Cell::wall;
    if (wall && !on_wall) {
      ++step_at(now)->obstacles;
      obstacles_.push_back(map.centre({column, row}));
    }
    on_wall = wall;
  }
}

void RescueRun::mark_hills(const map::Map& map) {
  for (const map::Hill& hill : map.course.hills) {
    const double highest =
        hill.heights.empty() ? 0.0 : *std::max_element(hill.heights.begin(), hill.heights.end());
    const bool is_bump = highest > kUneven + kRounding && highest <= kBump + kRounding;
    bool met = false;
    for (Step& step : steps_) {
      double least = 0.0, most = 0.0;
      bool here = false;
      for (double along = step.from; along <= step.to; along += kAlong) {
        const Vec2 at = path_.at(along, false).position;
        if (!hill.contains(at)) continue;
        const double height = hill.height_at(at);
        least = here ? std::min(least, height) : height;
        most = here ? std::max(most, height) : height;
        here = true;
      }
      if (!here) continue;
      if (hill.pivot > 0.0 && !met) ++step.seesaws;
      step.bump |= is_bump;
      step.ramp |= !is_bump && most - least > kBump;
      met = true;
    }
  }
}

bool RescueRun::is_in(const Step& step, Vec2 at) const {
  return column_of(at) == step.column && row_of(at) == step.row;
}

bool RescueRun::is_near_obstacle(Vec2 at) const {
  return std::any_of(obstacles_.begin(), obstacles_.end(),
                     [&](Vec2 obstacle) { return length(obstacle - at) < kRoundObstacle * tile_; });
}

void RescueRun::count(const char* part, int points, int times, Events& events) {
  if (times == 0) return;
  auto known = std::find_if(parts_.begin(), parts_.end(), [&](const auto& one) { return one.part == part; });
  if (known == parts_.end()) known = parts_.insert(parts_.end(), {part, 0, 0.0});
  known->count += times;
  known->value += points * times;
  events.push_back(result::Scored{times == 1 ? part : fmt::format("{} × {}", times, part),
                                  static_cast<double>(points * times), "points"});
}

// Handles the robot's arrival on a tile. Counts the elements of the tiles before this tile.
void RescueRun::arrive(std::size_t step, Events& events) {
  for (std::size_t i = at_; i < step; ++i) {
    Step& passed = steps_[i];
    if (passed.done) continue;
    passed.done = true;
    if (i == 0 && !is_entry_) count("start tile", kStartPoints, 1, events);
    count("gap", kThingPoints, passed.gap, events);
    if (!is_entry_) count("intersection", kThingPoints, passed.intersections, events);
    count("obstacle", is_entry_ ? kThingPoints : kLineObstaclePoints, passed.obstacles, events);
    count("speed bump", kThingPoints, passed.bump, events);
    count("ramp", kThingPoints, passed.ramp, events);
    if (!is_entry_) count("seesaw", kSeesawPoints, passed.seesaws, events);
  }
  at_ = step;
  const bool is_end = step + 1 == steps_.size();
  if ((!steps_[step].checkpoint && !is_end) || step <= checkpoint_) return;
  const int each = std::max(kTilePoints - kTileLess * lacks_here_, 0);
  // Excludes tile 0: the start tile has its own points.
  const auto tiles = static_cast<int>(step - std::max<std::size_t>(counted_to_, 1) + 1);
  if (each > 0) count("tile", each, tiles, events);
  counted_to_ = step + 1;
  checkpoint_ = step;
  lacks_here_ = 0;
}

void RescueRun::give_up(Events& events) {
  if (reached_ || hand_) return;
  ++lacks_;
  ++lacks_here_;
  std::size_t to = checkpoint_;
  if (lacks_here_ >= kLacksToGoOn) {
    const auto next = std::find_if(steps_.begin() + static_cast<std::ptrdiff_t>(checkpoint_) + 1,
                                   steps_.end(), [](const Step& step) { return step.checkpoint; });
    if (next != steps_.end()) {
      to = static_cast<std::size_t>(next - steps_.begin());
      for (std::size_t i = at_; i < to; ++i) steps_[i].done = true;
      counted_to_ = to + 1;
      checkpoint_ = to;
      lacks_here_ = 0;
    }
  }
  at_ = to;
  double along = 0.5 * (steps_[to].from + steps_[to].to);
  if (to == 0)
    for (along = 0.0; along < steps_[0].to && length(path_.at(along, false).position - start_) > kAlong;)
      along += kAlong;
  hand_ = path_.at(along, false);
  events.push_back(result::Scored{"lack of progress", 0.0, "points"});
  events.push_back(result::ScriptActed{"place", "", fmt::format("{:.0f}mm", 1e3 * along)});
}

std::optional<Pose> RescueRun::take_hand() {
  std::optional<Pose> where;
  where.swap(hand_);
  return where;
}

void RescueRun::look(const RulesInput& now, Events& events) {
  const Vec2 at = now.body.pose().position;
  if (began_ == kNever && length(at - start_) >= kOffTheStart) began_ = now.t;
  const bool taken = now.body.in_hand() && !in_hand_;
  in_hand_ = now.body.in_hand();
  if (taken && began_ != kNever) give_up(events);
  if (in_hand_ || hand_) return;
  if (now.moved) {
    const std::size_t last = steps_.size() - 1;
    if (at_ < last && is_in(steps_[at_ + 1], at))
      arrive(at_ + 1, events);
    else if (!is_in(steps_[at_], at) && !(at_ > 0 && is_in(steps_[at_ - 1], at)) && !is_near_obstacle(at))
      give_up(events);
    else if (is_near_obstacle(at))
      // Around an obstacle, the robot may return to the line one or two tiles farther on.
      for (std::size_t i = at_ + 2; i <= std::min(at_ + 3, last); ++i)
        if (is_in(steps_[i], at)) {
          arrive(i, events);
          break;
        }
  }
  const bool rests = now.at_rest && at_ + 1 == steps_.size() && is_in(steps_.back(), at);
  if (!rests) at_rest_since_ = kNever;
  if (rests && at_rest_since_ == kNever) at_rest_since_ = now.t;
  const bool arrived = to_zone_ ? at_ + 1 == steps_.size() : rests && now.t - at_rest_since_ >= kRestAtEnd;
  if (!arrived || reached_) return;
  reached_ = true;
  ended_ = now.t;
  if (!to_zone_ && !is_entry_) count("end tile", std::max(kEndPoints - kEndLess * lacks_, 0), 1, events);
}

std::string RescueRun::summary() const {
  double points = 0.0;
  for (const result::ScorePart& part : parts_) points += part.value;
  return fmt::format("{:.0f} points, {} of {} tiles, {} lack{} of progress{}", points, at_ + 1, steps_.size(),
                     lacks_, lacks_ == 1 ? "" : "s",
                     reached_                   ? ""
                     : at_ + 1 == steps_.size() ? ", but the robot was not at rest on the end tile for 5 s"
                                                : "");
}

void RescueRun::score(result::Metrics& metrics) const {
  metrics.score_unit = "points";
  metrics.score = 0.0;
  for (const result::ScorePart& part : parts_) metrics.score += part.value;
  metrics.score_parts = parts_;
  if (lacks_ > 0) metrics.score_parts.push_back({"lack of progress", lacks_, 0.0});
  if (reached_) metrics.run_s = static_cast<double>(ended_ - began_) / 1e9;
}

}  // namespace robosim::judge
