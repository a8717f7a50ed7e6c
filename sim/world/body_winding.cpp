// Simulates a driver and motors whose windings have inductance. The table lists the effect of switches and
// diodes in each part of a PWM period. motor_winding.h computes the current.
//
//   part of the period      volts while the current flows forward       and backward
//   driven forward          V - drop, from the battery                  V + 2 V_d, into the battery through
//                                                                       diodes; MOSFETs: V + drop
//   driven backward         as when driven forward, with both directions exchanged and all signs changed
//   shorted                 -drop                                       drop
//   open                    -(V + 2 V_d), into the battery              V + 2 V_d, into the battery
//   open, one switch        -V_d, through the diode across the motor    V + V_d, into the battery
//
// V_d is a diode's voltage drop (driver_diode_volts). The order of the parts is: forward, shorted, backward,
// open. Here "forward" is the command's direction.
//
// A motor that is turned by its wheel delivers at most the energy that the wheel loses. Its torque per
// ampere, against the motion, is therefore the larger of two constants: k_e (volts per rate) and k_t (torque
// per ampere). Unlike k_e, k_t includes the losses of a gear that drives its wheel.
//
// Torque and the supply's current are linearised about the speed at the tick's beginning. The step can
// therefore be implicit, as for the motors in body.h.
#include <algorithm>

#include "sim/base/exponential.h"
#include "sim/world/body.h"
#include "sim/world/step_constants.h"

namespace robosim::world {
namespace {

enum What { forward, shorted, backward, open };

constexpr double kLeastShare = 1e-9;

// Mirrors a phase: swaps forward and backward, and negates voltages and supply currents.
void turn_round(Phase& phase) {
  std::swap(phase.volts[0], phase.volts[1]);
  std::swap(phase.supply[0], phase.supply[1]);
  for (const int way : {0, 1}) {
    phase.volts[way] = -phase.volts[way];
    phase.supply[way] = -phase.supply[way];
  }
}

Phase phase_of(int what, const BodyParams& p, double volts) {
  const double drop = p.driver_drop_volts, diode = p.driver_diode_volts;
  switch (what) {
    case shorted:
      return {0.0, 0.0, {-drop, drop}, {0.0, 0.0}};
    case open:
      if (p.driver_single) return {0.0, 0.0, {-diode, volts + diode}, {0.0, 1.0}};
      return {0.0, 0.0, {-(volts + 2.0 * diode), volts + 2.0 * diode}, {-1.0, 1.0}};
    default:
      return {0.0, 0.0, {volts - drop, volts + (p.driver_both_ways ? drop : 2.0 * diode)}, {1.0, 1.0}};
  }
}

}  // namespace

void Body::set_winding(Side side, const WheelCommand& command) {
  const Unit& unit = unit_[side];
  Winding& winding = winding_[side];
  winding.against = std::min(std::max(bounded(command.against, 1.0), 0.0), 0.5 * unit.brake);
  const double drive = std::fabs(unit.drive);
  const double shares[] = {drive + winding.against, unit.brake - 2.0 * winding.against, winding.against,
                           1.0 - drive - unit.brake};
  winding.tau = command.period_s > 0.0 ? winding.seconds / command.period_s : 0.0;
  winding.phases = 0;
  for (const int what : {forward, shorted, backward, open}) {
    if (shares[what] <= kLeastShare) continue;
    winding.phase[winding.phases++] = {what, shares[what],
                                       winding.tau > 0.0 ? decay_of(shares[what] / winding.tau) : 0.0};
  }
}

MeanCurrent Body::current_of(int side, double supply_volts) const {
  const Winding& winding = winding_[side];
  const double volts = std::max(supply_volts, 0.0);
  const double emf = surface_[side] * unit_[side].volts_per_speed;
  Phase phases[4];
  for (int n = 0; n < winding.phases; ++n) {
    Phase& phase = phases[n] = phase_of(winding.phase[n].what, params_, volts);
    if ((winding.phase[n].what == backward) != (unit_[side].drive < 0.0)) turn_round(phase);
    phase.share = winding.phase[n].share;
    phase.decay = winding.phase[n].decay;
  }
  return mean_current({phases, static_cast<std::size_t>(winding.phases)}, emf, unit_[side].per_ohm,
                      winding.tau);
}

void Body::find_currents() {
  for (const Side side : {left, right}) {
    winding_[side].current = current_of(side, supply_);
    winding_[side].emf = surface_[side] * unit_[side].volts_per_speed;
    winding_[side].pull = pull_of_winding(side);
  }
}

Body::Motor Body::pull_of_winding(Side side) const {
  const Unit& unit = unit_[side];
  const Winding& winding = winding_[side];
  const MeanCurrent& current = winding.current;
  double impulse = unit.drag / (unit.volts_per_speed * unit.per_ohm);  // N s per ampere
  if (current.amps * winding.emf < 0.0) impulse = std::max(impulse, unit.volts_per_speed * kDt);
  return {impulse * (current.amps - current.amps_per_volt * winding.emf),
          -impulse * current.amps_per_volt * unit.volts_per_speed};
}

void Body::draw_by_windings() {
  double drawn = 0.0;
  for (const Side side : {left, right}) {
    const Winding& winding = winding_[side];
    const double emf = surface_[side] * unit_[side].volts_per_speed;
    drawn += winding.current.drawn + winding.current.drawn_per_volt * (emf - winding.emf);
  }
  const double joules = drawn * supply_ * kDt;
  (joules > 0.0 ? energy_ : energy_back_) += std::fabs(joules);
}

}  // namespace robosim::world
