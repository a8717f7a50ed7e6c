// The current in a motor's winding, averaged over a period T of PWM.
//
//   L di/dt = v - R i - E        tau = L / R; E = k_e w, which a period does not change
// In each phase of a period a driver puts a voltage v on the winding, which may depend on which way the
// current flows, as diodes do: v+ while it flows forward, v- >= v+ while it flows backward, and none where it
// does not flow and neither would make it. For a phase of t with one v,
//   i(t) = a + (i(0) - a) e^(-t / tau),  integral of i = a t - tau (i(t) - i(0)),  a = (v - E) / R
// and with a of the other sign it is at 0 after tau ln(1 - i(0) / a). What a period begins with it ends with
// (the steady state), which is found by Newton's method: 1 to 3 periods, since where the current does not
// change its sign the end is a straight line of the beginning. No pulse is simulated.
//
// So, with the motor driven for D T at V, and no drops (Erickson and Maksimovic, Fundamentals of Power
// Electronics, chapters 2 and 5, whose converters have R = 0):
//   shorted in between (slow decay):     mean i = (D V - E) / R, at any T; what is drawn of the battery falls
//                                        from D V (V - E) / R for T >> tau to D V (D V - E) / R for T << tau
//   ripple, peak to peak:                V / R (1 - e^(-D T / tau)) (1 - e^(-(1 - D) T / tau)) /
//                                        (1 - e^(-T / tau)), which for T << tau is V D (1 - D) T / L
//   open in between (fast decay):        the current goes on through the diodes into the battery, against
//                                        V + 2 V_d, and is over before the period is (discontinuous), unless
//                                        D V - (1 - D) (V + 2 V_d) > E, for T << tau
//   then, for T << tau:                  mean i = (V - E) D^2 T / (2 L) (1 + (V - E) / (V + 2 V_d + E))
// Shorted in between and E > D V, the current flows back into the battery while it is driven: that is how a
// motor recovers energy. Shorted throughout it burns in the winding.
//
// Not modelled: what a change of duty or of speed does to the current within some tau (it is in its steady
// state in every tick), saturation, iron losses, and a battery that does not take back what flows into it.
#pragma once

#include <span>

namespace robosim::world {

/// One part of a period. Currents forward are positive.
struct Phase {
  double share = 0.0;     ///< of the period
  double decay = 0.0;     ///< e^-(share T / tau)
  double volts[2] = {};   ///< on the winding while its current flows forward, and backward
  double supply[2] = {};  ///< the supply's current in each case, as a multiple of the winding's: -1, 0 or 1
};

/// Means of a period, and by how much they grow with E.
struct MeanCurrent {
  double amps = 0.0, amps_per_volt = 0.0;    ///< A of the winding
  double drawn = 0.0, drawn_per_volt = 0.0;  ///< A of the supply; below 0 it gets them
};

/// `tau`: L / R as a multiple of the period; 0: the period is much longer, or it is not known, and the
/// current is what it ends with in each phase. At most four phases, of 1 in all.
MeanCurrent mean_current(std::span<const Phase> phases, double emf, double per_ohm, double tau);

}  // namespace robosim::world
