// Bodies that turn by skidding: four wheels, two driven together on each side, or tracks.
//
// Wheels wheelbase L apart on each side, track B between the sides, the load even on all four, grip mu. While
// it turns at omega, each wheel slides sideways at omega L / 2. It slides along at s, by which its tread is
// faster or slower than the ground. The tyre's force is mu N against its slide. Balance of the moments about
// its middle gives
//   s = omega L^2 / (2 B)      so that treads at r w to each side turn it as if they were farther apart:
//   B_eff = 2 r w / omega = B + L^2 / B
// whatever the grip and the speed, and a moment of the ground against it of
//   M = mu m g (L / 2) / sqrt(1 + (L / B)^2)
// A body with wheelbase_m > 0 has the treads, forces and moments of one with track B_eff; its moment of
// inertia and M times B_eff / B, so that motors and turning are as above. Of tracks of length l, whose load
// is even along them, L is l / sqrt(3), which has the same mean square.
//
// Source: Coulomb's law at each tyre. Nobody's measured B_eff was found, against speed or at rest. Not
// modelled: sideways forces in fast bends, which change M, and a centre of mass away from the middle of the
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

// After motors and grip: applies the turn that remains after the tyres' sideways slide.
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
