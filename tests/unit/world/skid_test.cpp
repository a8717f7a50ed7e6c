// Tests bodies that turn by skidding, and bodies that a fan presses down. Compares them with closed forms,
// within 2 %.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "one_body.h"
#include "sim/world/step_constants.h"

namespace robosim::world::skid_test {

constexpr double kTwoPercent = 0.02;

class SkidTest : public OneBodyTest {
 protected:
  /// Returns parameters of a body with four wheels and strong motors.
  static BodyParams rover() {
    BodyParams p = default_body_params();
    p.wheelbase_m = 0.11;
    p.load_share = 1.0;
    for (WheelParams& wheel : p.wheel) wheel.stall_torque *= 4.0;
    return p;
  }
};

TEST_F(SkidTest, TurnsAsIfItsSidesWereFartherApart) {
  for (const double base : {0.06, 0.11, 0.13}) {
    for (const double share : {0.6, 1.0}) {
      BodyParams p = rover();
      p.wheelbase_m = base;
      Body& body = make(p);
      drive(body, -share, share);
      run(3.0);
      const double tread = p.wheel[right].radius_m * body.wheel_rate(right);
      const double expected = 2.0 * tread / (p.track_m + base * base / p.track_m);
      EXPECT_GT(tread, 0.1);
      EXPECT_NEAR(body.turn_rate(), expected, kTwoPercent * expected) << base << ' ' << share;
      EXPECT_NEAR(length(body.pose().position - Vec2{20.0, 20.0}), 0.0, 1e-6);
    }
  }
}

TEST_F(SkidTest, StraightOnItIsAsFastAsOnACaster) {
  BodyParams p = rover();
  Body& skids = make(p);
  drive(skids, 0.7, 0.7);
  run(3.0);
  const double speed = skids.speed();
  p.wheelbase_m = 0.0;
  Body& rolls = make(p);
  drive(rolls, 0.7, 0.7);
  run(3.0);
  EXPECT_NEAR(speed, rolls.speed(), 1e-9);
}

TEST_F(SkidTest, TurnsOnlyWhereItsMotorsOvercomeTheSidewaysSlide) {
  BodyParams p = rover();
  p.grip = 0.5;
  for (WheelParams& wheel : p.wheel) wheel.no_load_current = 0.0;
  p.rolling_resistance = p.driver_drop_volts = p.driver_ohms = 0.0;
  const WheelParams& w = p.wheel[right];
  // Each side must push with the force M / B. M is the moment of the ground's friction on the
  // sliding wheels, which opposes the turn, and B is the track width.
  const double slant = std::sqrt(1.0 + p.wheelbase_m * p.wheelbase_m / (p.track_m * p.track_m));
  const double moment = p.grip * p.mass_kg * kGravity * 0.5 * p.wheelbase_m / slant;
  const double share = moment / p.track_m * w.radius_m / (w.stall_torque * p.supply_volts / w.nominal_volts);
  for (const double more : {0.97, 1.03}) {
    Body& body = make(p);
    drive(body, -share * more, share * more);
    run(1.0);
    if (more < 1.0)
      EXPECT_EQ(body.turn_rate(), 0.0);
    else
      EXPECT_GT(body.turn_rate(), 0.01);
  }
}

TEST_F(SkidTest, AFanPressesItDown) {
  BodyParams p = default_body_params();
  p.load_share = 1.0;
  p.rolling_resistance = 0.0;
  for (const double force : {0.0, 5.0}) {
    p.downforce_n = force;
    Body& body = make(p);
    drive(body, 1.0, 1.0);
    run(4.0);
    const double speed = body.speed(), from = body.distance();
    body.block(left, true);
    body.block(right, true);
    run(3.0);
    const double drag = p.grip * (kGravity + force / p.mass_kg);
    // Each tick moves the body at the speed that the body had when the tick began. So the distance is half a
    // tick of full speed longer than the closed form.
    const double expected = speed * speed / (2.0 * drag) + 0.5 * speed * 0.001;
    EXPECT_NEAR(body.distance() - from, expected, kTwoPercent * expected) << force;
  }
}

}  // namespace robosim::world::skid_test
