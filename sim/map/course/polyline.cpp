#include "sim/map/course/polyline.h"

#include <algorithm>
#include <cmath>

#include "sim/map/course/formats.h"

namespace robosim::course {
namespace {

constexpr double kSame = 1e-6;     // in m
constexpr double kAhead = 1e-9;    // in rad: a smaller turn is not a bend
constexpr double kBack = 3.14159;  // in rad: a larger turn leads straight back, so that no arc fits

}  // namespace

void reverse(Polyline& line) {
  std::reverse(line.begin(), line.end());
  for (std::size_t i = 0; i + 1 < line.size(); ++i) line[i].gap_behind = line[i + 1].gap_behind;
  line.back().gap_behind = false;
}

map::Path path_of(const Polyline& all) {
  Polyline line;
  for (const Corner& corner : all) {
    if (!line.empty() && length(corner.at - line.back().at) < kSame)
      line.back().gap_behind = corner.gap_behind;
    else
      line.push_back(corner);
  }
  const auto leg = [&](std::size_t i) { return line[i + 1].at - line[i].at; };
  const Vec2 first = leg(0);
  const Vec2 from = line.front().at;
  map::Path path({{rounded(from.x), rounded(from.y)}, first * (1.0 / length(first))});
  // The length that each bend removes from both adjoining straights. Neighbouring bends share a straight.
  std::vector<double> turns(line.size()), cuts(line.size());
  for (std::size_t i = 1; i + 1 < line.size(); ++i) {
    turns[i] = std::atan2(cross(leg(i - 1), leg(i)), dot(leg(i - 1), leg(i)));
    const double angle = std::fabs(turns[i]);
    if (angle > kAhead && angle < kBack && !line[i - 1].gap_behind && !line[i].gap_behind)
      cuts[i] = line[i].rounding * std::tan(angle / 2.0);
  }
  std::vector<double> fit = cuts;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const double both = cuts[i] + cuts[i + 1],
                 share = both > 0.0 ? std::min(length(leg(i)) / both, 1.0) : 1.0;
    fit[i] = std::min(fit[i], cuts[i] * share);
    fit[i + 1] = std::min(fit[i + 1], cuts[i + 1] * share);
  }
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const double straight = length(leg(i)) - fit[i] - fit[i + 1], turn = turns[i + 1];
    if (straight > kSame) path.add_straight(rounded(straight), line[i].gap_behind);
    if (fit[i + 1] > 0.0)
      path.add_arc(rounded(fit[i + 1] / std::tan(std::fabs(turn) / 2.0)), turn);
    else if (std::fabs(turn) > kAhead)
      path.add_corner(turn);
  }
  return path;
}

std::vector<double> tile_middles(const map::Path& path, double tile) {
  constexpr double kStep = 0.005, kLeast = 0.010;  // m
  std::vector<double> middles;
  double from = 0.0, to = 0.0;
  Vec2 on{-1.0, -1.0};
  const auto end_tile = [&] {
    if (to - from >= kLeast) middles.push_back(0.5 * (from + to));
  };
  for (double at = 0.0; at <= path.length(); at += kStep) {
    const Vec2 p = path.at(at, false).position;
    const Vec2 now{std::floor(p.x / tile), std::floor(p.y / tile)};
    if (!(now == on)) {
      end_tile();
      from = at;
      on = now;
    }
    to = at;
  }
  end_tile();
  return middles;
}

}  // namespace robosim::course
