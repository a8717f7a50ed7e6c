// Implements the helpers that the readers of course formats share (formats.h).
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>

#include "sim/base/error.h"
#include "sim/map/course/formats.h"

namespace robosim::course {
namespace {

constexpr std::string_view kBetween = " \t,;";

double whole_microdegrees(double rad) {
  constexpr double kDegree = std::numbers::pi / 180.0;
  return std::round(rad / kDegree * 1e6) / 1e6 * kDegree;
}

}  // namespace

std::vector<NumberedLine> lines_of(std::string_view text) {
  std::vector<NumberedLine> lines;
  for (int number = 1; !text.empty(); ++number) {
    std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (line.find_first_not_of(" \t") != line.npos) lines.push_back({number, line});
  }
  return lines;
}

std::vector<double> numbers_in(const NumberedLine& line, const std::string& file) {
  std::vector<double> numbers;
  std::string_view rest = line.text;
  while (true) {
    rest.remove_prefix(std::min(rest.find_first_not_of(kBetween), rest.size()));
    if (rest.empty()) return numbers;
    const std::string_view word = rest.substr(0, rest.find_first_of(kBetween));
    double value = 0.0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size() || !(std::fabs(value) <= map::Path::kMost))
      throw InputError({file, line.number},
                       fmt::format("expected a number from -{0:.0f} to {0:.0f}, got “{1}”", map::Path::kMost,
                                   word.substr(0, 40)));
    numbers.push_back(value);
    rest.remove_prefix(word.size());
  }
}

double rounded(double x) { return std::round(x * 1e6) / 1e6; }

map::Map map_around(const std::vector<map::Path>& paths, double line_m, double margin) {
  Vec2 least{1e9, 1e9}, most{-1e9, -1e9};
  for (const map::Path& path : paths)
    for (const map::PathPiece& piece : path.pieces()) {
      const int steps = 1 + static_cast<int>(std::fabs(piece.turn) * 50.0);
      for (int i = 0; i <= steps; ++i) {
        const Vec2 p = piece.at(piece.length * i / steps).position;
        least = {std::min(least.x, p.x), std::min(least.y, p.y)};
        most = {std::max(most.x, p.x), std::max(most.y, p.y)};
      }
    }
  // Shifts by whole millimetres, so that coordinates in whole millimetres stay whole.
  const Vec2 shift{std::ceil((margin - least.x) * 1e3) / 1e3, std::ceil((margin - least.y) * 1e3) / 1e3};
  map::Map map;
  map.line_m = line_m;
  map.width = static_cast<int>(std::ceil((most.x + shift.x + margin) / map.cell_m));
  map.height = static_cast<int>(std::ceil((most.y + shift.y + margin) / map.cell_m));
  const auto cells = static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.height);
  if (cells > map::kMaxBareCells)
    throw InputError(
        fmt::format("the course is too large: expected at most {:.0f} square metres, got {:.0f} x {:.0f} m",
                    static_cast<double>(map::kMaxBareCells) * map.cell_m * map.cell_m, most.x - least.x,
                    most.y - least.y));
  for (const map::Path& path : paths) {
    const Pose begin = path.begin();
    const Vec2 from = begin.position + shift;
    map::Path moved({{rounded(from.x), rounded(from.y)}, begin.heading});
    for (const map::PathPiece& piece : path.pieces()) {
      const double turn = whole_microdegrees(piece.turn);
      if (piece.radius > 0.0)
        moved.add_arc(rounded(piece.radius), turn, piece.is_gap);
      else if (piece.length > 0.0)
        moved.add_straight(rounded(piece.length), piece.is_gap);
      else
        moved.add_corner(turn);
    }
    map.course.paths.push_back(std::move(moved));
  }
  map.cells.assign(cells, map::Cell::floor);
  return map;
}

}  // namespace robosim::course
