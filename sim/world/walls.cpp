#include "sim/world/walls.h"

#include <cmath>
#include <limits>

namespace robosim::world {

namespace {

bool stops(map::Cell c) { return c == map::Cell::wall || c == map::Cell::obstacle; }

Vec2 nearest_on_segment(Vec2 a, Vec2 b, Vec2 p) {
  const Vec2 d = b - a;
  const double t = std::clamp(dot(p - a, d) / dot(d, d), 0.0, 1.0);
  return a + d * t;
}

}  // namespace

void Contacts::add(const Contact& contact) {
  std::size_t at = std::min(size_, found_.size() - 1);
  if (size_ == found_.size() && contact.depth <= found_[at].depth) return;
  for (; at > 0 && found_[at - 1].depth < contact.depth; --at) found_[at] = found_[at - 1];
  found_[at] = contact;
  size_ = std::min(size_ + 1, found_.size());
}

Walls::Walls(const map::Map& map)
    : map_(&map), per_cell_(1.0 / map.cell_m), columns_(map.width), rows_(map.height) {
  const auto width = static_cast<std::size_t>(map.width), height = static_cast<std::size_t>(map.height);
  rings_.resize(width * height);
  // Computes the chessboard distance to the nearest solid cell, in two sweeps. Everything beyond the edge is
  // solid.
  for (std::size_t y = 0; y < height; ++y) {
    const map::Cell* cells = map.cells.data() + (height - 1 - y) * width;
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
  state_.discs.push_back({state_.next_id, centre, radius_m});
  return state_.next_id++;
}

void Walls::remove(int id) {
  std::erase_if(state_.discs, [id](const Disc& d) { return d.id == id; });
}

void Walls::move(int id, Vec2 centre) {
  for (Disc& disc : state_.discs)
    if (disc.id == id) disc.centre = centre;
}

const char* to_string(Solid solid) {
  switch (solid) {
    case Solid::wall:
      return "a wall";
    case Solid::obstacle:
      return "an obstacle";
    case Solid::edge:
      return "the map's edge";
  }
  return "";
}

Solid Walls::solid_at(const Contact& contact) const {
  const Vec2 inside = contact.point - contact.normal * (std::max(contact.depth, 0.0) + 2.0 * kNear);
  for (const Disc& disc : state_.discs)
    if (length(inside - disc.centre) <= disc.radius_m + kNear) return Solid::obstacle;
  const int column = static_cast<int>(std::floor(inside.x * per_cell_));
  const int row = map_->height - 1 - static_cast<int>(std::floor(inside.y * per_cell_));
  if (column < 0 || row < 0 || column >= map_->width || row >= map_->height) return Solid::edge;
  return map_->at({column, row}) == map::Cell::obstacle ? Solid::obstacle : Solid::wall;
}

bool Walls::near_disc(Vec2 centre, double radius) const {
  for (const Disc& disc : state_.discs) {
    const Vec2 d = centre - disc.centre;
    const double reach = radius + disc.radius_m + kNear;
    if (dot(d, d) < reach * reach) return true;
  }
  return false;
}

namespace {

// The range of cells that the bounding box of a disc covers. The range ends at most one cell beyond the map's
// edge.
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

bool Walls::beyond_edge(Vec2 p) const {
  const double x = p.x * per_cell_, y = p.y * per_cell_;
  return !(x >= -1.0 && y >= -1.0 && x <= columns_ + 1.0 && y <= rows_ + 1.0);
}

Contacts Walls::touch(Vec2 centre, double radius) const {
  Contacts found;
  if (beyond_edge(centre)) {
    found.add({centre, {}, 0.0, true});
    return found;
  }
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
        found.add({nearest, d * (1.0 / away), radius - away});
        continue;
      }
      // If the centre is inside the cell, moves it out of the cell through the nearest open side.
      Contact out{centre, {}, std::numeric_limits<double>::infinity(), true};
      const auto side_at = [&](bool open, double inside, Vec2 normal) {
        if (open && inside + radius < out.depth) out = {centre, normal, inside + radius, false};
      };
      side_at(!solid(column - 1, row), centre.x - x0, {-1.0, 0.0});
      side_at(!solid(column + 1, row), x0 + side - centre.x, {1.0, 0.0});
      side_at(!solid(column, row - 1), centre.y - y0, {0.0, -1.0});
      side_at(!solid(column, row + 1), y0 + side - centre.y, {0.0, 1.0});
      found = {};
      found.add(out);
      return found;
    }
  }
  for (const Disc& disc : state_.discs) {
    const Vec2 d = centre - disc.centre;
    const double away = length(d);
    const double depth = radius + disc.radius_m - away;
    if (depth <= -kNear) continue;
    const Vec2 normal = away > 0.0 ? d * (1.0 / away) : Vec2{1.0, 0.0};
    found.add({disc.centre + normal * disc.radius_m, normal, depth});
  }
  return found;
}

