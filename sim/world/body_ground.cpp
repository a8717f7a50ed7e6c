// Simulates a body on hills and surfaces, and on wheels whose loads shift.
//
// The axle carries load_share of the weight m g, half on each wheel. The caster, at caster_m = c from the
// axle, carries the rest. Each wheel and the caster stand at their own height, whose gradient is `rise`
// (ground.h). Gravity therefore pulls with
//   force  = - m g (load_share (rise_left + rise_right) / 2 + (1 - load_share) rise_caster)
//   torque = sum of these forces, each times its arm about the axle's centre
// Force and torque change the velocities before motors, friction and grip do. The weight that presses on the
// floor is m g cos, where cos is the cosine of the body's lean. Rolling resistance and grip depend on this
// weight and on the surface under each wheel.
//
// With centre_height_m = h, the loads N shift with the slope (pitch and roll are sines) and with the
// acceleration a. Here a is the mean of this tick's acceleration and the previous a:
//   N_caster = (1 - load_share) m g cos - m (g pitch + a) h / c      N_axle = m g cos - N_caster
//   N_right - N_left = 2 m (g roll + v omega) h / track              at most N_axle; |v omega| <= grip g
// If N_caster is negative, the caster leaves the floor and the body turns about its axle. If a wheel's load
// is negative, the body turns about the line from the other wheel to the caster. The force across that line
// is f = m g sine + m a, with the slope's sine in the force's direction. With the mass at the distance d from
// the line, and the tip angle phi,
//   I d2 phi / dt2 = f (h cos phi + d sin phi) - m g cos (d cos phi - h sin phi)
//   I = m (h^2 + d^2 + bound_radius^2 / 4)
// A body at rest therefore tips where tan(slope) > d / h. Beyond phi = 45 degrees the body has toppled.
//
// If the caster is at the back, the path under the wheels may be steeper than the chassis: at a step, or at
// the foot of a slope. The floor then pushes at a wheel's hub and not at its tread. The forces of the impact
// and of the slope then have the arm max(h - r, 0), not h; r is the wheel's radius. A robot therefore does
// not trip over a step if its centre of mass is no higher than its hubs.
//
// If the slope under a wheel increases from k_0 to k_1, v is multiplied by 1 - (1 - cos) share. Here share is
// the wheel's share of the mass, and cos is the cosine of the angle between both slopes. If k_0 < 0, the
// wheel lands after a fall. v^2 then falls by at most the wheel's share of the v^2 gained in that fall:
//   2 g r (1 - 1 / sqrt(1 + k_0^2))
//
// At the far edge of a gap between boards, each wheel and the caster lose kinetic energy in one tick
// (floor_gaps.h). Inside a gap, gravity acts along the slope of the wheel's path.
//
// The body has also toppled if the ground under a wheel or caster drops within a tick by more than its
// radius. Ground that rises within a tick by more than three times a wheel's movement counts as a face: the
// body stops there, as at a wall.
//
// Not modelled: a step's upward push on the axle, which holds the caster down; the lift of a front caster by
// the motors at a step; a tip about the caster (the wheels lose their grip instead); a chassis that sits on a
// crest.
#include <algorithm>

#include "sim/base/trig_series.h"
#include "sim/world/body.h"
#include "sim/world/ground.h"
#include "sim/world/step_constants.h"
#include "sim/world/walls.h"

