// Computes the current in a motor's winding, averaged over a PWM period T.
//
//   L di/dt = v - R i - E        tau = L / R; E = k_e w (back-EMF at rate w), constant during a period
//
// In each phase of a period a driver applies a voltage v to the winding. With diodes, v may depend on the
// current's direction: v+ while it flows forward, v- >= v+ while it flows backward. If no current flows, and
// neither voltage would start a current, the current stays 0. In a phase of duration t with constant v,
//   i(t) = a + (i(0) - a) e^(-t / tau),  integral of i = a t - tau (i(t) - i(0)),  a = (v - E) / R
// If a and i(0) have opposite signs, the current reaches 0 after tau ln(1 - i(0) / a). In the steady state,
// the current at a period's end equals the current at its beginning. Newton's method finds this current in 1
// to 3 periods: while the current keeps its sign, the current at the end depends linearly on the current at
// the beginning. Single pulses are not simulated.
//
// The following holds if the driver applies V for the part D T of each period, without voltage drops.
// Source: Erickson and Maksimovic, Fundamentals of Power Electronics, chapters 2 and 5, whose converters have
// R = 0.
//   shorted in between (slow decay):     mean i = (D V - E) / R, at any T; the current from the battery drops
//                                        from D V (V - E) / R for T >> tau to D V (D V - E) / R for T << tau
//   ripple, peak to peak:                V / R (1 - e^(-D T / tau)) (1 - e^(-(1 - D) T / tau)) /
//                                        (1 - e^(-T / tau)), which for T << tau is V D (1 - D) T / L
//   open in between (fast decay):        the current continues through the diodes into the battery, against
//                                        V + 2 V_d, and ends before the period does (discontinuous), unless
//                                        D V - (1 - D) (V + 2 V_d) > E, for T << tau
//   if discontinuous, T << tau:          mean i = (V - E) D^2 T / (2 L) (1 + (V - E) / (V + 2 V_d + E))
// If E > D V and the winding is shorted in between, the driven phase returns current to the battery: the
// motor recovers energy. If the winding is shorted throughout, the energy turns to heat in the winding.
//
// Not modelled: transients of a few tau after a change of duty cycle or speed (each tick is in its steady
// state); saturation, iron losses, and a battery that does not accept current.
#pragma once

#include <span>

namespace robosim::world {

/// One part of a period. Forward currents are positive.
struct Phase {
  double share = 0.0;     ///< share of the period
  double decay = 0.0;     ///< e^-(share T / tau)
  double volts[2] = {};   ///< voltage on the winding while its current flows forward, and backward
  double supply[2] = {};  ///< the supply's current in each case, as a multiple of the winding's: -1, 0 or 1
};

/// Means over a period, and their slopes with respect to E.
struct MeanCurrent {
  double amps = 0.0, amps_per_volt = 0.0;    ///< A of the winding
  double drawn = 0.0, drawn_per_volt = 0.0;  ///< A from the supply; below 0, into the supply
};

/// Computes the mean currents of a period. `tau` is L / R as a multiple of the period. If `tau` is 0 (the
/// period is unknown, or much longer than L / R), the current has its final value in each phase. Expects at
/// most four phases, whose shares add up to 1.
MeanCurrent mean_current(std::span<const Phase> phases, double emf, double per_ohm, double tau);

}  // namespace robosim::world
