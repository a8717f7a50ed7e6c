// Derives a body's constants from its parameters and its faults.
#include <algorithm>
#include <stdexcept>
#include <string>

#include "sim/world/body.h"
#include "sim/world/step_constants.h"

namespace robosim::world {

namespace {

// Friction of a blocked wheel, N s per tick: no motor overcomes it.
constexpr double kHeld = 1e6;

double torque_per_ampere(const WheelParams& w) {
  return w.stall_torque / (w.stall_current - w.no_load_current);
}

void require(bool holds, const char* what) {
  if (!holds) throw std::invalid_argument(std::string("BodyParams: ") + what);
}

bool positive(double x) { return x > 0.0 && std::isfinite(x); }
bool not_negative(double x) { return x >= 0.0 && std::isfinite(x); }

void check(const BodyParams& p) {
  for (const WheelParams& w : p.wheel) {
    require(positive(w.nominal_volts), "nominal_volts must be more than 0");
    require(positive(w.no_load_rate), "no_load_rate must be more than 0");
    require(not_negative(w.no_load_current), "no_load_current must not be negative");
    require(positive(w.stall_torque), "stall_torque must be more than 0");
    require(positive(w.stall_current) && w.stall_current > w.no_load_current,
            "stall_current must be more than no_load_current");
    require(w.static_friction >= 1.0 && std::isfinite(w.static_friction),
            "static_friction must be at least 1");
    require(positive(w.gear_ratio), "gear_ratio must be more than 0");
    require(not_negative(w.rotor_inertia_kgm2), "rotor_inertia_kgm2 must not be negative");
    require(positive(w.wheel_inertia_kgm2), "wheel_inertia_kgm2 must be more than 0");
    require(positive(w.radius_m), "the wheel's radius_m must be more than 0");
  }
  require(positive(p.supply_volts), "supply_volts must be more than 0");
  require(not_negative(p.driver_drop_volts), "driver_drop_volts must not be negative");
  require(not_negative(p.driver_ohms), "driver_ohms must not be negative");
  require(positive(p.track_m), "track_m must be more than 0");
  require(positive(p.mass_kg), "mass_kg must be more than 0");
  require(positive(p.yaw_inertia_kgm2), "yaw_inertia_kgm2 must be more than 0");
  require(p.load_share > 0.0 && p.load_share <= 1.0, "load_share must be more than 0 and at most 1");
  require(not_negative(p.rolling_resistance), "rolling_resistance must not be negative");
  require(positive(p.grip), "grip must be more than 0");
  require(not_negative(p.wall_friction), "wall_friction must not be negative");
  require(p.caster_m != 0.0 && std::isfinite(p.caster_m), "caster_m must not be 0");
  require(positive(p.caster_radius_m), "caster_radius_m must be more than 0");
  require(not_negative(p.centre_height_m), "centre_height_m must not be negative");
  require(not_negative(p.wheelbase_m), "wheelbase_m must not be negative");
  require(not_negative(p.steer_base_m), "steer_base_m must not be negative");
  require(!(p.steer_base_m > 0.0 && p.wheelbase_m > 0.0),
          "wheelbase_m requires a body without steered wheels");
  require(not_negative(p.downforce_n), "downforce_n must not be negative");
  if (p.outline.empty()) {
    require(positive(p.radius_m), "radius_m must be more than 0 if there is no outline");
    return;
  }
  require(p.outline.size() >= 3, "outline needs at least 3 corners");
  for (std::size_t i = 0, n = p.outline.size(); i < n; ++i) {
    const Vec2 a = p.outline[i], b = p.outline[(i + 1) % n], c = p.outline[(i + 2) % n];
    require(cross(b - a, c - b) > 0.0, "outline must be convex and counter-clockwise");
  }
}

}  // namespace

BodyParams default_body_params() {
  WheelParams wheel;
  wheel.nominal_volts = 6.0;
  wheel.no_load_rate = 20.94;
  wheel.no_load_current = 0.16;
  wheel.stall_torque = 0.0785;
  wheel.stall_current = 1.5;
  wheel.static_friction = 1.5;
  wheel.gear_ratio = 48.0;
  wheel.rotor_inertia_kgm2 = 4e-8;
  wheel.wheel_inertia_kgm2 = 1.6e-5;
  wheel.radius_m = 0.0325;

  BodyParams p;
  p.wheel[left] = p.wheel[right] = wheel;
  p.supply_volts = 7.4;
  p.driver_drop_volts = 1.4;
  p.driver_ohms = 1.15;
  p.track_m = 0.130;
  p.mass_kg = 0.5;
  p.yaw_inertia_kgm2 = 0.0014;
  p.load_share = 0.8;
  p.rolling_resistance = 0.02;
  p.grip = 0.8;
  p.wall_friction = 0.3;
  p.radius_m = 0.080;
  return p;
}

// Sets grip and rolling resistance for a plane floor.
void Body::set_grip() {
  steer_limit_ = params_.grip * (1.0 - params_.load_share) * params_.mass_kg * kGravity * kDt;
  for (const Side side : {left, right}) {
    rolling_[side] = params_.rolling_resistance * params_.mass_kg * kGravity * 0.5;
    grip_limit_[side] = params_.grip * params_.load_share * params_.mass_kg * kGravity * 0.5 * kDt;
    if (params_.downforce_n > 0.0) {
      rolling_[side] += params_.rolling_resistance * params_.downforce_n * 0.5;
      grip_limit_[side] += params_.grip * params_.downforce_n * 0.5 * kDt;
    }
    rub(side);
  }
}

void Body::press(double downforce_n) {
  if (downforce_n == params_.downforce_n) return;
  params_.downforce_n = downforce_n;
  set_grip();
}

Body::Body(const BodyParams& params, const Pose& pose) : pose_(pose), params_(params) {
  check(params_);
  const double m = params_.mass_kg;
  for (int side = 0; side < 2; ++side) {
    const WheelParams& w = params_.wheel[side];
    Unit& unit = unit_[side];
    unit = {};
    unit.per_radius = 1.0 / w.radius_m;
    const double inertia = w.wheel_inertia_kgm2 + w.rotor_inertia_kgm2 * w.gear_ratio * w.gear_ratio;
    unit.inertia = inertia * unit.per_radius * unit.per_radius;
    winds_ |= w.inductance_h > 0.0;
  }
  set_grip();
  supply(params_.supply_volts);
  for (const Side side : {left, right}) {
    winding_[side].seconds = params_.wheel[side].inductance_h * unit_[side].per_ohm;
    if (winds_) set_winding(side, {});
  }
  half_track_ = params_.track_m * 0.5;
  per_track_ = 1.0 / params_.track_m;
  const double turning = params_.yaw_inertia_kgm2 * per_track_ * per_track_;
  mass_own_ = m * 0.25 + turning;
  mass_cross_ = m * 0.25 - turning;
  per_mass_ = 1.0 / m;
  per_inertia_ = 1.0 / params_.yaw_inertia_kgm2;
  set_scrub();
  if (params_.outline.empty()) {
    bound_centre_ = params_.centre;
    bound_radius_ = params_.radius_m;
  } else {
    Vec2 low = params_.outline[0], high = low;
    for (const Vec2 p : params_.outline) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    bound_centre_ = (low + high) * 0.5;
    for (const Vec2 p : params_.outline) bound_radius_ = std::max(bound_radius_, length(p - bound_centre_));
  }
  constexpr double kCurve = 1.02;  // margin for the error of the polynomials in pose_after()
  way_per_travel_ = kCurve * std::max(1.0, length(bound_centre_) / bound_radius_);
  roller_.mass = m;
  for (const Side side : {left, right}) set_roller(side);
  roller_.mass_own = mass_own_;
  roller_.mass_cross = mass_cross_;
  roller_.half_track = half_track_;
  roller_.per_track = per_track_;
  roller_.bound_radius = bound_radius_;
  roller_.way_per_travel = way_per_travel_;
  is_ordinary_ =
      !winds_ && !(params_.centre_height_m > 0.0) && !(params_.steer_base_m > 0.0) && !(scrub_rolling_ > 0.0);
}

// Updates the values of `roller_` that depend on the motor's command.
void Body::tell_roller(Side side) {
  const Unit& unit = unit_[side];
  const double drives = std::fabs(unit.drive);
  roller_.direction[side] = std::copysign(1.0, unit.drive);
  roller_.drives[side] = drives;
  roller_.push[side] = unit.drive * unit.push;
  roller_.drag[side] = drives * unit.drag;
  roller_.brake_push[side] = unit.brake * unit.brake_push;
  roller_.brake_drag[side] = unit.brake * unit.drag;
}

// Updates all values of `roller_`.
void Body::set_roller(Side side) {
  const Unit& unit = unit_[side];
  tell_roller(side);
  roller_.push_until[side] = unit.push_until;
  roller_.brake_from[side] = unit.brake_from;
  roller_.per_radius[side] = unit.per_radius;
  roller_.inertia[side] = unit.inertia;
  roller_.turning_friction[side] = unit.friction[0];
  roller_.joule0[side] = unit.joule0;
  roller_.joule1[side] = unit.joule1;
  roller_.side_share[side] = side_share_[side];
  roller_.owns[side] = mass_own_ + unit.inertia;
  roller_.grip_squares[side] = grip_limit_[side] * grip_limit_[side];
  roller_.skids_from = kSkidShare * (grip_limit_[0] + grip_limit_[1]);
}

void Body::rub(Side side) {
  const WheelParams& w = params_.wheel[side];
  Unit& unit = unit_[side];
  const double rolling = lifted_ ? 0.0 : rolling_[side];
  const double gear = torque_per_ampere(w) * w.no_load_current * unit.per_radius;
  unit.friction[0] = blocked_[side] ? kHeld : (gear + rolling) * kDt;
  unit.friction[1] = blocked_[side] ? kHeld : (gear * w.static_friction + rolling) * kDt;
  set_roller(side);
}

void Body::supply(double supply_volts) {
  supply_ = supply_volts;
  for (int side = 0; side < 2; ++side) {
    const WheelParams& w = params_.wheel[side];
    Unit& unit = unit_[side];
    const double winding = w.nominal_volts / w.stall_current;
    const double per_rate = (w.nominal_volts - winding * w.no_load_current) / w.no_load_rate;
    const double drop = params_.driver_drop_volts;
    const double volts = std::max(supply_volts - drop, 0.0);
    const double ohms = winding + params_.driver_ohms;
    const double impulse_per_volt = torque_per_ampere(w) / ohms * unit.per_radius * kDt;
    const double volts_per_speed = per_rate * unit.per_radius;
    unit.per_ohm = 1.0 / ohms;
    unit.volts_per_speed = volts_per_speed;
    unit.push = impulse_per_volt * volts;
    unit.drag = impulse_per_volt * volts_per_speed;
    unit.push_until = volts / volts_per_speed;
    unit.brake_push = impulse_per_volt * drop;
    unit.brake_from = drop / volts_per_speed;
    unit.joule0 = supply_volts * volts / ohms * kDt;
    unit.joule1 = supply_volts * volts_per_speed / ohms * kDt;
    set_roller(static_cast<Side>(side));
  }
}

Body::Draw Body::draw(double supply_volts) const {
  Draw draw;
  if (winds_) {
    for (const int side : {0, 1}) {
      draw.amps += current_of(side, supply_volts).drawn;
      draw.amps_per_volt += (std::fabs(unit_[side].drive) + winding_[side].against) * unit_[side].per_ohm;
    }
    return draw;
  }
  const double volts = supply_volts - params_.driver_drop_volts;
  for (int side = 0; side < 2; ++side) {
    const Unit& unit = unit_[side];
    const double drives =
        std::max(volts, 0.0) - std::copysign(1.0, unit.drive) * surface_[side] * unit.volts_per_speed;
    if (!(drives > 0.0)) continue;
    draw.amps += std::fabs(unit.drive) * drives * unit.per_ohm;
    if (volts > 0.0) draw.amps_per_volt += std::fabs(unit.drive) * unit.per_ohm;
  }
  return draw;
}

void Body::block(Side side, bool blocked) {
  blocked_[side] = blocked;
  rub(side);
}

void Body::carry(const Pose& pose) {
  lift(true);
  carried_ = true;
  pose_ = pose;
}

void Body::tilt(const Lean& lean) {
  lift(true);
  lean_ = lean;
}

void Body::lift(bool lifted) {
  carried_ = false;
  lean_ = {};
  stance_ = {};
  if (lifted == lifted_) return;
  lifted_ = lifted;
  v_ = u_ = omega_ = 0.0;
  slips_ = touched_ = near_ = in_contact_ = near_ahead_ = pressed_ahead_ = false;
  rub(left);
  rub(right);
}

}  // namespace robosim::world
