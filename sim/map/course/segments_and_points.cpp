// Reads courses that are lists of segments with curvatures, or lists of points (formats.h).
#include <fmt/format.h>

#include <cmath>

#include "sim/base/deterministic_trig.h"
#include "sim/base/error.h"
#include "sim/map/course/formats.h"

namespace robosim::course {
namespace {

constexpr double kMostMissing = 1.1;  // in m: largest distance from the goal line to the start line
constexpr double kAside = 0.05;       // in m: largest sideways distance between these lines
constexpr double kSamePoint = 1e-4;   // in m: closer points are merged
constexpr double kBeside = 3e-4;      // in m: largest distance of a removed point from the new straight
constexpr std::size_t kMostThinned = 100;

// Closes a course by a straight from its goal line to its start line.
void close(map::Path& path) {
  const Pose begin = path.begin(), end = path.end();
  const Vec2 missing = end.to_body(begin.position);
  const bool same_way = dot(begin.heading, end.heading) > 0.99;
  if (same_way && missing.x > kSamePoint && missing.x < kMostMissing && std::fabs(missing.y) < kAside)
    path.add_straight(missing.x);
}

Imported finish(const map::Path& path, const std::string& file) {
  if (path.length() < 0.1) throw InputError({file}, "the course is too short: expected at least 100 mm");
  map::Map map = map_around({path}, kRobotraceLine, kBoardMargin);
  map.light_line = true;
  return {std::move(map), {}};
}

// Removes points that are at most kBeside away from the straights between the remaining points.
std::vector<Vec2> thinned(const std::vector<Vec2>& points) {
  std::vector<Vec2> kept{points.front()};
  for (std::size_t from = 0; from + 1 < points.size();) {
    std::size_t to = from + 1;
    const auto fits = [&](std::size_t last) {
      const Vec2 along = points[last] - points[from];
      for (std::size_t i = from + 1; i < last; ++i)
        if (std::fabs(cross(along, points[i] - points[from])) > kBeside * length(along) ||
            dot(along, points[i] - points[i - 1]) <= 0.0)
          return false;
      return dot(along, points[last] - points[last - 1]) > 0.0;
    };
    while (to + 1 < points.size() && to - from < kMostThinned && fits(to + 1)) ++to;
    kept.push_back(points[to]);
    from = to;
  }
  return kept;
}

void check_length(const map::Path& path, const std::string& file, int line) {
  if (path.length() > map::Path::kMost)
    throw InputError({file, line}, fmt::format("the course is too long: expected at most {:.0f} km",
                                               map::Path::kMost / 1e3));
}

}  // namespace

Imported read_curvature(std::string_view text, const std::string& file) {
  map::Path path({{0.0, 0.0}, {1.0, 0.0}});
  for (const NumberedLine& line : lines_of(text)) {
    if (line.text.starts_with('#')) continue;
    const std::vector<double> numbers = numbers_in(line, file);
    if (numbers.size() != 2 || !(numbers[0] >= 0.0))
      throw InputError({file, line.number},
                       "the segment: expected its length in m and its curvature in 1/m, as in 0.5, -2.0");
    const double turn = numbers[0] * numbers[1];
    constexpr double kMostTurn = 100.0;  // rad
    if (std::fabs(turn) > kMostTurn)
      throw InputError({file, line.number}, fmt::format("the segment turns too far: expected at most {:.0f} "
                                                        "rad, got {:.0f} rad",
                                                        kMostTurn, turn));
    if (numbers[0] > kSamePoint && turn == 0.0) path.add_straight(numbers[0]);
    if (numbers[0] > kSamePoint && turn != 0.0) path.add_arc(1.0 / std::fabs(numbers[1]), turn);
    check_length(path, file, line.number);
  }
  close(path);
  return finish(path, file);
}

Imported read_points(std::string_view text, const std::string& file) {
  std::vector<Vec2> points;
  for (const NumberedLine& line : lines_of(text)) {
    if (line.text.starts_with('#')) continue;
    const std::vector<double> numbers = numbers_in(line, file);
    if (numbers.size() != 2)
      throw InputError({file, line.number}, "the point: expected two numbers, x and y in m");
    const Vec2 p{numbers[0], numbers[1]};
    if (points.empty() || length(p - points.back()) > kSamePoint) points.push_back(p);
  }
  if (points.size() < 2)
    throw InputError({file}, "the course has too few points: expected at least 2, got 1");
  const std::vector<Vec2> kept = thinned(points);
  map::Path path({kept[0], (kept[1] - kept[0]) * (1.0 / length(kept[1] - kept[0]))});
  for (std::size_t i = 1; i < kept.size(); ++i) {
    // Each piece begins at the actual end of the previous piece, so that rounding errors do not accumulate.
    const Vec2 step = kept[i] - path.end().position;
    const double turn = rounded(angle_of({dot(path.end().heading, step), cross(path.end().heading, step)}));
    if (i > 1 && turn != 0.0) path.add_corner(turn);
    path.add_straight(rounded(length(step)));
    check_length(path, file, 0);
  }
  close(path);
  return finish(path, file);
}

}  // namespace robosim::course
