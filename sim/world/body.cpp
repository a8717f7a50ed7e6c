#include "sim/world/body.h"

#include <algorithm>

#include "sim/base/function_multiversioning.h"
#include "sim/world/step_constants.h"
#include "sim/world/walls.h"

namespace robosim::world {

namespace {

// Returns an impulse reduced by friction of at most `friction`.
double after_friction(double impulse, double friction) {
  if (impulse > friction) return impulse - friction;
  if (impulse < -friction) return impulse + friction;
  return 0.0;
}

}  // namespace

void Body::command(Side side, const WheelCommand& command) {
  Unit& unit = unit_[side];
  unit.drive = bounded(command.drive, 1.0);
  unit.brake = std::min(std::max(bounded(command.brake, 1.0), 0.0), 1.0 - std::fabs(unit.drive));
  tell_roller(side);
  if (winds_) [[unlikely]]
    set_winding(side, command);
}

void Body::place(const Pose& pose) {
  pose_ = pose;
  const double norm = length(pose.heading);
  pose_.heading = norm > 0.0 ? pose.heading * (1.0 / norm) : Vec2{1.0, 0.0};
  v_ = u_ = omega_ = 0.0;
  surface_[left] = surface_[right] = 0.0;
  free_way_ = 0.0;
  lift(false);
  slips_ = touched_ = near_ = in_contact_ = near_ahead_ = pressed_ahead_ = false;
}

bool Body::covers(Vec2 p) const {
  const Vec2 q = pose_.to_body(p);
  if (params_.outline.empty()) {
    const Vec2 d = q - params_.centre;
    return dot(d, d) <= params_.radius_m * params_.radius_m;
  }
  for (std::size_t i = 0, n = params_.outline.size(); i < n; ++i) {
    const Vec2 a = params_.outline[i], b = params_.outline[i + 1 < n ? i + 1 : 0];
    if (cross(b - a, q - a) < 0.0) return false;
  }
  return true;
}

double Body::kinetic_energy() const {
  return 0.5 * (params_.mass_kg * (v_ * v_ + u_ * u_) + params_.yaw_inertia_kgm2 * omega_ * omega_ +
                unit_[left].inertia * surface_[left] * surface_[left] +
                unit_[right].inertia * surface_[right] * surface_[right]);
}

void Body::draw_energy() {
  if (winds_) [[unlikely]]
    return draw_by_windings();
  for (int side = 0; side < 2; ++side) {
    const Unit& unit = unit_[side];
    const double speed = std::copysign(1.0, unit.drive) * surface_[side];
    energy_ += std::fabs(unit.drive) * std::max(unit.joule0 - unit.joule1 * speed, 0.0);
  }
}

double Body::reach(double seconds) const {
  const double speed = std::fabs(v_) + std::fabs(u_) + std::fabs(omega_) * bound_radius_;
  const double grip = params_.grip * (kGravity + params_.downforce_n / params_.mass_kg);
  return 2.0 * way_per_travel_ * seconds * (speed + 0.5 * grip * seconds);
}

void Body::advance(double dt) {
  const Pose next = pose_after(dt);
  const double cosine = dot(pose_.heading, next.heading), sine = cross(pose_.heading, next.heading);
  const double along = along_free_, side = side_free_;
  along_free_ = cosine * along + sine * side;
  side_free_ = cosine * side - sine * along;
  pose_ = next;
  angle_[left] += surface_[left] * unit_[left].per_radius * dt;
  angle_[right] += surface_[right] * unit_[right].per_radius * dt;
  wheel_travel_ += 0.5 * (std::fabs(surface_[left]) + std::fabs(surface_[right])) * dt;
  distance_ += (u_ == 0.0 ? std::fabs(v_) : std::sqrt(v_ * v_ + u_ * u_)) * dt;
}

// Solves for the speeds of two rolling wheels: (mass_own + inertia + drag) speed_i + mass_cross speed_j =
// impulse_i - friction_i, where friction holds a wheel or opposes its turning. The solution is the unique
// minimum of a convex function, and is found by coordinate descent.
void Body::solve_friction(double* speed, const double* impulse, const double* friction,
                          const Motor* m) const {
  const double own[2] = {mass_own_ + unit_[left].inertia + m[left].drag,
                         mass_own_ + unit_[right].inertia + m[right].drag};
  double y[2] = {0.0, 0.0};
  for (int round = 0; round < 30; ++round) {
    const double before[2] = {y[0], y[1]};
    y[0] = after_friction(impulse[0] - mass_cross_ * y[1], friction[0]) / own[0];
    y[1] = after_friction(impulse[1] - mass_cross_ * y[0], friction[1]) / own[1];
    if (y[0] == before[0] && y[1] == before[1]) break;
  }
  speed[left] = y[0];
  speed[right] = y[1];
}

// Solves for separate speeds of ground and tread if at least one tyre slips or nearly slips. Traction of at
// most `limit` couples the two speeds. Solves wheel by wheel, with the other wheel's traction fixed, until
// the tractions no longer change.
void Body::solve_slip(const Motor* m, const double* friction, const double* limit) {
  const double ground[2] = {v_ - omega_ * half_track_, v_ + omega_ * half_track_};
  const double turning = half_track_ * half_track_ * per_inertia_;
  const double give_own = per_mass_ + turning, give_cross = per_mass_ - turning;
  double traction[2] = {0.0, 0.0}, tread[2] = {surface_[0], surface_[1]};
  bool slips = false;
  for (int round = 0; round < 20; ++round) {
    const double before[2] = {traction[0], traction[1]};
    slips = false;
    for (int i = 0; i < 2; ++i) {
      const double base = ground[i] + give_cross * traction[1 - i];
      const double impulse = unit_[i].inertia * surface_[i] + m[i].push;
      const double own = unit_[i].inertia + m[i].drag;
      double y = after_friction(impulse + base / give_own, friction[i]) / (own + 1.0 / give_own);
      double t = (y - base) / give_own;
      if (std::fabs(t) > limit[i]) {
        slips = true;
        t = t > 0.0 ? limit[i] : -limit[i];
        y = after_friction(impulse - t, friction[i]) / own;
      }
      traction[i] = t;
      tread[i] = y;
    }
    if (traction[0] == before[0] && traction[1] == before[1]) break;
  }
  slips_ = slips;
  v_ = bounded(v_ + (traction[0] + traction[1]) * per_mass_, kMaxSpeed);
  omega_ = bounded(omega_ + (traction[1] - traction[0]) * half_track_ * per_inertia_, kMaxTurn);
  surface_[0] = bounded(tread[0], kMaxSpeed);
  surface_[1] = bounded(tread[1], kMaxSpeed);
}

void Body::accelerate() {
  const Motor m[2] = {motor(left), motor(right)};
  const double s0 = surface_[0], s1 = surface_[1];
  const double friction[2] = {unit_[0].friction[s0 == 0.0], unit_[1].friction[s1 == 0.0]};

  // The tyres cancel the sideways speed in the new pose's frame, with at most the share kSkidShare of their
  // grip.
  const double sideways = -side_free_ * params_.mass_kg;
  double limit[2] = {grip_limit_[0], grip_limit_[1]};
  bool skids = false;
  if (std::fabs(sideways) <= kSkidShare * (limit[0] + limit[1])) {
    u_ = 0.0;
  } else {
    skids = true;
    limit[0] *= kSkidShare;
    limit[1] *= kSkidShare;
    const double most = (limit[0] + limit[1]) * per_mass_;
    u_ = bounded(side_free_ + (sideways > 0.0 ? most : -most), kMaxSpeed);
    v_ = along_free_;
  }

  const double ground0 = v_ - omega_ * half_track_, ground1 = v_ + omega_ * half_track_;
  const double momentum0 = mass_own_ * ground0 + mass_cross_ * ground1;
  const double momentum1 = mass_cross_ * ground0 + mass_own_ * ground1;
  const double impulse[2] = {momentum0 + unit_[0].inertia * s0 + m[0].push,
                             momentum1 + unit_[1].inertia * s1 + m[1].push};
  const double own0 = mass_own_ + unit_[0].inertia + m[0].drag;
  const double own1 = mass_own_ + unit_[1].inertia + m[1].drag;
  const double per_determinant = 1.0 / (own0 * own1 - mass_cross_ * mass_cross_);
  const double p0 = impulse[0] - std::copysign(friction[0], s0);
  const double p1 = impulse[1] - std::copysign(friction[1], s1);
  double y[2] = {(own1 * p0 - mass_cross_ * p1) * per_determinant,
                 (own0 * p1 - mass_cross_ * p0) * per_determinant};
  // If a wheel stands still, or would reverse within the tick, its friction may hold it.
  if (!(y[0] * s0 > 0.0 && y[1] * s1 > 0.0)) solve_friction(y, impulse, friction, m);

  const double traction0 = mass_own_ * y[0] + mass_cross_ * y[1] - momentum0;
  const double traction1 = mass_cross_ * y[0] + mass_own_ * y[1] - momentum1;
  double most[2];
  for (int i = 0; i < 2; ++i) {
    const double side = side_share_[i] * sideways;
    most[i] = skids ? limit[i] * limit[i] : limit[i] * limit[i] - side * side;
  }
  if (traction0 * traction0 <= most[0] && traction1 * traction1 <= most[1]) {
    slips_ = skids;
    surface_[0] = bounded(y[0], kMaxSpeed);
    surface_[1] = bounded(y[1], kMaxSpeed);
    v_ = 0.5 * (surface_[0] + surface_[1]);
    omega_ = bounded((surface_[1] - surface_[0]) * per_track_, kMaxTurn);
  } else {
    const double left_over[2] = {std::sqrt(std::max(most[0], 0.0)), std::sqrt(std::max(most[1], 0.0))};
    solve_slip(m, friction, left_over);
    slips_ |= skids;
  }
}

// Turns each wheel of a lifted or toppled body independently.
void Body::spin() {
  advance(kDt);
  if (winds_) find_currents();
  for (const Side side : {left, right}) {
    const Motor m = motor(side);
    const Unit& unit = unit_[side];
    const double impulse = unit.inertia * surface_[side] + m.push;
    const double speed =
        after_friction(impulse, unit.friction[surface_[side] == 0.0]) / (unit.inertia + m.drag);
    surface_[side] = unit.drive == 0.0 && std::fabs(speed) < kStill ? 0.0 : bounded(speed, kMaxSpeed);
  }
  draw_energy();
}

// Computes the tick if the body simply rolls (rolling_step.h). Otherwise returns false, without effect.
ROBOSIM_ALSO_FOR("avx") bool Body::roll_on(const Walls& walls) {
  if (!is_ordinary_ || lifted_ || v_ == 0.0 || u_ != 0.0 || !walls.discs().empty()) return false;
  Rolling<Pair> next;
  const Rolling<Pair> now = {pose_.position.x,
                             pose_.position.y,
                             pose_.heading.x,
                             pose_.heading.y,
                             v_,
                             omega_,
                             {surface_[0], surface_[1]},
                             {angle_[0], angle_[1]},
                             wheel_travel_,
                             distance_,
                             energy_,
                             free_way_};
  if (!roll(roller_, walls.stride(bound_radius_), now, next).holds()) return false;
  pose_ = {{next.x, next.y}, {next.heading_x, next.heading_y}};
  v_ = next.v;
  omega_ = next.omega;
  for (const int side : {0, 1}) {
    surface_[side] = next.surface[side];
    angle_[side] = next.angle[side];
  }
  wheel_travel_ = next.wheel_travel;
  distance_ = next.distance;
  energy_ = next.energy;
  free_way_ = next.free_way;
  slips_ = false;
  return true;
}

void Body::step_closely(const Walls& walls, Ground* ground) {
  if (lifted_ || stance_.toppled != Toppled::no) return spin();
  if (winds_) [[unlikely]]
    find_currents();
  const bool rough = ground || params_.centre_height_m > 0.0;
  if ((!rough || stance_.eases) && v_ == 0.0 && omega_ == 0.0 && u_ == 0.0 && surface_[0] == 0.0 &&
      surface_[1] == 0.0 && std::fabs(motor(left).push) <= unit_[left].friction[1] &&
      std::fabs(motor(right).push) <= unit_[right].friction[1]) {
    if (driven()) draw_energy();
    if (in_contact_ || !walls.discs().empty()) collide(walls);
    return;
  }
  const double travel = (std::fabs(v_) + std::fabs(u_) + std::fabs(omega_) * bound_radius_) * kDt;
  const double stride = walls.stride(bound_radius_);
  along_free_ = v_;
  side_free_ = u_;
  const Pose before = rough ? pose_ : Pose{};
  if (travel <= stride) {
    free_way_ -= way_per_travel_ * travel;
    advance(kDt);
  } else {
    const int parts = static_cast<int>(std::min(travel / stride, 1e6)) + 1;
    for (int part = 0; part < parts; ++part) {
      advance(kDt / parts);
      free_way_ = 0.0;
      if (part + 1 < parts) collide(walls);
    }
    free_way_ = 0.0;
  }
  if (!rough || stand(ground, before, travel)) {
    if (params_.steer_base_m > 0.0)
      accelerate_steered();
    else
      accelerate();
  }
  if (scrub_rolling_ > 0.0) scrub();
  draw_energy();
  if (!driven() && std::fabs(v_) < kStill && std::fabs(u_) < kStill && std::fabs(omega_) < kStill &&
      std::fabs(surface_[0]) < kStill && std::fabs(surface_[1]) < kStill) {
    v_ = u_ = omega_ = surface_[0] = surface_[1] = 0.0;
  }
  if (!(free_way_ > 0.0) || !walls.discs().empty()) collide(walls);
}

}  // namespace robosim::world
