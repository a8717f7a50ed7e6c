// Simulates bodies with steered wheels in front: one (tricycle) or two (car, Ackermann). Both driven wheels
// roll on one axle behind them.
//
// The steered wheels are L ahead of the driven axle, at the angle delta, positive to the left. No wheel
// slides sideways if every wheel's axle points to one centre on the driven axle's line (the bicycle model):
//   R = L / tan delta                 from the middle of the driven axle to the centre, to the left
//   omega = k v,  k = tan delta / L   the heading's rate, v forward at the driven axle
// The driven wheels, B apart, roll at r_left v and r_right v, with r = 1 -+ k B / 2. A car's two steered
// wheels are B apart, too. The inner wheel is turned more than delta, the outer wheel less:
//   cot inner = cot delta - B / (2 L),  cot outer = cot delta + B / (2 L)
// Body, wheels (moments of inertia J_i) and motors then have one degree of freedom:
//   (m + I k^2 + sum r_i^2 J_i / radius^2) dv/dt = sum r_i (motor_i - friction_i)
// A change of delta keeps the momentum m v + I k omega. With a differential, one motor gives both wheels the
// same torque and turns at the mean of their speeds. Otherwise each motor turns with its own wheel.
//
// While no wheel slides sideways, the steered wheels push across their own direction with the force
//   P = (I domega/dt - (F_right - F_left) B / 2) / (L cos delta) + (1 - load_share) m v omega
// where F are the driven wheels' forces. P is at most grip (1 - load_share) m g. If the motion needs a larger
// P, the steered wheels slide, and the body runs wide. The limited P and the driven wheels then determine the
// turn. In a steady bend, therefore, v^2 k <= grip g. Driven wheels slip and skid as in body.h; the steered
// wheels carry their share of the sideways force.
//
// Source: geometry and Newton's law. Not modelled: spinning out (the tail slides, but does not turn the body
// faster), the steered wheels' inertia and the servo's load while turning them, linkages that miss
// Ackermann's condition.
#include <algorithm>

#include "sim/base/deterministic_trig.h"
#include "sim/base/trig_series.h"
#include "sim/world/body.h"
#include "sim/world/step_constants.h"

namespace robosim::world {
namespace {

constexpr double kMostSteered = 1.4;  // rad

}  // namespace

double steered_middle(double inner, double track, double steer_base) {
  const Vec2 turn = direction_of(inner);
  // The inner wheel is track / 2 to the side of the middle. Its axle points to the same centre as the axle of
  // a wheel in the middle.
  return angle_of({turn.x + std::fabs(turn.y) * track / (2.0 * steer_base), turn.y});
}

void Body::steer(double angle) {
  if (angle == steered_) return;
  steered_ = bounded(angle, kMostSteered);
  const Vec2 turn = direction_of(steered_);
  steer_cosine_ = turn.x;
  steer_sine_ = turn.y;
  curvature_ = turn.y / (turn.x * params_.steer_base_m);
}

// Applies motors and grip for a tick. If a tyre slips, applies the steered wheels' push, then calls
// accelerate() for the driven wheels.
void Body::accelerate_steered() {
  const double ratio[2] = {1.0 - curvature_ * half_track_, 1.0 + curvature_ * half_track_};
  Motor m[2] = {motor(left), motor(right)};
  double momentum = params_.mass_kg * v_ + params_.yaw_inertia_kgm2 * curvature_ * omega_;
  double inertia = params_.mass_kg + params_.yaw_inertia_kgm2 * curvature_ * curvature_;
  double held = 0.0, friction[2], turning[2];
  for (const int i : {0, 1}) {
    const Unit& unit = unit_[i];
    friction[i] = unit.friction[surface_[i] == 0.0];
    // With a differential, the motor turns at the mean speed and gives each side half of its torque.
    turning[i] = params_.differential ? 1.0 : ratio[i];
    momentum += ratio[i] * unit.inertia * surface_[i] + turning[i] * m[i].push;
    inertia += ratio[i] * ratio[i] * unit.inertia + turning[i] * turning[i] * m[i].drag;
    held += std::fabs(ratio[i]) * friction[i];
  }
  double speed = 0.0;
  if (momentum > held) speed = (momentum - held) / inertia;
  if (momentum < -held) speed = (momentum + held) / inertia;
  speed = bounded(speed, kMaxSpeed);
  double turn = bounded(curvature_ * speed, kMaxTurn);

  // Impulses, N s: `traction` of the driven tyres on the ground; `push` of the steered wheels across their
  // direction.
  double traction[2];
  for (const int i : {0, 1}) {
    const double tread = ratio[i] * speed, given = m[i].push - m[i].drag * turning[i] * speed;
    const double rubs = tread != 0.0 ? std::copysign(friction[i], tread) : 0.0;
    traction[i] = unit_[i].inertia * (surface_[i] - tread) + given - rubs;
  }
  const double front = 1.0 - params_.load_share;
  const double sideways = -side_free_ * params_.mass_kg;
  const double tail = sideways - front * sideways;
  bool holds = std::fabs(tail) <= kSkidShare * (grip_limit_[0] + grip_limit_[1]);
  for (const int i : {0, 1}) {
    const double side = side_share_[i] * tail;
    const double most = std::sqrt(std::max(grip_limit_[i] * grip_limit_[i] - side * side, 0.0));
    holds &= std::fabs(traction[i]) <= most;
    traction[i] = bounded(traction[i], most);
  }
  if (!holds) {
    const double pushed = ratio[left] * traction[left] + ratio[right] * traction[right];
    const double curved = params_.yaw_inertia_kgm2 * curvature_;
    speed = (params_.mass_kg * v_ + curved * omega_ + pushed) / (params_.mass_kg + curved * curvature_);
    turn = bounded(curvature_ * speed, kMaxTurn);
  }
  const double turns = params_.yaw_inertia_kgm2 * (turn - omega_) - (traction[1] - traction[0]) * half_track_;
  const double push = turns / (params_.steer_base_m * steer_cosine_) + front * sideways;
  holds &= std::fabs(push) <= steer_limit_;
  if (holds) {
    slips_ = false;
    u_ = 0.0;
    v_ = speed;
    omega_ = turn;
    for (const int i : {0, 1}) surface_[i] = bounded(ratio[i] * speed, kMaxSpeed);
    return;
  }
  const double share = bounded(front * sideways, steer_limit_);
  const double pushes = bounded(push, steer_limit_) - share;
  v_ -= pushes * steer_sine_ * per_mass_;
  along_free_ -= pushes * steer_sine_ * per_mass_;
  omega_ += pushes * params_.steer_base_m * steer_cosine_ * per_inertia_;
  side_free_ += share * per_mass_;
  accelerate();
  slips_ |= std::fabs(push) > steer_limit_;
}

}  // namespace robosim::world
