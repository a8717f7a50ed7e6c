// Computes a tick of a body that simply rolls: both tyres grip, both wheels keep their direction, and no
// obstacle is near. This is by far the most common case. The code has no branches, and its results equal
// those of body.cpp bit for bit. One template serves a single body and many bodies at once (simd_pair.h).
#pragma once

#include "sim/world/simd_pair.h"
#include "sim/world/step_constants.h"

namespace robosim::world {

// Slower motion counts as standing still. Otherwise, decaying speeds would become denormal numbers, whose
// arithmetic takes 30 times as long.
constexpr double kStill = 1e-6;  ///< m/s, rad/s

/// A rolling body's parameters and motor commands, named as in Body.
template <class Both>
struct Roller {
  // Computed from the commands.
  Both direction, drives;  ///< sign and magnitude of `drive`
  Both push, drag, push_until;
  Both brake_push, brake_drag, brake_from;
  // Copied from the body.
  Both per_radius, inertia, turning_friction, joule0, joule1, side_share;
  Both owns;          ///< kg: mass_own + inertia
  Both grip_squares;  ///< grip_limit squared
  double skids_from;  ///< N s per tick: kSkidShare times the sum of both grip limits
  double mass, mass_own, mass_cross, half_track, per_track, bound_radius, way_per_travel;
};

/// The state of a rolling body.
template <class Both>
struct Rolling {
  double x, y, heading_x, heading_y;
  double v, omega;
  Both surface, angle;
  double wheel_travel, distance, energy, free_way;
};

/// Computes the next tick of a body without sideways speed (u = 0). `stride` is the result of
/// Walls::stride(). Returns whether the body simply rolls on. Otherwise, `next` is not valid.
template <class Both>
inline Sure<Both> roll(const Roller<Both>& body, double stride, const Rolling<Both>& now,
                       Rolling<Both>& next) {
  constexpr Both kNone{0.0, 0.0};
  Sure<Both> sure;
  const double v = now.v, omega = now.omega;
  const Both s = now.surface;

  // Computes the motors' impulses like Body::motor().
  Both push = where_less(body.direction * s, body.push_until, body.push, kNone);
  Both drag = where_less(body.direction * s, body.push_until, body.drag, kNone);
  push = push + where_less(body.brake_from, abs_of(s), signed_as(body.brake_push, s), kNone);
  drag = drag + where_less(body.brake_from, abs_of(s), body.brake_drag, kNone);

  const double travel = (std::fabs(v) + std::fabs(omega) * body.bound_radius) * kDt;
  sure.is_at_most(travel, stride);
  next.free_way = now.free_way - body.way_per_travel * travel;
  sure.is_less(0.0, next.free_way);  // else walls must be checked

  // Moves the body like Body::advance() and Body::pose_after().
  const double a = omega * kDt;
  const double a2 = a * a;
  const double sine = a * (1.0 - a2 * (1.0 / 6.0 - a2 * (1.0 / 120.0)));
  const double cosine = 1.0 - a2 * (0.5 - a2 * (1.0 / 24.0));
  const double mean_sine = a * (0.5 - a2 * (1.0 / 24.0));
  const double mean_cosine = 1.0 - a2 * (1.0 / 6.0 - a2 * (1.0 / 120.0));
  const double hx = now.heading_x, hy = now.heading_y;
  const double tx = hx * cosine + -hy * sine, ty = hy * cosine + hx * sine;
  const double ahead = kDt * (v * mean_cosine), aside = kDt * (v * mean_sine);
  next.x = now.x + hx * ahead + -hy * aside;
  next.y = now.y + hy * ahead + hx * aside;
  const double norm = 1.5 - 0.5 * (tx * tx + ty * ty);
  next.heading_x = tx * norm;
  next.heading_y = ty * norm;
  const double side_free = -((hx * next.heading_y - hy * next.heading_x) * v);
  next.angle = now.angle + s * body.per_radius * kDt;
  next.wheel_travel = now.wheel_travel + 0.5 * (std::fabs(s[0]) + std::fabs(s[1])) * kDt;
  next.distance = now.distance + std::fabs(v) * kDt;

  // Computes the new speeds like Body::accelerate().
  const double sideways = -side_free * body.mass;
  sure.is_at_most(std::fabs(sideways), body.skids_from);
  const double own = body.mass_own, other = body.mass_cross;
  const double turn = omega * body.half_track;
  const Both ground{v - turn, v + turn};
  const Both momentum = ground * own + swapped(ground) * other;
  const Both impulse = momentum + body.inertia * s + push;
  const Both owns = body.owns + drag;
  const double per_determinant = 1.0 / (owns[0] * owns[1] - other * other);
  const Both p = impulse - signed_as(body.turning_friction, s);
  const Both y = (swapped(owns) * p - swapped(p) * other) * per_determinant;
  sure.is_less(kNone, y * s);  // else friction may hold a wheel
  const Both traction = y * own + swapped(y) * other - momentum;
  const Both side = body.side_share * sideways;
  sure.is_at_most(traction * traction, body.grip_squares - side * side);  // else a tyre slips
  next.surface = y;
  next.v = 0.5 * (y[0] + y[1]);
  next.omega = (y[1] - y[0]) * body.per_track;
  const double treads = std::fabs(y[0]) + std::fabs(y[1]);
  sure.is_at_most(treads, kMaxSpeed);
  sure.is_at_most(std::fabs(next.omega), kMaxTurn);

  // Adds the motors' energy like Body::draw_energy().
  const Both joules = body.joule0 - body.joule1 * (body.direction * y);
  const Both drawn = body.drives * where_less(joules, kNone, kNone, joules);
  next.energy = now.energy + drawn[0] + drawn[1];
  sure.is_at_most(kStill, body.drives[0] + body.drives[1] + 0.5 * treads);  // else the body may come to rest
  return sure;
}

}  // namespace robosim::world
