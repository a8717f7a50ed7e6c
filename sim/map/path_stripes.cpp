#include "sim/map/path_stripes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace robosim::map {
namespace {

constexpr double kLeastStretch = 1e-9;  // in m: shorter pieces are rounding errors

// An unpainted interval along the path, in m.
struct Unpainted {
  double from;
  double to;
};

// Returns the unpainted intervals. At each end, an interval is longer than its gap by half the paint's width.
// The round end of the neighbouring stripe covers this length. `half_widths` contains half the paint's width
// for each piece.
std::vector<Unpainted> gaps_of(const Path& path, const std::vector<double>& half_widths) {
  std::vector<Unpainted> gaps;
  double along = 0.0;
  for (std::size_t i = 0; i < path.pieces().size(); ++i) {
    const PathPiece& piece = path.pieces()[i];
    if (piece.is_gap) {
      const double from = along - half_widths[i > 0 ? i - 1 : i];
      const double to = along + piece.length + half_widths[std::min(i + 1, half_widths.size() - 1)];
      if (!gaps.empty() && gaps.back().to > from)
        gaps.back().to = to;
      else
        gaps.push_back({from, to});
    }
    along += piece.length;
  }
  return gaps;
}

// Adds a part of a piece. The part turns by at most a quarter of a circle.
void add_part(const PathPiece& piece, double from, double to, bool painted, std::vector<Stripe>& stripes) {
  Vec2 a = piece.at(from).position, b = piece.at(to).position;
  if (piece.turn == 0.0) {
    if (a.x > b.x || (a.x == b.x && a.y > b.y)) std::swap(a, b);
    stripes.push_back({a, b, {}, 0.0, painted, static_cast<std::uint8_t>(piece.paint)});
  } else {
    if (piece.turn < 0.0) std::swap(a, b);
    stripes.push_back({a, b, piece.centre(), piece.radius, painted, static_cast<std::uint8_t>(piece.paint)});
  }
}

void add_stretch(const PathPiece& piece, double from, double to, bool painted, std::vector<Stripe>& stripes) {
  if (to - from <= kLeastStretch) return;
  const double turned = std::abs(piece.turn) * (to - from) / piece.length;
  const int parts = std::max(1, static_cast<int>(std::ceil(turned / (std::numbers::pi / 2.0) - 1e-9)));
  for (int i = 0; i < parts; ++i)
    add_part(piece, from + (to - from) * i / parts, from + (to - from) * (i + 1) / parts, painted, stripes);
}

}  // namespace

void add_stripes(const Path& path, const std::vector<Paint>& paints, std::vector<Stripe>& stripes) {
  std::vector<double> half_widths;
  for (const PathPiece& piece : path.pieces())
    half_widths.push_back(paints[static_cast<std::size_t>(piece.paint)].width / 2.0);
  const std::vector<Unpainted> gaps = gaps_of(path, half_widths);
  double begin = 0.0;
  for (const PathPiece& piece : path.pieces()) {
    double at = 0.0;
    for (const Unpainted& gap : gaps) {
      const double from = std::clamp(gap.from - begin, at, piece.length);
      const double to = std::clamp(gap.to - begin, from, piece.length);
      if (to <= from) continue;
      add_stretch(piece, at, from, true, stripes);
      add_stretch(piece, from, to, false, stripes);
      at = to;
    }
    add_stretch(piece, at, piece.length, true, stripes);
    begin += piece.length;
  }
}

}  // namespace robosim::map
