// Compares bodies with steered wheels with closed forms, within 2 %.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "one_body.h"
#include "sim/world/step_constants.h"

namespace robosim::world::steer_test {

constexpr double kSteeredWithin = 0.02;
constexpr double kDegree = std::numbers::pi / 180.0;

class SteerTest : public OneBodyTest {
 protected:
  static BodyParams car() {
    BodyParams p = default_body_params();
    p.steer_base_m = p.caster_m = 0.14;
    p.load_share = 0.5;
    p.differential = true;
    return p;
  }
};

TEST_F(SteerTest, TurnsOnTheRadiusOfTheBicycleModel) {
  for (const bool differential : {true, false}) {
    for (const double degrees : {-30.0, -5.0, 2.0, 10.0, 25.0, 45.0}) {
      for (const double share : {0.5, -0.5}) {
        BodyParams p = car();
        p.differential = differential;
        Body& body = make(p);
        const double radius = p.steer_base_m / std::tan(degrees * kDegree);
        body.steer(degrees * kDegree);
        drive(body, share);
        run(2.0);
        EXPECT_GT(std::fabs(body.speed()), 0.1);
        EXPECT_NEAR(body.turn_rate(), body.speed() / radius,
                    kSteeredWithin * std::fabs(body.speed() / radius));
        // The body stays on a circle around this centre.
        EXPECT_NEAR(length(body.pose().position - Vec2{20.0, 20.0 + radius}), std::fabs(radius),
                    kSteeredWithin * std::fabs(radius))
            << degrees << ' ' << share;
        const double ratio = 1.0 - 0.5 * p.track_m / radius;
        EXPECT_NEAR(body.tread_speed(left), ratio * body.speed(), kSteeredWithin * std::fabs(body.speed()));
      }
    }
  }
}

TEST_F(SteerTest, ADifferentialsMotorHasTheSpeedOfTheMiddle) {
  // Drives straight and in a bend, without friction. In both cases, the motor's back-EMF rises to the supply
  // voltage. The middle of the axle is therefore as fast in the bend as on the straight.
  BodyParams p = car();
  p.rolling_resistance = 0.0;
  p.grip = 3.0;
  for (WheelParams& wheel : p.wheel) wheel.no_load_current = 0.0;
  const WheelParams& w = p.wheel[left];
  const double expected =
      (p.supply_volts - p.driver_drop_volts) / w.nominal_volts * w.no_load_rate * w.radius_m * 0.5;
  double straight = 0.0;
  for (const double degrees : {0.0, 20.0}) {
    Body& body = make(p);
    body.steer(degrees * kDegree);
    body.command(left, {0.5, 0.5});
    body.command(right, {0.5, 0.5});
    run(4.0);
    EXPECT_GT(body.speed(), 0.5 * expected);
    if (degrees == 0.0) straight = body.speed();
    EXPECT_NEAR(body.speed(), straight, 1e-3 * straight) << degrees;
  }
}

TEST_F(SteerTest, GoesWideWhereItsTyresDoNotHoldTheBend) {
  BodyParams p = car();
  p.grip = 0.25;
  for (const double degrees : {8.0, 35.0}) {
    Body& body = make(p);
    drive(body, 1.0);
    run(3.0);
    const double asked = std::tan(degrees * kDegree) / p.steer_base_m;
    body.steer(degrees * kDegree);
    run(1.0);
    const double v = body.speed();
    if (asked * v * v < 0.6 * p.grip * kGravity)
      EXPECT_NEAR(body.turn_rate(), asked * v, kSteeredWithin * asked * v) << degrees;
    else
      EXPECT_LT(body.turn_rate(), 0.9 * asked * v) << degrees;
  }
}

TEST_F(SteerTest, TheSteeredWheelsOfACarPointToOneCentre) {
  const double base = 0.14, track = 0.1, inner = 30.0 * kDegree;
  const double radius = base / std::tan(inner) + 0.5 * track;
  EXPECT_NEAR(steered_middle(inner, track, base), std::atan(base / radius), 1e-9);
  EXPECT_NEAR(steered_middle(-inner, track, base), -std::atan(base / radius), 1e-9);
}

TEST_F(SteerTest, StandsWhateverItsServoDoes) {
  Body& body = make(car());
  for (const double degrees : {-30.0, 30.0, 0.0}) {
    body.steer(degrees * kDegree);
    run(0.2);
  }
  EXPECT_EQ(body.pose().position.x, 20.0);
  EXPECT_EQ(body.turn_rate(), 0.0);
}

}  // namespace robosim::world::steer_test
