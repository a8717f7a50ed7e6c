// Simulates bodies that turn by skidding, with four wheels or with tracks. The two wheels of a side are
// driven together.
//
// L is the wheelbase on each side, B the track between the sides, mu the grip. All four wheels carry the same
// load N. While the body turns at omega, each wheel slides sideways at omega L / 2. Lengthwise, the wheel
// slides at s, the difference between tread speed and ground speed. The tyre's force is mu N against the
// slide. The balance of moments about the body's middle gives
//   s = omega L^2 / (2 B)
// Wheels of radius r with the rates w and -w therefore turn the body as if their track were
//   B_eff = 2 r w / omega = B + L^2 / B
// at any grip and speed. The moment of the ground against the turn is
//   M = mu m g (L / 2) / sqrt(1 + (L / B)^2)
// A body with wheelbase_m > 0 is computed like a body with track B_eff. The motors' forces then have the arm
// B_eff / 2 instead of B / 2. Moment of inertia and M are therefore multiplied by B_eff / B, too. For evenly
// loaded tracks of length l, L is l / sqrt(3). The load's mean square distance from the middle is then that
// of four wheels.
//
// Source: Coulomb's law at each tyre. No published measurement of B_eff was found, for any speed. Not
// modelled: sideways forces in fast bends, which change M; a centre of mass away from the middle of the
// wheels.
#include <algorithm>

#include "sim/world/body.h"
#include "sim/world/step_constants.h"

namespace robosim::world {

double effective_track(double track, double wheelbase) { return track + wheelbase * wheelbase / track; }

void Body::set_scrub() {
  const double base = params_.wheelbase_m, track = params_.track_m;
  if (!(base > 0.0)) return;
  const double wider = effective_track(track, base);
  const double inertia = params_.yaw_inertia_kgm2 * wider / track;
  const double slant = std::sqrt(1.0 + base * base / (track * track));
  half_track_ = 0.5 * wider;
  per_track_ = 1.0 / wider;
  per_inertia_ = 1.0 / inertia;
  const double turning = inertia * per_track_ * per_track_;
  mass_own_ = params_.mass_kg * 0.25 + turning;
  mass_cross_ = params_.mass_kg * 0.25 - turning;
  const double wheels = (unit_[left].inertia + unit_[right].inertia) * half_track_ * half_track_;
  const double moment = params_.grip * params_.mass_kg * kGravity * 0.5 * base / slant * wider / track;
  scrub_rolling_ = moment * kDt / (inertia + wheels);
  scrub_slipping_ = moment * kDt * per_inertia_;
}

// Slows the turn by M, the moment of the sliding tyres. Call after motors and grip have been applied.
void Body::scrub() {
  const double less = slips_ ? scrub_slipping_ : scrub_rolling_;
  const double turn = omega_ > 0.0 ? std::max(omega_ - less, 0.0) : std::min(omega_ + less, 0.0);
  if (!slips_) {
    surface_[left] = v_ - turn * half_track_;
    surface_[right] = v_ + turn * half_track_;
  }
  omega_ = turn;
}

}  // namespace robosim::world
