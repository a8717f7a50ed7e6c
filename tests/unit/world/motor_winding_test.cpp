// Tests motors with inductance on a driver. Compares them with closed forms, within 2 %, and with pulses that
// are simulated step by step.
#include "sim/world/motor_winding.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "one_body.h"
#include "sim/base/exponential.h"
#include "sim/base/noise.h"
#include "sim/world/step_constants.h"

namespace robosim::world::motor_winding_test {

constexpr double kWithinFormula = 0.02;
constexpr double kVolts = 6.0, kOhms = 4.0, kHenries = 2e-3;

Phase driven(double share) { return {share, 0.0, {kVolts, kVolts}, {1.0, 1.0}}; }
Phase shorted(double share) { return {share, 0.0, {0.0, 0.0}, {0.0, 0.0}}; }
Phase open(double share, double diode) {
  return {share, 0.0, {-(kVolts + 2.0 * diode), kVolts + 2.0 * diode}, {-1.0, 1.0}};
}

MeanCurrent mean(std::vector<Phase> phases, double emf, double period) {
  const double tau = kHenries / kOhms / period;
  for (Phase& phase : phases) phase.decay = decay_of(phase.share / tau);
  return mean_current(phases, emf, 1.0 / kOhms, tau);
}

TEST(Exponential, IsThatOfTheLibrary) {
  for (const double x : {0.0, 1e-9, 0.3, 1.0, 7.7, 40.0, 699.0}) {
    EXPECT_NEAR(decay_of(x), std::exp(-x), 2e-15 * std::exp(-x)) << x;
    EXPECT_NEAR(log_of(1.0 + x), std::log(1.0 + x), 2e-15 * (1.0 + x)) << x;
    EXPECT_NEAR(log_of(decay_of(x)), -x, 3e-15 * (1.0 + x)) << x;
  }
  EXPECT_EQ(decay_of(1e9), 0.0);
}

TEST(Winding, ShortedBetweenItsPulsesHasTheMeanOfTheVoltsAtAnyFrequency) {
  for (const double period : {1e-5, 1e-3, 1e-1}) {
    const MeanCurrent current = mean({driven(0.4), shorted(0.6)}, 1.0, period);
    EXPECT_NEAR(current.amps, (0.4 * kVolts - 1.0) / kOhms, 1e-9) << period;
    EXPECT_NEAR(current.amps_per_volt, -1.0 / kOhms, 1e-9) << period;
  }
}

TEST(Winding, DrawsLessTheFasterItsPulsesAre) {
  const double share = 0.4, emf = 1.0;
  const double slow = mean({driven(share), shorted(1.0 - share)}, emf, 1.0).drawn;
  EXPECT_NEAR(slow, share * (kVolts - emf) / kOhms, kWithinFormula * slow);
  const double fast = mean({driven(share), shorted(1.0 - share)}, emf, 2e-5).drawn;
  EXPECT_NEAR(fast, share * (share * kVolts - emf) / kOhms, kWithinFormula * fast);
  // At medium frequencies, the ripple of the current also heats the winding. The ripple's height is
  // V D (1 - D) T / L. Its mean square is a twelfth of the squared height. The drawn power exceeds V D times
  // the mean current by R times the mean square. V is the supply, D the duty cycle, T the period, R the
  // resistance, and L the inductance.
  const double period = 1e-4;
  const double ripple = kVolts * share * (1.0 - share) * period / kHenries;
  const double more = kVolts * mean({driven(share), shorted(1.0 - share)}, emf, period).drawn -
                      kVolts * share * (share * kVolts - emf) / kOhms;
  EXPECT_NEAR(more, kOhms * ripple * ripple / 12.0, kWithinFormula * more);
}

TEST(Winding, OpenBetweenItsPulsesIsDiscontinuousBelowTheBoundary) {
  const double emf = 0.5, diode = 1.0, period = 2e-6, back = kVolts + 2.0 * diode;
  const double boundary = (emf + back) / (kVolts + back);
  for (const double share : {0.2, 0.4, 0.98 * boundary}) {
    const double expected =
        (kVolts - emf) * share * share * period / (2.0 * kHenries) * (1.0 + (kVolts - emf) / (back + emf));
    EXPECT_NEAR(mean({driven(share), open(1.0 - share, diode)}, emf, period).amps, expected,
                kWithinFormula * expected)
        << share;
  }
  for (const double share : {1.02 * boundary, 0.8}) {
    const double expected = (share * kVolts - (1.0 - share) * back - emf) / kOhms;
    EXPECT_NEAR(mean({driven(share), open(1.0 - share, diode)}, emf, period).amps, expected,
                kWithinFormula * expected)
        << share;
  }
}

TEST(Winding, DrivenBothWaysByTurnsHeatsTheMotorAtRest) {
  const std::vector<Phase> halves = {driven(0.5), {0.5, 0.0, {-kVolts, -kVolts}, {-1.0, -1.0}}};
  EXPECT_NEAR(mean(halves, 0.0, 1e-3).amps, 0.0, 1e-12);
  EXPECT_NEAR(mean(halves, 0.0, 1.0).drawn, kVolts / kOhms, kWithinFormula * kVolts / kOhms);
  EXPECT_NEAR(mean(halves, 0.0, 1e-5).drawn, 0.0, 1e-3);
}

// Simulates one period after another in small steps, until the current repeats.
MeanCurrent followed(const std::vector<Phase>& phases, double emf, double period) {
  constexpr int kSteps = 20000;
  double amps = 0.0, before = 1.0;
  MeanCurrent sum;
  for (int n = 0; n < 400 && std::fabs(amps - before) > 1e-9; ++n) {
    before = amps;
    sum = {};
    for (const Phase& phase : phases) {
      const double dt = phase.share * period / kSteps;
      for (int step = 0; step < kSteps; ++step) {
        const double now = amps;
        const int way = now > 0.0 || (now == 0.0 && phase.volts[0] > emf) ? 0 : 1;
        if (now == 0.0 && way == 1 && !(phase.volts[1] < emf)) break;
        amps += (phase.volts[way] - emf - kOhms * now) / kHenries * dt;
        if (amps * now < 0.0) amps = 0.0;
        const double mid = 0.5 * (now + amps);
        sum.amps += mid * dt / period;
        sum.drawn += phase.supply[way] * mid * dt / period;
      }
    }
  }
  return sum;
}

TEST(Winding, HasTheMeanOfPulsesThatAreFollowedStepByStep) {
  const NoiseStream random(1, 0, "winding", "test");
  std::uint64_t n = 0;
  for (int i = 0; i < 30; ++i) {
    const double share = random.uniform(n++), other = random.uniform(n++) * (1.0 - share);
    const double drop = random.uniform(n++) < 0.5 ? 0.0 : 1.4;
    const double emf = 16.0 * random.uniform(n++) - 8.0,
                 period = kHenries / kOhms * (0.3 + 4.0 * random.uniform(n++));
    const std::vector<Phase> phases = {
        {share, 0.0, {kVolts - drop, kVolts + drop}, {1.0, 1.0}},
        {other, 0.0, {-drop, drop}, {0.0, 0.0}},
        {1.0 - share - other, 0.0, {-kVolts - 1.5, kVolts + 1.5}, {-1.0, 1.0}}};
    const MeanCurrent found = mean(phases, emf, period), due = followed(phases, emf, period);
    EXPECT_NEAR(found.amps, due.amps, 5e-4) << i;
    EXPECT_NEAR(found.drawn, due.drawn, 5e-4) << i;
    const double h = 1e-5;
    const MeanCurrent more = mean(phases, emf + h, period), less = mean(phases, emf - h, period);
    EXPECT_NEAR(found.amps_per_volt, (more.amps - less.amps) / (2.0 * h), 1e-4) << i;
    EXPECT_NEAR(found.drawn_per_volt, (more.drawn - less.drawn) / (2.0 * h), 1e-4) << i;
  }
}

// Provides a body without friction. Its driver has MOSFETs, and its motors have an inductance of 1 mH.
class WoundBody : public OneBodyTest {
 protected:
  static BodyParams wound() {
    BodyParams p = default_body_params();
    p.driver_drop_volts = p.rolling_resistance = 0.0;
    p.driver_diode_volts = 0.8;
    p.grip = 10.0;
    for (WheelParams& wheel : p.wheel) {
      wheel.no_load_current = 0.0;
      wheel.inductance_h = 1e-3;
    }
    return p;
  }
  static void both(Body& body, const WheelCommand& command) {
    body.command(left, command);
    body.command(right, command);
  }
  /// Returns the mass that the motors accelerate, in kg.
  static double mass(const BodyParams& p) {
    const WheelParams& w = p.wheel[left];
    const double inertia = w.wheel_inertia_kgm2 + w.rotor_inertia_kgm2 * w.gear_ratio * w.gear_ratio;
    return p.mass_kg + 2.0 * inertia / (w.radius_m * w.radius_m);
  }
};

// If the wheel turns the motor, the motor's torque per ampere is k_e (see body.h). The loss of speed
// therefore determines the charge. The duty cycle is 0.5, so half of this charge flows into the battery.
TEST_F(WoundBody, GivesBackWhatASlowerDutyTakesOffItsSpeed) {
  const BodyParams p = wound();
  const WheelParams& w = p.wheel[left];
  for (const double period : {1.0 / 20000.0, 1.0}) {
    Body& body = make(p);
    both(body, {1.0, 0.0});
    run(4.0);
    const double speed = body.speed(), kinetic = body.kinetic_energy();
    EXPECT_EQ(body.energy_back(), 0.0);
    both(body, {0.5, 0.5, 0.0, period});
    run(4.0);
    EXPECT_NEAR(body.speed(), 0.5 * speed, kWithinFormula * speed);
    if (period > 0.1) {
      EXPECT_EQ(body.energy_back(), 0.0) << "between slow pulses, the energy heats the winding";
      continue;
    }
    const double expected = 0.5 * p.supply_volts * mass(p) * (speed - body.speed()) * w.radius_m /
                            (w.nominal_volts / w.no_load_rate);
    EXPECT_NEAR(body.energy_back(), expected, kWithinFormula * expected);
    EXPECT_NEAR(body.energy_back(), 0.5 * kinetic, 0.03 * kinetic);
  }
}

TEST_F(WoundBody, CoastsAsFarAsItsFrictionLetsItAndBrakesAsFarAsItsWindingDoes) {
  BodyParams p = wound();
  p.mass_kg = 2.5;
  for (WheelParams& wheel : p.wheel) wheel.no_load_current = 0.15;
  const WheelParams& w = p.wheel[left];
  const double per_ampere = w.stall_torque / (w.stall_current - w.no_load_current) / w.radius_m;  // N per A
  const double ohms = w.nominal_volts / w.stall_current;
  const double per_speed = (w.nominal_volts - ohms * w.no_load_current) / w.no_load_rate / w.radius_m;
  const double slows = 2.0 * per_ampere * w.no_load_current / mass(p);
  const double tau = mass(p) * (ohms + p.driver_ohms) / (2.0 * per_speed * per_speed);
  for (const double brake : {0.0, 1.0}) {
    Body& body = make(p);
    both(body, {0.8, 0.2, 0.0, 5e-5});
    run(3.0);
    const double speed = body.speed(), from = body.distance(), drawn = body.energy();
    both(body, {0.0, brake});
    run(9.0);
    EXPECT_EQ(body.speed(), 0.0);
    const double expected = brake > 0.0
                                ? tau * speed - tau * tau * slows * std::log(1.0 + speed / (tau * slows))
                                : speed * speed / (2.0 * slows);
    EXPECT_NEAR(body.distance() - from, expected, kWithinFormula * expected) << brake;
    EXPECT_EQ(body.energy(), drawn);
    EXPECT_EQ(body.energy_back(), 0.0) << "in a shorted motor, the energy heats the winding";
  }
}

}  // namespace robosim::world::motor_winding_test
