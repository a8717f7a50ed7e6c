#include "sim/map/path_survey.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace robosim::map {
namespace {

constexpr double kChord = 0.005;  // m
constexpr double kBox = 2.0 * kChord;

std::vector<Vec2> points_along(const Path& path) {
  std::vector<Vec2> points{path.begin().position};
  for (const PathPiece& piece : path.pieces()) {
    const int steps = static_cast<int>(std::ceil(piece.length / kChord));
    for (int i = 1; i <= steps; ++i) points.push_back(piece.at(piece.length * i / steps).position);
  }
  return points;
}

// Returns whether two chords cross. Chords are half open, so that a crossing at a common point counts once.
bool cross_each_other(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const auto left = [](Vec2 from, Vec2 to, Vec2 p) { return cross(to - from, p - from) > 0.0; };
  return left(a, b, c) != left(a, b, d) && left(c, d, a) != left(c, d, b);
}

int crossings_of(const std::vector<Vec2>& points, bool closed) {
  std::unordered_map<std::uint64_t, std::vector<std::size_t>> boxes;  // only looked up, never iterated
  const auto number = [](double x) {
    return static_cast<std::uint32_t>(static_cast<std::int64_t>(std::floor(x / kBox)));
  };
  int crossings = 0;
  const std::size_t chords = points.size() - 1;
  for (std::size_t i = 0; i < chords; ++i) {
    const Vec2 a = points[i], b = points[i + 1], middle = (a + b) * 0.5;
    for (int dx = -1; dx <= 1; ++dx)
      for (int dy = -1; dy <= 1; ++dy) {
        const auto box =
            boxes.find(std::uint64_t{number(middle.x + dx * kBox)} << 32 | number(middle.y + dy * kBox));
        if (box == boxes.end()) continue;
        for (const std::size_t j : box->second) {
          if (i - j < 2 || (closed && i - j > chords - 2)) continue;
          crossings += cross_each_other(a, b, points[j], points[j + 1]);
        }
      }
    boxes[std::uint64_t{number(middle.x)} << 32 | number(middle.y)].push_back(i);
  }
  return crossings;
}

}  // namespace

PathSurvey survey_path(const Path& path, double closed_within) {
  PathSurvey survey;
  survey.length_m = path.length();
  survey.is_closed = path.is_closed(closed_within);
  survey.gap_m = length(path.end().position - path.begin().position);
  for (const PathPiece& piece : path.pieces()) {
    if (piece.length == 0.0) ++survey.corners;
    if (piece.radius > 0.0 && (survey.smallest_radius_m == 0.0 || piece.radius < survey.smallest_radius_m))
      survey.smallest_radius_m = piece.radius;
  }
  survey.crossings = crossings_of(points_along(path), survey.is_closed);
  return survey;
}

}  // namespace robosim::map