Contacts Walls::touch(std::span<const Vec2> polygon, Vec2 centre, double radius) const {
  Contacts found;
  if (beyond_edge(centre)) {
    found.add({centre, {}, 0.0, true});
    return found;
  }
  const Window window(centre, radius + kNear, per_cell_, columns_, rows_);
  for (int row = window.bottom; row <= window.top; ++row) {
    for (int column = window.left; column <= window.right; ++column) {
      if (solid(column, row)) touch_cell(polygon, column, row, found);
    }
  }
  const std::size_t corners = polygon.size();
  for (const Disc& disc : state_.discs) {
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
    found.add({point, normal, depth});
  }
  return found;
}

// Finds the axis on which the two convex shapes overlap least. A side of the cell that borders another solid
// cell does not push the polygon out. Neither does a corner at such a side.
void Walls::touch_cell(std::span<const Vec2> polygon, int column, int row, Contacts& found) const {
  const double side = map_->cell_m;
  const Vec2 low{column * side, row * side}, high{low.x + side, low.y + side};
  const bool open[4] = {!solid(column + 1, row), !solid(column, row + 1), !solid(column - 1, row),
                        !solid(column, row - 1)};
  constexpr Vec2 normals[4] = {{1.0, 0.0}, {0.0, 1.0}, {-1.0, 0.0}, {0.0, -1.0}};
  Contact least{{}, {}, std::numeric_limits<double>::infinity(), true};
  int face = -1;
  for (int i = 0; i < 4; ++i) {
    const double limit = dot(normals[i], i < 2 ? high : low);
    double reach = std::numeric_limits<double>::infinity();
    for (const Vec2 p : polygon) reach = std::min(reach, dot(normals[i], p));
    const double depth = limit - reach;
    if (depth <= -kNear) return;
    if (!open[i] || depth >= least.depth) continue;
    least = {{}, normals[i], depth, false};
    face = i;
  }
  for (std::size_t i = 0, n = polygon.size(); i < n; ++i) {
    const Vec2 a = polygon[i], edge = polygon[i + 1 < n ? i + 1 : 0] - a;
    const double span = length(edge);
    const Vec2 outward{edge.y / span, -edge.x / span};
    // Finds the cell's corner that is farthest in the direction opposite to `outward`. The corner counts only
    // if both of its sides are open.
    const bool east = outward.x < 0.0, north = outward.y < 0.0;
    const Vec2 corner{east ? high.x : low.x, north ? high.y : low.y};
    const double depth = dot(outward, a - corner);
    if (depth <= -kNear) return;
    if (!open[east ? 0 : 2] || !open[north ? 1 : 3] || depth >= least.depth) continue;
    least = {corner, outward * -1.0, depth, false};
    face = -1;
  }
  if (least.embedded) return;
  if (face < 0) {
    found.add(least);
    return;
  }
  // Contact with a side: reports every corner of the polygon that touches the side, so that a body in flat
  // contact does not rock. If no corner is over the side, reports the side's point nearest to the deepest
  // corner.
  const Vec2 n = least.normal;
  const double limit = dot(n, face < 2 ? high : low);
  Vec2 deepest;
  bool any = false;
  for (const Vec2 p : polygon) {
    const double depth = limit - dot(n, p);
    if (depth == least.depth) deepest = p;
    if (depth <= -kNear || depth > least.depth) continue;
    const bool over = n.x == 0.0 ? p.x >= low.x && p.x <= high.x : p.y >= low.y && p.y <= high.y;
    if (!over) continue;
    found.add({p, n, depth, false});
    any = true;
  }
  if (any) return;
  least.point = {std::clamp(deepest.x, low.x, high.x), std::clamp(deepest.y, low.y, high.y)};
  found.add(least);
}

}  // namespace robosim::world
