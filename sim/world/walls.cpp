#include "sim/world/walls.h"

#include <cmath>
#include <limits>

namespace robosim::world {

namespace {

bool stops(grid::Cell c) { return c == grid::Cell::wall || c == grid::Cell::obstacle; }

void keep_deepest(std::optional<Contact>& best, const Contact& contact) {
  if (!best || contact.depth > best->depth) best = contact;
}

Vec2 nearest_on_segment(Vec2 a, Vec2 b, Vec2 p) {
  const Vec2 d = b - a;
  const double t = std::clamp(dot(p - a, d) / dot(d, d), 0.0, 1.0);
  return a + d * t;
}

}  // namespace

Walls::Walls(const grid::Map& map)
    : map_(&map), per_cell_(1.0 / map.cell_m), columns_(map.width), rows_(map.height) {
  const auto width = static_cast<std::size_t>(map.width), height = static_cast<std::size_t>(map.height);
  rings_.resize(width * height);
  // Chessboard distance to the nearest solid cell, in two sweeps; what lies beyond the edge is solid.
  for (std::size_t y = 0; y < height; ++y) {
    const grid::Cell* cells = map.cells.data() + (height - 1 - y) * width;
    for (std::size_t x = 0; x < width; ++x) {
      int rings = 0;
      if (!stops(cells[x]) && x > 0 && y > 0) {
        const std::uint8_t* below = &rings_[(y - 1) * width + x];
        rings = std::min<int>(below[width - 1], below[-1]);
        rings = std::min<int>(rings, std::min<int>(below[0], x + 1 < width ? below[1] : 0));
      }
      rings_[y * width + x] = stops(cells[x]) ? 0 : static_cast<std::uint8_t>(std::min(rings + 1, 255));
    }
  }
  for (std::size_t y = height; y-- > 0;) {
    for (std::size_t x = width; x-- > 0;) {
      std::uint8_t& here = rings_[y * width + x];
      int rings = 0;
      if (x + 1 < width && y + 1 < height) {
        const std::uint8_t* above = &rings_[(y + 1) * width + x];
        rings = std::min<int>(rings_[y * width + x + 1], above[1]);
        rings = std::min<int>(rings, std::min<int>(above[0], x > 0 ? above[-1] : 0));
      }
      here = static_cast<std::uint8_t>(std::min<int>(here, rings + 1));
    }
  }
}

bool Walls::solid(int column, int row) const {
  if (column < 0 || row < 0 || column >= map_->width || row >= map_->height) return true;
  return rings_[static_cast<std::size_t>(row) * static_cast<std::size_t>(map_->width) +
                static_cast<std::size_t>(column)] == 0;
}

int Walls::add(Vec2 centre, double radius_m) {
  discs_.push_back({next_id_, centre, radius_m});
  return next_id_++;
}

void Walls::remove(int id) {
  std::erase_if(discs_, [id](const Disc& d) { return d.id == id; });
}

bool Walls::near_disc(Vec2 centre, double radius) const {
  for (const Disc& disc : discs_) {
    const Vec2 d = centre - disc.centre;
    const double reach = radius + disc.radius_m + kNear;
    if (dot(d, d) < reach * reach) return true;
  }
  return false;
}

double Walls::stride(double body_radius) const {
  double least = map_->cell_m;
  for (const Disc& disc : discs_) least = std::min(least, body_radius + disc.radius_m);
  return 0.25 * least;
}

namespace {

// Cells that a box about a disc meets, one beyond the map's edge at most.
struct Window {
  int left, right, bottom, top;
  Window(Vec2 centre, double reach, double per_cell, double columns, double rows) {
    const auto cell = [](double x, double most) {
      return static_cast<int>(std::floor(std::clamp(x, -1.0, most)));
    };
    left = cell((centre.x - reach) * per_cell, columns);
    right = cell((centre.x + reach) * per_cell, columns);
    bottom = cell((centre.y - reach) * per_cell, rows);
    top = cell((centre.y + reach) * per_cell, rows);
  }
};

}  // namespace

std::optional<Contact> Walls::touch(Vec2 centre, double radius) const {
  std::optional<Contact> best;
  const double reach = radius + kNear;
  const double side = map_->cell_m;
  const Window window(centre, reach, per_cell_, columns_, rows_);
  for (int row = window.bottom; row <= window.top; ++row) {
    for (int column = window.left; column <= window.right; ++column) {
      if (!solid(column, row)) continue;
      const double x0 = column * side, y0 = row * side;
      const Vec2 nearest = {std::clamp(centre.x, x0, x0 + side), std::clamp(centre.y, y0, y0 + side)};
      const Vec2 d = centre - nearest;
      const double square = dot(d, d);
      if (square >= reach * reach) continue;
      if (square > 0.0) {
        const double away = std::sqrt(square);
        keep_deepest(best, {nearest, d * (1.0 / away), radius - away});
        continue;
      }
      // The centre is inside the cell: out by the nearest open side.
      Contact out{centre, {}, std::numeric_limits<double>::infinity(), true};
      const auto side_at = [&](bool open, double inside, Vec2 normal) {
        if (open && inside + radius < out.depth) out = {centre, normal, inside + radius, false};
      };
      side_at(!solid(column - 1, row), centre.x - x0, {-1.0, 0.0});
      side_at(!solid(column + 1, row), x0 + side - centre.x, {1.0, 0.0});
      side_at(!solid(column, row - 1), centre.y - y0, {0.0, -1.0});
      side_at(!solid(column, row + 1), y0 + side - centre.y, {0.0, 1.0});
      return out;
    }
  }
  for (const Disc& disc : discs_) {
    const Vec2 d = centre - disc.centre;
    const double away = length(d);
    const double depth = radius + disc.radius_m - away;
    if (depth <= -kNear) continue;
    const Vec2 normal = away > 0.0 ? d * (1.0 / away) : Vec2{1.0, 0.0};
    keep_deepest(best, {disc.centre + normal * disc.radius_m, normal, depth});
  }
  return best;
}

std::optional<Contact> Walls::touch(std::span<const Vec2> polygon, Vec2 centre, double radius) const {
  std::optional<Contact> best;
  const double side = map_->cell_m;
  const Window window(centre, radius + kNear, per_cell_, columns_, rows_);
  const std::size_t corners = polygon.size();
  for (int row = window.bottom; row <= window.top; ++row) {
    for (int column = window.left; column <= window.right; ++column) {
      if (!solid(column, row)) continue;
      // Separating axes of two convex shapes. A side that faces another solid cell pushes nobody out.
      const Vec2 low{column * side, row * side}, high{low.x + side, low.y + side};
      Contact least{{}, {}, std::numeric_limits<double>::infinity(), true};
      bool apart = false;
      const auto face = [&](Vec2 normal, Vec2 on, bool open) {
        double deepest = -std::numeric_limits<double>::infinity();
        Vec2 point;
        int points = 0;
        for (const Vec2 p : polygon) {
          const double depth = dot(normal, on - p);
          if (depth > deepest + 1e-9) {
            deepest = depth;
            point = p;
            points = 1;
          } else if (depth > deepest - 1e-9) {
            point = point + p;
            ++points;
          }
        }
        apart |= deepest <= -kNear;
        if (open && deepest < least.depth) least = {point * (1.0 / points), normal, deepest, false};
      };
      face({-1.0, 0.0}, low, !solid(column - 1, row));
      face({0.0, -1.0}, low, !solid(column, row - 1));
      face({1.0, 0.0}, high, !solid(column + 1, row));
      face({0.0, 1.0}, high, !solid(column, row + 1));
      for (std::size_t i = 0; i < corners && !apart; ++i) {
        const Vec2 a = polygon[i], edge = polygon[i + 1 < corners ? i + 1 : 0] - a;
        const double span = length(edge);
        const Vec2 outward{edge.y / span, -edge.x / span};
        double deepest = -std::numeric_limits<double>::infinity();
        Vec2 point;
        bool open = false;
        for (int corner = 0; corner < 4; ++corner) {
          const bool east = corner & 1, north = corner & 2;
          const Vec2 p{east ? high.x : low.x, north ? high.y : low.y};
          const double depth = dot(outward, a - p);
          if (depth <= deepest) continue;
          deepest = depth;
          point = p;
          open = !solid(column + (east ? 1 : -1), row) && !solid(column, row + (north ? 1 : -1));
        }
        apart |= deepest <= -kNear;
        if (open && deepest < least.depth) least = {point, outward * -1.0, deepest, false};
      }
      if (!apart && !least.embedded) keep_deepest(best, least);
    }
  }
  for (const Disc& disc : discs_) {
    double nearest = std::numeric_limits<double>::infinity();
    Vec2 point;
    bool inside = true;
    for (std::size_t i = 0; i < corners; ++i) {
      const Vec2 a = polygon[i], b = polygon[i + 1 < corners ? i + 1 : 0];
      inside &= cross(b - a, disc.centre - a) >= 0.0;
      const Vec2 q = nearest_on_segment(a, b, disc.centre);
      if (length(q - disc.centre) >= nearest) continue;
      nearest = length(q - disc.centre);
      point = q;
    }
    const double depth = disc.radius_m + (inside ? nearest : -nearest);
    if (depth <= -kNear || nearest == 0.0) continue;
    const Vec2 normal = (point - disc.centre) * ((inside ? -1.0 : 1.0) / nearest);
    keep_deepest(best, {point, normal, depth});
  }
  return best;
}

}  // namespace robosim::world
