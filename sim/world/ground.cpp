#include "sim/world/ground.h"

#include <algorithm>
#include <cmath>

#include "sim/world/step_constants.h"

namespace robosim::world {

namespace {

constexpr double kPoint = 1e-9;  // m: least reach of a wheel; avoids a division by 0

// The profile along a hill.
struct CrossSection {
  const map::Hill& hill;
  double sine;  // sine of a seesaw's slope

  std::size_t corners() const { return hill.heights.empty() ? 2 : hill.heights.size(); }
  double at(std::size_t corner) const {
    return -hill.half_length +
           2.0 * hill.half_length * static_cast<double>(corner) / static_cast<double>(corners() - 1);
  }
  double height(std::size_t corner) const {
    return hill.heights.empty() ? hill.pivot + sine * at(corner) : hill.heights[corner];
  }
};

struct Top {
  double height = 0.0;  // m; height of the wheel's lowest point above the floor
  double slope = 0.0;   // along the hill
};

// Returns how a wheel at `s` rests on a profile. `reach` is the wheel's extent along the hill. `high` is the
// distance from the wheel's middle down to its contact point, m.
Top top_of(const CrossSection& profile, double s, double reach, double radius, double high) {
  Top top{-1.0, 0.0};
  const auto take = [&top](double height, double slope) {
    if (height > top.height) top = {height, std::clamp(slope, -kSteepest, kSteepest)};
  };
  double from = profile.at(0), low = profile.height(0);
  for (std::size_t i = 0;;) {
    const double away = from - s;
    if (std::fabs(away) < reach) {
      const double share = away / reach, left = std::sqrt(1.0 - share * share);
      take(low + high * left - radius, left > 0.0 ? high * share / (reach * left) : 0.0);
    }
    if (++i == profile.corners()) break;
    const double to = profile.at(i), up = profile.height(i);
    const double slope = (up - low) / (to - from);
    const double lift = std::sqrt(high * high + slope * slope * reach * reach);
    const double touch = lift > 0.0 ? s + slope * reach * reach / lift : s;
    if (touch >= from && touch <= to) take(low + slope * (s - from) + lift - radius, slope);
    from = to;
    low = up;
  }
  return top;
}

}  // namespace

Ground::Ground(const map::Map& map)
    : hills_(map.course.hills),
      surfaces_(map.course.surfaces),
      joints_(map.course),
      legend_surfaces_(map.legend_surfaces),
      surface_of_cell_(map.surface_of_cell),
      columns_(map.width),
      rows_(map.height),
      cell_m_(map.cell_m) {
  for (const map::Hill& hill : hills_)
    state_.seesaws.push_back({hill.pivot > 0.0 ? hill.pivot / hill.half_length : 0.0, 0.0, 0.0, 0.0});
}

Footing Ground::under(Vec2 p, Vec2 along, double radius, bool ball) const {
  Footing footing;
  for (std::size_t i = 0; i < hills_.size(); ++i) {
    const map::Hill& hill = hills_[i];
    const Vec2 own = hill.middle.to_body(p);
    const double beyond = std::fabs(own.x) - hill.half_length, beside = std::fabs(own.y) - hill.half_width;
    if (beyond > radius || beside > radius) continue;
    const Vec2 axis = hill.middle.heading;
    double reach = ball ? radius : radius * std::fabs(dot(along, axis));
    double high = radius, across = 0.0;
    if (beside > 0.0) {
      const double aside = ball ? radius : radius * std::fabs(cross(along, axis));
      if (beside >= aside) continue;
      const double share = beside / aside, left = std::sqrt(1.0 - share * share);
      reach *= left;
      high *= left;
      across = std::min(share / aside * radius / left, kSteepest);
    }
    const Top top = top_of({hill, state_.seesaws[i].sine}, own.x, std::max(reach, kPoint), radius, high);
    if (!(top.height > footing.height)) continue;
    footing.height = top.height;
    footing.rise = axis * top.slope + left_of(axis) * (own.y > 0.0 ? -across : across);
  }
  return footing;
}

Footing Ground::under_wheel(Vec2 p, Vec2 rolls, double radius) const {
  return under(p, rolls, radius, false);
}

Footing Ground::under_ball(Vec2 p, double radius) const { return under(p, {}, radius, true); }

double Ground::height(Vec2 p) const { return under(p, {}, 0.0, true).height; }

Ground::Kind Ground::kind(Vec2 p) const {
  for (std::size_t i = surfaces_.size(); i-- > 0;)
    if (surfaces_[i].contains(p)) return surfaces_[i];
  if (surface_of_cell_.empty()) return {};
  const double x = std::floor(p.x / cell_m_), y = std::floor(p.y / cell_m_);
  if (!(x >= 0.0 && y >= 0.0 && x < columns_ && y < rows_)) return {};
  const auto row = static_cast<std::size_t>(rows_ - 1 - static_cast<int>(y));
  const std::uint8_t which =
      surface_of_cell_[row * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(x)];
  return which ? legend_surfaces_[which - 1u] : Kind{};
}

void Ground::press(Vec2 p, double mass, double force) {
  for (std::size_t i = 0; i < hills_.size(); ++i) {
    if (!(hills_[i].pivot > 0.0) || !hills_[i].contains(p)) continue;
    const double s = dot(p - hills_[i].middle.position, hills_[i].middle.heading);
    state_.seesaws[i].torque -= force * s;
    state_.seesaws[i].inertia += mass * s * s;
  }
}

void Ground::settle() {
  for (std::size_t i = 0; i < hills_.size(); ++i) {
    const map::Hill& hill = hills_[i];
    if (!(hill.pivot > 0.0)) continue;
    Seesaw& seesaw = state_.seesaws[i];
    const double most = hill.pivot / hill.half_length;
    const double own = hill.plank_kg * hill.half_length * hill.half_length / 3.0;
    seesaw.rate += seesaw.torque / (own + seesaw.inertia) * kDt;
    seesaw.sine += seesaw.rate * kDt;
    seesaw.torque = seesaw.inertia = 0.0;
    if (std::fabs(seesaw.sine) < most) continue;
    seesaw.sine = seesaw.sine > 0.0 ? most : -most;
    seesaw.rate = 0.0;
  }
}

double Ground::heave() const {
  double most = 0.0;
  for (std::size_t i = 0; i < hills_.size(); ++i)
    most = std::max(most, std::fabs(state_.seesaws[i].rate) * hills_[i].half_length * kDt);
  return most;
}

}  // namespace robosim::world
