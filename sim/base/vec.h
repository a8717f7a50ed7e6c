// Defines plane geometry. World frame: x east, y north, metres; headings counter-clockwise from east.
#pragma once

#include <cmath>

namespace robosim {

struct Vec2 {
  double x = 0.0;
  double y = 0.0;
};

constexpr Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
constexpr Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
constexpr Vec2 operator*(Vec2 a, double k) { return {a.x * k, a.y * k}; }
constexpr Vec2 operator*(double k, Vec2 a) { return a * k; }
constexpr bool operator==(Vec2 a, Vec2 b) { return a.x == b.x && a.y == b.y; }
constexpr double dot(Vec2 a, Vec2 b) { return a.x * b.x + a.y * b.y; }
/// Returns the cross product, positive if b is to the left of a.
constexpr double cross(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }
/// Returns `a` rotated by a quarter turn counter-clockwise.
constexpr Vec2 left_of(Vec2 a) { return {-a.y, a.x}; }
inline double length(Vec2 a) { return std::sqrt(dot(a, a)); }

/// A body's position and heading. The heading is a unit vector. A tick rotates this vector without libm's
/// sine and cosine: the result must have the same bits on every machine.
struct Pose {
  Vec2 position;           ///< m
  Vec2 heading{1.0, 0.0};  ///< unit vector

  /// Converts a point from the body's frame (x forward, y left) to the world frame.
  constexpr Vec2 to_world(Vec2 body) const { return position + heading * body.x + left_of(heading) * body.y; }
  /// Converts a point from the world frame to the body's frame.
  constexpr Vec2 to_body(Vec2 world) const {
    const Vec2 d = world - position;
    return {dot(heading, d), cross(heading, d)};
  }
  /// Returns the heading in radians, -pi..pi. Only for display and recordings, never inside a tick.
  double yaw() const { return std::atan2(heading.y, heading.x); }
};

}  // namespace robosim
