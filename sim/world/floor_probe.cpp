#include "sim/world/floor_probe.h"

#include <algorithm>
#include <utility>

namespace robosim::world {

namespace {

constexpr double kRounding = 1e-9;  // m: more than the rounding error of distances
// The smallest useful half side of a box, m. Leaving a box requires a new search, which costs more than
// evaluating a few stripes.
constexpr double kWorthwhile = 0.015;
// In m: a clear box is useful only if the point is at least this far from places where the footprint reaches
// a stripe.
constexpr double kBeside = 5e-4;
constexpr double kAlone = 5e-3;  // m; least half side of a box with one stripe; a smaller box stores two
constexpr double kDiagonal = 0.70710678118654752;

bool is_level(const map::Stripe& s) { return s.radius == 0.0 && s.a.y == s.b.y && s.a.x < s.b.x; }
bool is_upright(const map::Stripe& s) { return s.radius == 0.0 && s.a.x == s.b.x && s.a.y < s.b.y; }

// Reduces the box to a part around p in which no footprint reaches the stripe. Returns false if that part is
// too small.
bool keep_clear(FloorBox& box, const map::Stripe& s, double reach, double away, Vec2 p) {
  const double wide = reach + kRounding;
  if (!is_level(s) && !is_upright(s)) {
    const double way = kDiagonal * (away - wide);
    if (way < kWorthwhile) return false;
    box.keep(p, way);
    return true;
  }
  const double west = s.a.x - wide, east = s.b.x + wide, south = s.a.y - wide, north = s.b.y + wide;
  const double aside = std::max(west - p.x, p.x - east), along = std::max(south - p.y, p.y - north);
  if (std::max(aside, along) < kBeside) return false;
  if (aside > along)
    p.x < west ? box.high.x = std::min(box.high.x, west) : box.low.x = std::max(box.low.x, east);
  else
    p.y < south ? box.high.y = std::min(box.high.y, south) : box.low.y = std::max(box.low.y, north);
  return true;
}

bool is_within_quarter(const FloorBox& box, const map::Stripe& arc) {
  constexpr double kSure = 1e-12;  // m2
  for (const Vec2 corner : {box.low, box.high, Vec2{box.low.x, box.high.y}, Vec2{box.high.x, box.low.y}}) {
    const Vec2 w = corner - arc.centre;
    if (cross(arc.a - arc.centre, w) < kSure || cross(w, arc.b - arc.centre) < kSure) return false;
  }
  return true;
}

}  // namespace

void FloorBox::keep(Vec2 p, double way) {
  low = {std::max(low.x, p.x - way), std::max(low.y, p.y - way)};
  high = {std::min(high.x, p.x + way), std::min(high.y, p.y + way)};
}

double FloorProbe::distance_of_two(std::span<const map::Stripe> all, Vec2 p) const {
  const double first = map::distance(all[first_], p);
  return first_ == second_ ? first : std::min(first, map::distance(all[second_], p));
}

double FloorProbe::seek(const Around& around, Vec2 p) const {
  double nearest = kNoStripe, next = kNoStripe, third = kNoStripe;
  FloorBox clear = around.box;
  bool is_clear = around.reach < kNoStripe;
  first_ = second_ = 0;
  for (const std::uint32_t i : around.near) {
    const map::Stripe& stripe = around.all[i];
    if (around.painted_only && !stripe.painted) continue;
    const double away = map::distance(stripe, p);
    is_clear = is_clear && keep_clear(clear, stripe, around.reach, away, p);
    if (away < nearest) {
      third = next;
      next = std::exchange(nearest, away);
      second_ = std::exchange(first_, i);
    } else if (away < next) {
      third = std::exchange(next, away);
      second_ = i;
    } else {
      third = std::min(third, away);
    }
  }
  box_ = is_clear ? clear : around.box;
  kind_ = is_clear ? Kind::clear : Kind::two;
  if (is_clear) return nearest;
  if (nearest == kNoStripe) {
    box_ = {};
    return nearest;
  }
  // If a point moves by half the difference of the two distances, the other stripe is not yet nearer.
  const double alone = kDiagonal * 0.5 * (next - nearest) - kRounding;
  if (alone < kAlone) {
    box_.keep(p, kDiagonal * 0.5 * (third - nearest) - kRounding);
  } else {
    box_.keep(p, alone);
    second_ = first_;
    beside(around.all[first_], p);
  }
  return nearest;
}

// Selects a simpler formula for the distance to the only stripe that matters in the box.
void FloorProbe::beside(const map::Stripe& stripe, Vec2 p) const {
  at_ = stripe.radius > 0.0 ? stripe.centre : stripe.a;
  radius_ = stripe.radius;
  if (is_level(stripe) && p.x > stripe.a.x && p.x < stripe.b.x) {
    kind_ = Kind::level;
    box_.low.x = std::max(box_.low.x, stripe.a.x);
    box_.high.x = std::min(box_.high.x, stripe.b.x);
  } else if (is_upright(stripe) && p.y > stripe.a.y && p.y < stripe.b.y) {
    kind_ = Kind::upright;
    box_.low.y = std::max(box_.low.y, stripe.a.y);
    box_.high.y = std::min(box_.high.y, stripe.b.y);
  } else if (stripe.radius > 0.0 && is_within_quarter(box_, stripe)) {
    kind_ = Kind::arc;
  }
}

}  // namespace robosim::world
