#include "sim/map/stripes.h"

#include "sim/map/corner.h"
#include "sim/map/path_stripes.h"

namespace robosim::map {
namespace {

constexpr double kNothing = 1e-9;  // in m: shorter pieces are rounding errors

// An unpainted interval of a leg, by distance from the leg's first cell.
struct Gap {
  double from;
  double to;
};

// A row of cells from `first` in the direction `d`. Cells are counted from 0; distances are in metres.
struct Leg {
  const Map& map;
  CellAt first;
  Direction d;

  CellAt cell(int n) const {
    const CellAt step = ahead({0, 0}, d);
    return {first.x + n * step.x, first.y + n * step.y};
  }
  Vec2 point(double t) const { return map.centre(first) + heading(d) * t; }

  /// Returns the gaps among the first `count` cells, sorted and without overlap. Paint reaches half a line's
  /// width beyond a stripe's end, so a gap shortens the neighbouring stripes by this length. A single painted
  /// cell between gaps always remains partly painted.
  std::vector<Gap> gaps(int count) const {
    const double beside = std::min(map.line_m / 2, map.cell_m * 0.45);
    std::vector<Gap> found;
    for (int n = 0; n < count; ++n) {
      if (map.at(cell(n)) != Cell::gap) continue;
      const double from = (n - 0.5) * map.cell_m - beside;
      const double to = (n + 0.5) * map.cell_m + beside;
      if (!found.empty() && found.back().to > from)
        found.back().to = to;
      else
        found.push_back({from, to});
    }
    return found;
  }
};

// Calls piece(from, to, painted), in order, for the parts into which gaps divide a stretch of a leg.
template <typename Piece>
void cut(double from, double to, const std::vector<Gap>& gaps, Piece piece) {
  const auto part = [&](double begin, double end, bool painted) {
    if (end - begin > kNothing) piece(begin, end, painted);
  };
  for (const Gap& gap : gaps) {
    const double begin = std::clamp(gap.from, from, to);
    const double end = std::clamp(gap.to, from, to);
    part(from, begin, true);
    part(begin, end, false);
    from = end;
  }
  part(from, to, true);
}

class Builder {
 public:
  Builder(const Map& map, std::vector<Stripe>& stripes) : map_(map), stripes_(stripes) {}

  // Adds the run of line cells from `first` to the east or north, without the arcs at its ends.
  void add_run(CellAt first, Direction d) {
    const Leg leg{map_, first, d};
    int last = 1;
    while (is_line(map_.at(leg.cell(last + 1)))) ++last;
    const double begin = radius_at(first);
    const double end = last * map_.cell_m - radius_at(leg.cell(last));
    const Vec2 far = map_.centre(leg.cell(last));
    cut(begin, end, leg.gaps(last + 1), [&](double from, double to, bool painted) {
      const bool whole = to == last * map_.cell_m;
      stripes_.push_back({leg.point(from), whole ? far : leg.point(to), {}, 0.0, painted});
    });
  }

  void add_arc(const Corner& corner) {
    const Leg first{map_, corner.cell, corner.first};
    const Leg second{map_, corner.cell, corner.second};
    const double r = corner.radius;
    const Vec2 centre = map_.centre(corner.cell) + (heading(corner.first) + heading(corner.second)) * r;
    const int cells = static_cast<int>(r / map_.cell_m) + 2;
    const std::size_t begun = stripes_.size();
    const auto add = [&](Vec2 a, Vec2 b, bool painted) {
      if (stripes_.size() > begun && stripes_.back().painted == painted)
        stripes_.back().b = b;
      else
        stripes_.push_back({a, b, centre, r, painted});
    };

    // Each half of the arc is painted where the leg next to it is painted. At distance t from the corner, an
    // arc of radius r is r - sqrt(r^2 - (r-t)^2) away from the leg.
    const auto at = [&](const Leg& leg, const Leg& other, double t) {
      const double side = r - std::sqrt(std::max(r * r - (r - t) * (r - t), 0.0));
      return leg.point(t) + heading(other.d) * side;
    };
    struct Piece {
      double from;
      double to;
      bool painted;
    };
    std::vector<Piece> pieces;
    cut(corner.middle(), r, first.gaps(cells), [&](double from, double to, bool painted) {
      pieces.push_back({from, to, painted});
    });
    for (auto p = pieces.rbegin(); p != pieces.rend(); ++p)
      add(at(first, second, p->to), at(first, second, p->from), p->painted);
    cut(corner.middle(), r, second.gaps(cells), [&](double from, double to, bool painted) {
      add(at(second, first, from), at(second, first, to), painted);
    });
  }

  void add_dot(CellAt cell) {
    const Vec2 p = map_.centre(cell);
    stripes_.push_back({p, p, {}, 0.0, map_.at(cell) != Cell::gap});
  }

 private:
  double radius_at(CellAt cell) const {
    if (map_.corner_m <= 0.0) return 0.0;
    const auto corner = corner_at(map_, cell);
    return corner ? corner->radius : 0.0;
  }

  const Map& map_;
  std::vector<Stripe>& stripes_;
};

template <typename Visit>
void for_each_line_cell(const Map& map, Visit visit) {
  for (std::size_t i = 0; i < map.cells.size(); ++i)
    if (is_line(map.cells[i])) visit(map.cell_at(i));
}

}  // namespace

std::vector<TightBend> tight_bends(const Map& map) {
  std::vector<TightBend> tight;
  if (map.corner_m <= 0.0) return tight;
  for_each_line_cell(map, [&](CellAt cell) {
    const auto corner = corner_at(map, cell);
    if (corner && is_tight(map, *corner)) tight.push_back({cell, corner->radius});
  });
  return tight;
}

Stripes::Stripes(const Map& map, double reach_m) : map_(&map) {
  Builder builder(map, stripes_);
  for_each_line_cell(map, [&](CellAt cell) {
    const unsigned lines = line_neighbours(map, cell);
    if (lines == 0) builder.add_dot(cell);
    if (has(lines, Direction::east) && !has(lines, Direction::west)) builder.add_run(cell, Direction::east);
    if (has(lines, Direction::north) && !has(lines, Direction::south))
      builder.add_run(cell, Direction::north);
    if (map.corner_m <= 0.0) return;
    const auto corner = corner_at(map, cell);
    if (!corner) return;
    builder.add_arc(*corner);
    if (is_tight(map, *corner)) tight_.push_back({cell, corner->radius});
  });
  const std::vector<Paint> paints = paints_of(map);
  for (const Path& path : map.course.paths) add_stripes(path, paints, stripes_);
  index_ = StripeIndex(map, stripes_, reach_m);
}

Pose Stripes::pose_of(const Start& start) const {
  if (start.on_path) return path_pose(*map_, *start.on_path);
  return {point_of(start.cell), heading(start.facing)};
}

Vec2 Stripes::point_of(CellAt cell) const {
  const Vec2 p = map_->centre(cell);
  const auto corner = corner_over(*map_, cell);
  if (!corner) return p;
  const Vec2 centre =
      map_->centre(corner->cell) + (heading(corner->first) + heading(corner->second)) * corner->radius;
  const Vec2 spoke = p - centre;
  return centre + spoke * (corner->radius / length(spoke));
}

}  // namespace robosim::map