namespace robosim::world {

namespace {

constexpr double kMostSine = 0.99;
constexpr double kToppled = 0.78539816339744831;       // rad: 45 degrees
constexpr double kNoWay = 1e-6;                        // m: a shorter movement has no direction
constexpr double kFaceSlope = 3.0, kFaceLeast = 1e-4;  // m per m of movement, and m

}  // namespace

// Computes `stance_`: heights, lean and loads of the wheels. Returns false if the body topples or has run
// into a face. At a face, moves the body back to `before`.
bool Body::stand(Ground* ground, const Pose& before, double travel) {
  Vec2 at[3], rises[3];
  const Stance last = stance_;
  const double speed = v_;
  find_footing(ground, at, rises);
  if (last.known && ground) {
    const double most = kFaceSlope * travel + ground->heave() + kFaceLeast;
    bool is_face = false;
    for (int i = 0; i < 3; ++i) {
      const double radius = foot_radius(i);
      is_face |= stance_.height[i] - last.height[i] > most;
      if (last.height[i] - stance_.height[i] > radius) stance_.toppled = Toppled::off_an_edge;
    }
    if (is_face) {
      stance_ = last;
      stance_.is_at_face = true;
      stance_.face = pose_ = before;
      touched_ = near_ = true;
      return halt();
    }
    const Vec2 away = pose_.position - stance_.face.position;
    stance_.is_at_face = stance_.is_at_face && dot(away, away) < Walls::kNear * Walls::kNear;
    near_ |= stance_.is_at_face;
  }
  share_load(ground, at);
  if (stance_.toppled != Toppled::no) return halt();
  stance_.speed = speed;
  if (last.known) bump(last.rise, rises);
  for (int i = 0; i < 3; ++i) stance_.rise[i] = rises[i];
  if (last.known && ground && !ground->joints().empty()) jolt(ground->joints(), before, last, at, rises);
  pull(at, rises);
  return true;
}

// Returns the share of the weight that foot `i` (a wheel or the caster) carries on a plane floor.
double Body::share_on(int i) const { return i < 2 ? 0.5 * params_.load_share : 1.0 - params_.load_share; }

FloorGaps::Roller Body::roller(int i) const {
  return {foot_radius(i), i < 2 ? pose_.heading : Vec2{}, std::fabs(v_)};
}

double Body::foot_radius(int i) const { return i < 2 ? params_.wheel[i].radius_m : params_.caster_radius_m; }

// Returns which share of a push at the foot's hub shifts no load: 0 if the caster is in front of the axle.
double Body::hub_share(int i) const {
  if (params_.caster_m > 0.0) return 0.0;
  const double h = params_.centre_height_m, radius = foot_radius(i);
  return radius < h ? radius / h : 1.0;
}

bool Body::halt() {
  v_ = u_ = omega_ = along_free_ = side_free_ = surface_[0] = surface_[1] = 0.0;
  return false;
}

void Body::find_footing(const Ground* ground, Vec2* at, Vec2* rises) {
  at[left] = pose_.to_world({0.0, half_track_});
  at[right] = pose_.to_world({0.0, -half_track_});
  at[2] = pose_.to_world({params_.caster_m, 0.0});
  const bool known = stance_.known;
  const double pitch = stance_.pitch, roll = stance_.roll;
  double chassis[3];
  for (int i = 0; i < 3; ++i) {
    Footing footing;
    if (ground)
      footing = i < 2 ? ground->under_wheel(at[i], pose_.heading, params_.wheel[i].radius_m)
                      : ground->under_ball(at[i], params_.caster_radius_m);
    stance_.sunk[i] = ground ? ground->joints().sunk(at[i], roller(i)).depth : 0.0;
    stance_.height[i] = footing.height - stance_.sunk[i];
    rises[i] = footing.rise;
    // On a slope, the axle of a large wheel rises more than that of a small wheel. The chassis follows the
    // slope itself, so its height is computed with the caster's radius.
    chassis[i] = footing.height > 0.0 && i < 2 ? ground->under_ball(at[i], params_.caster_radius_m).height
                                               : footing.height;
    chassis[i] -= stance_.sunk[i];
  }
  const double caster = chassis[2] + stance_.tip[0] * std::fabs(params_.caster_m);
  stance_.axle = 0.5 * (chassis[left] + chassis[right]);
  stance_.pitch = bounded((caster - stance_.axle) / params_.caster_m, kMostSine);
  stance_.axle -= params_.caster_radius_m * (std::sqrt(1.0 + stance_.pitch * stance_.pitch) - 1.0);
  stance_.roll = bounded((chassis[left] - chassis[right]) * per_track_, kMostSine);
  stance_.known = true;
  const double lean2 = stance_.pitch * stance_.pitch + stance_.roll * stance_.roll;
  lean_ = {{-stance_.pitch, -stance_.roll}, std::sqrt(std::max(1.0 - lean2, 0.0)), {}};
  if (known) lean_.rate = Vec2{pitch - stance_.pitch, roll - stance_.roll} * (1.0 / kDt);
}

// Reduces the speed at once if a wheel or the caster begins to rise more steeply, or to fall less steeply.
void Body::bump(const Vec2* before, const Vec2* rises) {
  const Vec2 way = v_ < 0.0 ? pose_.heading * -1.0 : pose_.heading;
  for (int i = 0; i < 3; ++i) {
    const double from = dot(before[i], way), to = dot(rises[i], way);
    if (!(to > from)) continue;
    const double share = share_on(i), radius = foot_radius(i);
    const double stretch = std::sqrt(1.0 + from * from);
    const double cosine = (1.0 + from * to) / (stretch * std::sqrt(1.0 + to * to));
    double left_over = 1.0 - share * (1.0 - cosine);
    if (from < 0.0 && v_ != 0.0) {
      const double fallen = 2.0 * kGravity * radius * (1.0 - 1.0 / stretch) / (v_ * v_);
      left_over = std::max(left_over, std::sqrt(std::max(1.0 - share * fallen, 0.0)));
    }
    stance_.speed -= hub_share(i) * (1.0 - left_over) * v_;
    v_ *= left_over;
    along_free_ *= left_over;
  }
}

// Removes kinetic energy when a wheel or the caster meets the far edge of a gap. Sets the slope within a gap
// so that gravity's work does not depend on the number of ticks: it equals the change of potential energy.
void Body::jolt(const FloorGaps& joints, const Pose& before, const Stance& last, const Vec2* at,
                Vec2* rises) {
  const Vec2 from[3] = {before.to_world({0.0, half_track_}), before.to_world({0.0, -half_track_}),
                        before.to_world({params_.caster_m, 0.0})};
  for (int i = 0; i < 3; ++i) {
    const Vec2 way = at[i] - from[i];
    const double way2 = dot(way, way), sunk = stance_.sunk[i] - last.sunk[i];
    if (way2 > kNoWay * kNoWay)
      rises[i] = rises[i] - way * (bounded(sunk / way2, kSteepest / std::sqrt(way2)));
    else if (stance_.sunk[i] > 0.0)
      rises[i] = rises[i] + joints.sunk(at[i], roller(i)).rise;
    const double met2 = joints.met2(from[i], at[i], roller(i));
    if (!(met2 > 0.0) || v_ == 0.0) continue;
    const double left_over = std::sqrt(std::max(1.0 - share_on(i) * met2 / (v_ * v_), 0.0));
    stance_.speed -= hub_share(i) * (1.0 - left_over) * v_;
    v_ *= left_over;
    along_free_ *= left_over;
  }
}

void Body::pull(const Vec2* at, const Vec2* rises) {
  const double weight = params_.mass_kg * kGravity;
  const double on_wheel = 0.5 * params_.load_share * weight;
  const double share[3] = {on_wheel, on_wheel, weight - 2.0 * on_wheel};
  const double slope = stance_.pitch - std::copysign(stance_.tip[0], params_.caster_m);
  Vec2 force;
  double torque = 0.0, at_hubs = 0.0;
  for (int i = 0; i < 3; ++i) {
    const Vec2 pulls = rises[i] * -share[i];
    force = force + pulls;
    torque += cross(at[i] - pose_.position, pulls);
    at_hubs += hub_share(i) * (dot(pulls, pose_.heading) + share[i] * slope);
  }
  stance_.speed += at_hubs * kDt * per_mass_;
  stance_.eases = force.x == 0.0 && force.y == 0.0 && torque == 0.0 && stance_.tip[0] == 0.0 &&
                  stance_.tip[1] == 0.0 && stance_.gain == 0.0;
  const Vec2 gain = force * (kDt * per_mass_);
  const double along = dot(gain, pose_.heading);
  v_ += along;
  along_free_ += along;
  side_free_ += cross(pose_.heading, gain);
  omega_ += torque * per_inertia_ * kDt;
}

void Body::share_load(Ground* ground, const Vec2* at) {
  const double m = params_.mass_kg, h = params_.centre_height_m;
  const double weight = m * kGravity * lean_.level;
  double caster = (1.0 - params_.load_share) * weight, shift = 0.0;
  if (h > 0.0) {
    const double gain = in_contact_ ? 0.0 : (v_ - stance_.speed) * (1.0 / kDt);
    stance_.gain = std::fabs(stance_.gain) + std::fabs(gain) < 1e-6 ? 0.0 : 0.5 * (stance_.gain + gain);
    const double ahead = kGravity * stance_.pitch + stance_.gain;
    const double sideways = kGravity * stance_.roll + bounded(v_ * omega_, params_.grip * kGravity);
    const double c = params_.caster_m;
    const double pushes = c > 0.0 ? ahead : -ahead;
    tip(0, pushes, (1.0 - params_.load_share) * std::fabs(c));
    tip(1, std::fabs(sideways), params_.load_share * half_track_);
    caster = std::min(std::max(caster - m * ahead * h / c, 0.0), weight);
    if (stance_.tip[0] > 0.0) caster = 0.0;
    shift = bounded(m * sideways * h * per_track_, 0.5 * (weight - caster));
  }
  const double load[3] = {0.5 * (weight - caster) - shift, 0.5 * (weight - caster) + shift, caster};
  for (int i = 0; i < 2; ++i) {
    const Ground::Kind kind = ground ? ground->kind(at[i]) : Ground::Kind{};
    grip_limit_[i] = params_.grip * kind.grip * (load[i] + 0.5 * params_.downforce_n) * kDt;
    rolling_[i] = (params_.rolling_resistance + kind.rolling) * (weight + params_.downforce_n) * 0.5;
    rub(static_cast<Side>(i));
  }
  if (params_.steer_base_m > 0.0)
    steer_limit_ = params_.grip * (ground ? ground->kind(at[2]).grip : 1.0) * load[2] * kDt;
  const double both = grip_limit_[0] + grip_limit_[1];
  side_share_[0] = both > 0.0 ? grip_limit_[0] / both : 0.5;
  side_share_[1] = 1.0 - side_share_[0];
  if (!ground) return;
  for (int i = 0; i < 3; ++i) ground->press(at[i], load[i] / kGravity, load[i]);
}

// Advances the tip angle by a tick, about the axle (`which` = 0) or about the line from a wheel to the caster
// (1). `push` is the acceleration across that axis, m/s2; `arm` is the distance from the axis to the centre
// of mass, m.
void Body::tip(int which, double push, double arm) {
  const double h = params_.centre_height_m;
  double &angle = stance_.tip[which], &rate = stance_.tip_rate[which];
  const Vec2 turn = direction_of(angle);
  const double down = kGravity * lean_.level;
  const double torque = push * (h * turn.x + arm * turn.y) - down * (arm * turn.x - h * turn.y);
  rate += torque / (h * h + arm * arm + 0.25 * bound_radius_ * bound_radius_) * kDt;
  angle += rate * kDt;
  if (!(angle > 0.0)) angle = rate = 0.0;
  if (angle > kToppled) stance_.toppled = Toppled::over;
}

}  // namespace robosim::world
