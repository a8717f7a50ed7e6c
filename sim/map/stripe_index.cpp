#include "sim/map/stripe_index.h"

#include <algorithm>
#include <cmath>

#include "sim/map/stripes.h"

namespace robosim::map {
namespace {

// A margin added to the reach, so that rounding never hides a stripe whose distance is exactly the reach.
constexpr double kSlack = 1e-9;  // in m

struct Box {
  double west, east, south, north;
  void hold(Vec2 p) {
    west = std::min(west, p.x), east = std::max(east, p.x);
    south = std::min(south, p.y), north = std::max(north, p.y);
  }
};

// Returns the bounding box of a stripe. An arc may extend beyond its ends, for example to the north if it
// passes due north of its centre.
Box box_of(const Stripe& s) {
  Box box{s.a.x, s.a.x, s.a.y, s.a.y};
  box.hold(s.b);
  for (const Vec2 way : {Vec2{1, 0}, Vec2{0, 1}, Vec2{-1, 0}, Vec2{0, -1}})
    if (s.radius > 0.0 && cross(s.a - s.centre, way) >= 0.0 && cross(way, s.b - s.centre) >= 0.0)
      box.hold(s.centre + way * s.radius);
  return box;
}

// Calls visit(cell) for every cell of the map that has a point within reach of the stripe.
template <typename Visit>
void visit_cells(const Map& map, const Stripe& s, double reach, Visit visit) {
  const auto [west, east, south, north] = box_of(s);
  const double c = map.cell_m;
  const auto column = [&](double x) {
    return static_cast<int>(std::clamp(std::floor(x / c), 0.0, static_cast<double>(map.width - 1)));
  };
  const auto row = [&](double y) {
    return map.height - 1 -
           static_cast<int>(std::clamp(std::floor(y / c), 0.0, static_cast<double>(map.height - 1)));
  };
  const double half_diagonal = c * 0.70710678118654757;
  CellAt cell;
  for (cell.y = row(north + reach); cell.y <= row(south - reach); ++cell.y) {
    for (cell.x = column(west - reach); cell.x <= column(east + reach); ++cell.x) {
      const Vec2 middle = map.centre(cell);
      const double dx = std::max({west - (middle.x + c / 2), middle.x - c / 2 - east, 0.0});
      const double dy = std::max({south - (middle.y + c / 2), middle.y - c / 2 - north, 0.0});
      if (dx * dx + dy * dy > reach * reach) continue;
      const bool is_slanted = s.radius > 0.0 || (s.a.x != s.b.x && s.a.y != s.b.y);
      if (is_slanted && distance(s, middle) > reach + half_diagonal) continue;
      visit(cell);
    }
  }
}

}  // namespace

StripeIndex::StripeIndex(const Map& map, std::span<const Stripe> stripes, double reach_m)
    : width_(map.width),
      height_(map.height),
      block_columns_(static_cast<std::size_t>((map.width + kSide - 1) >> kShift)),
      blocks_(block_columns_ * static_cast<std::size_t>((map.height + kSide - 1) >> kShift), kEmpty) {
  const double reach = reach_m + kSlack;
  std::size_t total = 0;
  std::uint32_t used = 0;
  for (const Stripe& stripe : stripes)
    visit_cells(map, stripe, reach, [&](CellAt cell) {
      std::uint32_t& block = blocks_[block_of(cell)];
      if (block == kEmpty) {
        block = used++;
        first_.resize(first_.size() + kSide * kSide);
      }
      ++first_[slot_of(block, cell)];
      ++total;
    });
  if (total >= kEmpty || stripes.size() >= kEmpty)
    throw InputError({map.file}, "the map has too much line to drive on; robosim classic can still walk it");

  // Converts the counts to end positions. Filling a slot backwards turns its end position into its beginning.
  std::uint32_t end = 0;
  for (std::uint32_t& slot : first_) slot = end += slot;
  first_.push_back(end);
  entries_.resize(total);
  for (std::size_t i = stripes.size(); i-- > 0;)
    visit_cells(map, stripes[i], reach, [&](CellAt cell) {
      entries_[--first_[slot_of(blocks_[block_of(cell)], cell)]] = static_cast<std::uint32_t>(i);
    });
}

}  // namespace robosim::map
