#include "sim/world/body.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <stdexcept>

#include "one_body.h"
#include "tests/support/effort.h"

namespace robosim::world::body_test {

class BodyTest : public OneBodyTest {
 protected:
  static void brake(Body& body) {
    body.command(left, {0.0, 1.0});
    body.command(right, {0.0, 1.0});
  }
};

// Returns parameters with `nominal_volts` at the motors' terminals, and with friction only in the motors.
BodyParams at_nominal_volts() {
  BodyParams p = default_body_params();
  p.driver_drop_volts = p.driver_ohms = 0.0;
  p.supply_volts = p.wheel[left].nominal_volts;
  p.rolling_resistance = 0.0;
  return p;
}

TEST_F(BodyTest, ReachesTheNoLoadSpeedOfItsTorqueSpeedLine) {
  const BodyParams p = at_nominal_volts();
  Body& body = make(p);
  drive(body, 1.0, 1.0);
  run(5.0);
  EXPECT_NEAR(body.wheel_rate(left), p.wheel[left].no_load_rate, 1e-6 * p.wheel[left].no_load_rate);
  EXPECT_NEAR(body.speed(), p.wheel[left].no_load_rate * p.wheel[left].radius_m, 1e-6);
}

TEST_F(BodyTest, StartsWithItsStallTorque) {
  BodyParams p = at_nominal_volts();
  p.grip = 100.0;
  Body& body = make(p);
  drive(body, 1.0, 1.0);
  run(0.001);
  const WheelParams& w = p.wheel[left];
  const double inertia = w.wheel_inertia_kgm2 + w.rotor_inertia_kgm2 * w.gear_ratio * w.gear_ratio;
  const double mass = p.mass_kg + 2.0 * inertia / (w.radius_m * w.radius_m);
  // In the first tick, the body is at rest. Static friction is larger than friction in motion, and reduces
  // the force.
  const double friction = w.stall_torque / (w.stall_current - w.no_load_current) * w.no_load_current;
  const double force = 2.0 * (w.stall_torque - (w.static_friction - 1.0) * friction) / w.radius_m;
  EXPECT_NEAR(body.speed(), force / mass * 0.001, 0.02 * force / mass * 0.001);
}

TEST_F(BodyTest, StallsBelowTheDeadBandAndMovesAboveIt) {
  for (int pwm = 0; pwm <= 30; ++pwm) {
    Body& body = make();
    drive(body, pwm / 255.0, pwm / 255.0);
    run(0.05);
    EXPECT_EQ(body.distance(), 0.0) << "PWM " << pwm;
    EXPECT_EQ(body.wheel_angle(left), 0.0);
  }
  Body& body = make();
  drive(body, 60 / 255.0, 60 / 255.0);
  run(0.5);
  EXPECT_GT(body.distance(), 0.01);
}

TEST_F(BodyTest, AStalledMotorStillDrawsItsCurrent) {
  Body& body = make();
  drive(body, 0.1, 0.1);
  run(1.0);
  const BodyParams& p = body.params();
  const double ohms = p.wheel[left].nominal_volts / p.wheel[left].stall_current + p.driver_ohms;
  EXPECT_NEAR(body.energy(), 2 * 0.1 * p.supply_volts * (p.supply_volts - p.driver_drop_volts) / ohms, 1e-6);
}

TEST_F(BodyTest, APivotTurnsAboutTheAxlesCentre) {
  Body& body = make();
  drive(body, -0.7, 0.7);
  run(3.0);
  EXPECT_GT(body.turn_rate(), 3.0);
  EXPECT_NEAR(body.pose().position.x, 20.0, 1e-9);
  EXPECT_NEAR(body.pose().position.y, 20.0, 1e-9);
  EXPECT_NEAR(length(body.pose().heading), 1.0, 1e-12);
}

TEST_F(BodyTest, WithOneWheelBrakedItTurnsAboutThatWheel) {
  Body& body = make();
  body.command(left, {0.0, 1.0});
  body.command(right, {0.5, 0.0});
  run(2.0);
  EXPECT_EQ(body.wheel_angle(left), 0.0);
  EXPECT_GT(body.wheel_angle(right), 5.0);
  const Vec2 contact = body.pose().to_world({0.0, body.params().track_m / 2});
  EXPECT_NEAR(contact.x, 20.0, 1e-9);
  EXPECT_NEAR(contact.y, 20.0 + body.params().track_m / 2, 1e-9);
}

TEST_F(BodyTest, UnequalWheelsDriveACircleOfTheRightRadius) {
  Body& body = make();
  drive(body, 0.5, 0.8);
  run(8.0);
  const double radius = body.speed() / body.turn_rate();
  const Vec2 centre = body.pose().to_world({0.0, radius});
  for (int i = 0; i < 50; ++i) {
    run(0.05);
    ASSERT_NEAR(length(body.pose().position - centre), radius, 1e-6);
  }
}

TEST_F(BodyTest, WhatIsExtrapolatedInATickIsWhatHappens) {
  Body& body = make();
  drive(body, 0.4, 0.9);
  for (int i = 0; i < 2000; ++i) {
    const Pose said = body.pose_after(0.001);
    const double angle = body.wheel_angle(right) + body.wheel_rate(right) * 0.001;
    world_->step();
    ASSERT_EQ(said.position, body.pose().position);
    ASSERT_EQ(said.heading, body.pose().heading);
    ASSERT_EQ(angle, body.wheel_angle(right));
  }
}

TEST_F(BodyTest, HalfATickTwiceIsATick) {
  Body& body = make();
  drive(body, 0.2, 0.9);
  run(1.0);
  const Pose whole = body.pose_after(0.001), half = body.pose_after(0.0005);
  const double a = 0.0005 * body.turn_rate(), step = body.speed() * 0.0005;
  const Pose again{half.to_world({step * std::sin(a) / a, step * (1 - std::cos(a)) / a}), {}};
  EXPECT_NEAR(again.position.x, whole.position.x, 1e-12);
  EXPECT_NEAR(again.position.y, whole.position.y, 1e-12);
}

TEST_F(BodyTest, BrakingStopsSoonerThanCoasting) {
  BodyParams p = default_body_params();
  p.driver_drop_volts = 0.0;
  double way[2];
  for (const bool braked : {false, true}) {
    Body& body = make(p);
    drive(body, 1.0, 1.0);
    run(3.0);
    const double before = body.distance();
    drive(body, 0.0, 0.0);
    if (braked) brake(body);
    run(5.0);
    EXPECT_EQ(body.speed(), 0.0);
    EXPECT_EQ(body.wheel_rate(left), 0.0);
    way[braked] = body.distance() - before;
  }
  EXPECT_LT(way[true], 0.7 * way[false]);
}

TEST_F(BodyTest, OnAGlassySurfaceTheWheelsSpinAndTheBodyFollowsAtItsGrip) {
  BodyParams p = default_body_params();
  p.grip = 0.05;
  Body& body = make(p);
  drive(body, 1.0, 1.0);
  run(0.2);
  EXPECT_TRUE(body.slips());
  EXPECT_GT(body.wheel_rate(left) * p.wheel[left].radius_m, 1.5 * body.speed());
  EXPECT_NEAR(body.speed(), p.grip * p.load_share * 9.80665 * 0.2, 1e-3);
  run(10.0);
  EXPECT_FALSE(body.slips());
  EXPECT_NEAR(body.wheel_rate(left) * p.wheel[left].radius_m, body.speed(), 1e-9);
}

TEST_F(BodyTest, WithGoodGripItRollsWithoutSlip) {
  Body& body = make();
  for (int i = 0; i < 3000; ++i) {
    drive(body, i % 500 < 250 ? 0.6 : 0.3, 0.5);
    world_->step();
    ASSERT_FALSE(body.slips());
    ASSERT_NEAR(body.wheel_rate(left) * 0.0325, body.speed() - body.turn_rate() * 0.065, 1e-9);
  }
}

TEST_F(BodyTest, TooFastInABendItSkidsOutward) {
  BodyParams p = default_body_params();
  p.wheel[left].no_load_rate *= 3.0;
  p.wheel[right].no_load_rate *= 3.0;
  p.grip = 0.4;
  Body& body = make(p);
  drive(body, 1.0, 1.0);
  run(4.0);
  EXPECT_EQ(body.side_speed(), 0.0);
  drive(body, 0.3, 1.0);
  double most = 0.0;
  for (int i = 0; i < 1000; ++i) {
    world_->step();
    most = std::max(most, -body.side_speed());
  }
  EXPECT_GT(most, 0.01);  // the body turns left and slides to the right
}

TEST_F(BodyTest, AcceleratingAndTurningShareOneGrip) {
  BodyParams p = default_body_params();
  p.wheel[left].no_load_rate *= 3.0;
  p.wheel[right].no_load_rate *= 3.0;
  p.grip = 0.4;
  const double limit = p.grip * p.load_share * 9.80665;
  Body& body = make(p);
  double most = 0.0;
  for (int i = 0; i < 20000; ++i) {
    if (i % 400 == 0) drive(body, i % 800 ? 1.0 : 0.5, i % 1200 ? 0.6 : 1.0);
    const double before = body.speed(), across = body.speed() * body.turn_rate();
    world_->step();
    if (body.side_speed() != 0.0) continue;  // while the body skids, its axes rotate relative to its velocity
    most = std::max(most, std::hypot((body.speed() - before) / 0.001, across));
  }
  EXPECT_LT(most, limit * 1.01);
  EXPECT_GT(most, limit * 0.9);
}

TEST_F(BodyTest, NeverGainsMoreEnergyThanItDraws) {
  for (const double grip : {0.05, 0.3, 0.8}) {
    BodyParams p = default_body_params();
    p.grip = grip;
    Body& body = make(p);
    unsigned random = 1;
    for (int i = 0; i < 20000; ++i) {
      if (i % 50 == 0) {
        random = random * 1664525u + 1013904223u;
        body.command(left, {static_cast<int>(random >> 8 & 511) / 255.5 - 1.0, (random >> 30 & 1) * 1.0});
        body.command(right, {static_cast<int>(random >> 17 & 511) / 255.5 - 1.0, (random >> 31) * 1.0});
      }
      const double kinetic = body.kinetic_energy(), drawn = body.energy();
      world_->step();
      ASSERT_LE(body.kinetic_energy() - kinetic, body.energy() - drawn + 1e-12) << "tick " << i;
    }
  }
}

TEST_F(BodyTest, WithoutPowerItComesToRestExactlyAndStays) {
  BodyParams p = default_body_params();
  p.wheel[left].no_load_current = p.wheel[right].no_load_current = 0.0;
  p.rolling_resistance = 0.0;
  p.driver_drop_volts = 0.0;
  Body& body = make(p);
  drive(body, 1.0, 0.8);
  run(2.0);
  brake(body);
  run(20.0);
  EXPECT_EQ(body.speed(), 0.0);
  EXPECT_EQ(body.turn_rate(), 0.0);
  EXPECT_EQ(body.wheel_rate(right), 0.0);
}

TEST_F(BodyTest, ReversingBrakesThroughZero) {
  Body& body = make();
  drive(body, 1.0, 1.0);
  run(2.0);
  drive(body, -1.0, -1.0);
  run(3.0);
  EXPECT_LT(body.speed(), -0.5);
  EXPECT_GT(body.distance(), 2.0);
  EXPECT_GT(body.wheel_travel(), 2.0);
}

TEST_F(BodyTest, LiftedAndPutDownItIsAtRest) {
  Body& body = make();
  drive(body, 1.0, 0.5);
  run(1.0);
  const double angle = body.wheel_angle(left), distance = body.distance();
  body.place({{3.0, 4.0}, {0.0, 2.0}});
  EXPECT_EQ(body.pose().position, (Vec2{3.0, 4.0}));
  EXPECT_EQ(body.pose().heading, (Vec2{0.0, 1.0}));
  EXPECT_EQ(body.speed(), 0.0);
  EXPECT_EQ(body.wheel_angle(left), angle);
  EXPECT_EQ(body.distance(), distance);
}

TEST_F(BodyTest, InTheHandItsWheelsReachTheNoLoadSpeedAndItStaysWhereItIs) {
  BodyParams p = at_nominal_volts();
  p.rolling_resistance = 0.1;
  Body& body = make(p);
  drive(body, 1.0, -1.0);
  body.lift(true);
  run(5.0);
  EXPECT_NEAR(body.wheel_rate(left), p.wheel[left].no_load_rate, 1e-6 * p.wheel[left].no_load_rate);
  EXPECT_NEAR(body.wheel_rate(right), -p.wheel[left].no_load_rate, 1e-6 * p.wheel[left].no_load_rate);
  EXPECT_EQ(body.pose().position.x, 20.0);
  EXPECT_EQ(body.pose().heading.x, 1.0);
  EXPECT_EQ(body.distance(), 0.0);
  EXPECT_GT(body.wheel_angle(left), 10.0);
}

TEST_F(BodyTest, PutDownWithTurningWheelsItDrivesOn) {
  Body& body = make();
  drive(body, 1.0, 1.0);
  body.lift(true);
  run(1.0);
  EXPECT_EQ(body.speed(), 0.0);
  body.lift(false);
  run(0.001);
  EXPECT_TRUE(body.slips());
  run(1.0);
  EXPECT_GT(body.speed(), 0.3);
  EXPECT_FALSE(body.slips());
}

TEST_F(BodyTest, RunsOutInTheHandUntilItsWheelsStandExactly) {
  Body& body = make();
  drive(body, 1.0, 1.0);
  body.lift(true);
  run(1.0);
  drive(body, 0.0, 0.0);
  run(5.0);
  EXPECT_EQ(body.wheel_rate(left), 0.0);
}

TEST_F(BodyTest, ABlockedWheelStandsAndTheOtherOneDrivesRoundIt) {
  Body& body = make();
  drive(body, 0.6, 0.6);
  run(1.0);
  body.block(left, true);
  run(1.0);
  EXPECT_EQ(body.wheel_rate(left), 0.0);
  EXPECT_GT(body.turn_rate(), 1.0);
  const double energy = body.energy();
  drive(body, 0.6, 0.0);
  run(2.0);
  EXPECT_EQ(body.speed(), 0.0);
  EXPECT_GT(body.energy(), energy) << "the motor stalls";
  body.block(left, false);
  drive(body, 0.6, 0.6);
  run(1.0);
  EXPECT_GT(body.wheel_rate(left), 1.0);
}

TEST_F(BodyTest, WithLessSupplyItIsSlowerInProportion) {
  BodyParams p = at_nominal_volts();
  Body& body = make(p);
  drive(body, 1.0, 1.0);
  body.supply(0.5 * p.supply_volts);
  run(5.0);
  // The rate without torque falls in proportion to the supply, but friction is unchanged.
  const double lost = p.wheel[left].stall_torque / p.wheel[left].no_load_rate;
  const double slower = 0.5 * p.wheel[left].no_load_rate;
  EXPECT_LT(body.wheel_rate(left), slower);
  EXPECT_GT(body.wheel_rate(left), 0.8 * slower) << lost;
  body.supply(p.supply_volts);
  run(5.0);
  EXPECT_NEAR(body.wheel_rate(left), p.wheel[left].no_load_rate, 1e-6 * p.wheel[left].no_load_rate);
  body.supply(0.0);
  run(5.0);
  EXPECT_EQ(body.wheel_rate(left), 0.0);
}

TEST_F(BodyTest, CoversWhatIsInsideItsOutline) {
  Body& round = make();
  EXPECT_TRUE(round.covers({20.079, 20.0}));
  EXPECT_FALSE(round.covers({20.081, 20.0}));
  BodyParams p = default_body_params();
  p.outline = {{-0.05, -0.04}, {0.1, -0.04}, {0.1, 0.04}, {-0.05, 0.04}};
  Body& box = make(p);
  box.place({{20.0, 20.0}, {0.0, 1.0}});
  EXPECT_TRUE(box.covers({20.0, 20.099}));
  EXPECT_TRUE(box.covers({20.039, 19.951}));
  EXPECT_FALSE(box.covers({20.0, 19.949}));
  EXPECT_FALSE(box.covers({20.041, 20.0}));
}

TEST_F(BodyTest, ZeroIsNotSilentlyABody) {
  EXPECT_THROW(make(BodyParams{}), std::invalid_argument);
  BodyParams p = default_body_params();
  p.outline = {{0.0, 0.0}, {0.0, 0.1}, {0.1, 0.0}};  // the corners are clockwise
  EXPECT_THROW(make(p), std::invalid_argument);
}

// Multiplies the parameters by random factors from 1e-12 to 1e12.
TEST_F(BodyTest, StaysFiniteForAnyPositiveParameters) {
  unsigned random = 7;
  const auto absurd = [&random](double& value) {
    random = random * 1664525u + 1013904223u;
    constexpr double factors[] = {1e-12, 1e-6, 1e-3, 1.0, 1.0, 1.0, 1e3, 1e6, 1e12};
    value *= factors[(random >> 10) % 9];
  };
  for (int round = 0; round < test::rounds(300); ++round) {
    BodyParams p = default_body_params();
    for (WheelParams& w : p.wheel) {
      absurd(w.no_load_rate), absurd(w.stall_torque), absurd(w.rotor_inertia_kgm2);
      absurd(w.wheel_inertia_kgm2), absurd(w.radius_m), absurd(w.gear_ratio), absurd(w.nominal_volts);
    }
    absurd(p.supply_volts), absurd(p.track_m), absurd(p.mass_kg), absurd(p.yaw_inertia_kgm2), absurd(p.grip);
    Body& body = make(p);
    body.command(left, {1.0, 0.0});
    body.command(right, {-0.3, 0.5});
    for (int i = 0; i < 20; ++i) world_->step();
    body.command(left, {-1.0, 0.0});
    for (int i = 0; i < 20; ++i) world_->step();
    ASSERT_TRUE(std::isfinite(body.pose().position.x) && std::isfinite(body.pose().heading.x)) << round;
    ASSERT_TRUE(std::isfinite(body.speed()) && std::isfinite(body.wheel_rate(left))) << round;
    ASSERT_TRUE(std::isfinite(body.wheel_rate(right)) && std::isfinite(body.turn_rate())) << round;
    ASSERT_NEAR(length(body.pose().heading), 1.0, 1e-3) << round;
  }
}

}  // namespace robosim::world::body_test
