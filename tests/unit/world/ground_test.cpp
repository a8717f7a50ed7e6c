// Compares bodies on hills and surfaces with closed forms, within 2 %. The formulas are from ground.h,
// body_ground.cpp and physics textbooks.
#include "sim/world/ground.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <numbers>

#include "one_body.h"

namespace robosim::world::ground_test {

constexpr double kG = 9.80665;
constexpr double kWithin = 0.02;

map::Hill hill(Vec2 middle, double length, double width, std::vector<double> heights,
               Vec2 heading = {1.0, 0.0}) {
  map::Hill hill;
  hill.middle = {middle, heading};
  hill.half_length = 0.5 * length;
  hill.half_width = 0.5 * width;
  hill.heights = std::move(heights);
  return hill;
}

map::Hill seesaw(Vec2 middle, double length, double pivot, double plank_kg) {
  map::Hill plank = hill(middle, length, 0.3, {});
  plank.pivot = pivot;
  plank.plank_kg = plank_kg;
  return plank;
}

// Returns parameters of a body without friction, to which some tests add friction.
BodyParams free_body() {
  BodyParams p = default_body_params();
  for (WheelParams& wheel : p.wheel) wheel.no_load_current = 0.0;
  p.rolling_resistance = 0.0;
  p.driver_drop_volts = p.driver_ohms = 0.0;
  return p;
}

class GroundTest : public OneBodyTest {
 protected:
  GroundTest() : OneBodyTest(200) {}
  /// Puts a body in the middle of an even slope. `sine` is the sine of the slope's angle. By default, the
  /// body faces uphill.
  Body& on_slope(double sine, const BodyParams& params, Vec2 heading = {1.0, 0.0}) {
    map_.course.hills = {hill({10.0, 10.0}, 10.0, 10.0, {0.0, 10.0 * sine})};
    return make(params, {{10.0, 10.0}, heading});
  }
  /// Returns the smallest sine from 0 to 0.9 for which `happens` is true.
  static double least_sine(const std::function<bool(double)>& happens) {
    double low = 0.0, high = 0.9;
    while (high - low > 1e-4) {
      const double middle = 0.5 * (low + high);
      (happens(middle) ? high : low) = middle;
    }
    return high;
  }
  static double slope_of(double sine) { return sine / std::sqrt(1.0 - sine * sine); }
};

double inertia_mass(const BodyParams& p) {
  const WheelParams& w = p.wheel[left];
  return p.mass_kg + 2.0 * (w.wheel_inertia_kgm2 + w.rotor_inertia_kgm2 * w.gear_ratio * w.gear_ratio) /
                         (w.radius_m * w.radius_m);
}

TEST_F(GroundTest, WithoutPowerItRollsBackByTheSine) {
  const BodyParams p = free_body();
  Body& body = on_slope(0.3, p);
  run(0.5);
  const double expected = -p.mass_kg * kG * 0.3 * 0.5 / inertia_mass(p);
  EXPECT_NEAR(body.speed(), expected, kWithin * -expected);
  EXPECT_NEAR(body.pose().position.x - 10.0, 0.25 * expected, kWithin * -expected * 0.25);
  EXPECT_LT(body.wheel_rate(left), 0.0) << "the wheels turn with the body";
}

TEST_F(GroundTest, StallsWhereItsMotorsTorqueEnds) {
  BodyParams p = default_body_params();
  p.grip = 3.0;
  const WheelParams& w = p.wheel[left];
  const double ohms = w.nominal_volts / w.stall_current + p.driver_ohms;
  const double per_ampere = w.stall_torque / (w.stall_current - w.no_load_current);
  const double share = 0.6;
  const double torque = share * (p.supply_volts - p.driver_drop_volts) / ohms * per_ampere -
                        w.static_friction * per_ampere * w.no_load_current;
  const auto stalls = [&](double sine) {
    Body& body = on_slope(sine, p);
    drive(body, share);
    run(0.3);
    return body.pose().position.x < 10.0001;
  };
  // Rolling resistance also holds the body, with the force 0.02 m g cos(slope).
  const double force = 2.0 * torque / w.radius_m / (p.mass_kg * kG);
  const double sine = least_sine(stalls);
  const double cosine = std::sqrt(1.0 - sine * sine);
  EXPECT_NEAR(sine, force - p.rolling_resistance * cosine, kWithin * sine);
}

TEST_F(GroundTest, SlidesWhereTheTangentIsTheGripOnItsShareOfTheLoad) {
  BodyParams p = default_body_params();
  p.grip = 0.6;
  const auto slides = [&](double sine) {
    Body& body = on_slope(sine, p);
    body.block(left, true);
    body.block(right, true);
    run(0.5);
    return body.distance() > 1e-4;
  };
  const double tangent = slope_of(least_sine(slides));
  EXPECT_NEAR(tangent, p.grip * p.load_share, kWithin * tangent);
}

TEST_F(GroundTest, SlidesSidewaysThere) {
  BodyParams p = default_body_params();
  p.grip = 0.5;
  p.load_share = 1.0;
  const auto slides = [&](double sine) {
    Body& body = on_slope(sine, p, {0.0, 1.0});
    run(0.5);
    return body.pose().position.x < 9.9999;
  };
  // Forces along and across the body share the grip. While the body skids, 1 / sqrt(2) of the grip acts
  // across it (body.h).
  const double tangent = slope_of(least_sine(slides));
  EXPECT_NEAR(tangent, p.grip * std::numbers::sqrt2 / 2.0, kWithin * tangent);
}

TEST_F(GroundTest, TipsWhereTheTangentIsTheMassesDistanceOverItsHeight) {
  BodyParams p = default_body_params();
  p.caster_m = 0.06;
  p.load_share = 0.75;
  p.centre_height_m = 0.04;
  p.grip = 3.0;
  const auto tips = [&](double sine) {
    Body& body = on_slope(sine, p);
    body.block(left, true);
    body.block(right, true);
    run(3.0);
    return body.toppled() == Toppled::over;
  };
  const double tangent = slope_of(least_sine(tips));
  EXPECT_NEAR(tangent, 0.25 * 0.06 / 0.04, kWithin * tangent);
}

TEST_F(GroundTest, LoadsShiftToTheRearAsItSpeedsUp) {
  BodyParams p = default_body_params();
  p.grip = 0.3;
  p.caster_m = 0.06;
  p.centre_height_m = 0.03;
  p.load_share = 0.7;
  for (WheelParams& wheel : p.wheel) wheel.stall_torque *= 5.0;
  Body& body = make(p);
  drive(body, 1.0);
  run(0.05);
  const double before = body.speed();
  run(0.1);
  EXPECT_TRUE(body.slips());
  // The formulas are N = load_share m g + m a h / c, and m a = grip N. N is the load on the wheels, and a the
  // acceleration. The centre of mass is at height h, and the caster at distance c.
  const double expected = p.grip * p.load_share * kG / (1.0 - p.grip * 0.03 / 0.06);
  EXPECT_NEAR((body.speed() - before) / 0.1, expected, kWithin * expected);
}

// A robot trips only if its centre of mass is above the hubs. This also holds if the centre of mass is close
// to the axle.
TEST_F(GroundTest, TripsOverAStepOnlyWhereItsMassIsAboveItsHubs) {
  BodyParams p = default_body_params();
  p.caster_m = -0.06;
  p.load_share = 0.95;
  p.grip = 1.5;
  map_.course.hills = {hill({11.5, 10.0}, 1.0, 2.0, {0.01, 0.01})};
  const auto trips = [&](double height) {
    p.centre_height_m = height;
    Body& body = make(p, {{10.6, 10.0}, {1.0, 0.0}});
    for (int i = 0; i < 2500; ++i) {
      drive(body, std::min(0.002 * i, 0.5));
      world_->step();
    }
    EXPECT_GT(body.pose().position.x, 11.0) << height;
    return body.toppled() == Toppled::over;
  };
  EXPECT_FALSE(trips(0.02));
  EXPECT_FALSE(trips(p.wheel[left].radius_m));
  EXPECT_TRUE(trips(0.2));
}

TEST_F(GroundTest, ATooStrongMotorLiftsItsCasterAndThrowsItOver) {
  BodyParams p = default_body_params();
  p.grip = 1.5;
  p.caster_m = 0.04;
  p.centre_height_m = 0.06;
  for (WheelParams& wheel : p.wheel) wheel.stall_torque *= 20.0;
  Body& body = make(p);
  drive(body, 1.0);
  run(1.0);
  EXPECT_EQ(body.toppled(), Toppled::over);
  const Pose lies = body.pose();
  run(1.0);
  EXPECT_EQ(body.pose().position, lies.position);
  EXPECT_GT(body.wheel_rate(left), 1.0) << "the wheel turns in the air";
  body.place({{10.0, 10.0}, {1.0, 0.0}});
  EXPECT_EQ(body.toppled(), Toppled::no);
}

TEST_F(GroundTest, StopsOnAGivenGripInTheWayOfTheBooks) {
  BodyParams p = free_body();
  p.load_share = 1.0;
  for (const double factor : {1.0, 0.5}) {
    map::Surface wet;
    wet.middle = {{10.0, 10.0}, {1.0, 0.0}};
    wet.half_length = wet.half_width = 20.0;
    wet.grip = factor;
    map_.course.surfaces = {wet};
    Body& body = make(p);
    drive(body, 0.8);
    run(5.0);
    const double speed = body.speed(), from = body.distance();
    body.block(left, true);
    body.block(right, true);
    run(3.0);
    const double expected = speed * speed / (2.0 * p.grip * factor * kG);
    EXPECT_NEAR(body.distance() - from, expected, kWithin * expected) << factor;
  }
}

// Rows of a map count from the top, but y in the world counts from the bottom. A [[surface]] takes precedence
// over a cell.
TEST_F(GroundTest, IsMadeOfWhatTheLegendSaysOfACell) {
  const map::Map map = map::parse_map(
      "+++\n[legend]\n4 = \"wet\"\n5 = { cell = \"line\", grip = 0.3, rolling = 0.02 }\n"
      "[[surface]]\nat = [\"250 mm\", \"50 mm\"]\nradius = \"20 mm\"\nkind = \"carpet\"\n+++\n"
      "4..\n___\n__5\n",
      "m.map");
  const Ground ground(map);
  EXPECT_FALSE(ground.plain());
  const auto at = [&](double x, double y) {
    const Ground::Kind kind = ground.kind({x, y});
    return std::pair{kind.grip, kind.rolling};
  };
  using P = std::pair<double, double>;
  EXPECT_EQ(at(0.05, 0.25), P(0.6, 0.0));
  EXPECT_EQ(at(0.0999, 0.2001), P(0.6, 0.0));
  EXPECT_EQ(at(0.1001, 0.25), P(1.0, 0.0));
  EXPECT_EQ(at(0.05, 0.1999), P(1.0, 0.0));
  EXPECT_EQ(at(0.05, 0.05), P(1.0, 0.0));
  EXPECT_EQ(at(0.21, 0.09), P(0.3, 0.02));
  EXPECT_EQ(at(0.25, 0.05), P(1.0, 0.05));
  for (const double out : {-0.01, 0.31, 1e12}) EXPECT_EQ(at(out, 0.05), P(1.0, 0.0));
  EXPECT_EQ(at(0.05, 0.31), P(1.0, 0.0));
}

// A legend's surfaces stop a robot with blocked wheels within v^2 / (2 mu g). mu is the grip.
TEST_F(GroundTest, StopsOnTheGripOfTheLegendInTheWayOfTheBooks) {
  BodyParams p = free_body();
  p.load_share = 1.0;
  map_.legend_surfaces = {{0.5, 0.0}};
  map_.surface_of_cell.assign(map_.cells.size(), 1);
  Body& body = make(p);
  drive(body, 0.8);
  run(5.0);
  const double speed = body.speed(), from = body.distance();
  body.block(left, true);
  body.block(right, true);
  run(3.0);
  const double expected = speed * speed / (2.0 * p.grip * 0.5 * kG);
  EXPECT_NEAR(body.distance() - from, expected, kWithin * expected);
}

TEST_F(GroundTest, RollsAsFarAsRollingResistanceLetsIt) {
  BodyParams p = free_body();
  p.rolling_resistance = 0.02;
  map::Surface carpet;
  carpet.middle = {{12.0, 10.0}, {1.0, 0.0}};
  carpet.half_length = carpet.half_width = 20.0;
  carpet.rolling = map::kSurfaces[2].rolling;
  for (const bool on_carpet : {false, true}) {
    map_.course.surfaces.clear();
    if (on_carpet) map_.course.surfaces = {carpet};
    Body& body = make(p);
    drive(body, 0.5);
    run(3.0);
    const double speed = body.speed(), from = body.distance();
    drive(body, 0.0);
    run(10.0);
    const double drag = (p.rolling_resistance + (on_carpet ? 0.05 : 0.0)) * p.mass_kg * kG;
    const double expected = 0.5 * inertia_mass(p) * speed * speed / drag;
    EXPECT_NEAR(body.distance() - from, expected, kWithin * expected) << on_carpet;
  }
}

TEST_F(GroundTest, ClimbsAStepOnlyAsFarAsItsGripGoes) {
  BodyParams p = free_body();
  p.load_share = 1.0;
  p.grip = 0.7;
  const double r = p.wheel[left].radius_m;
  for (WheelParams& wheel : p.wheel) wheel.stall_torque *= 5.0;
  const auto climbs = [&](double height) {
    map_.course.hills = {hill({12.0, 10.0}, 2.0, 2.0, {height, height})};
    const double met = std::sqrt(r * r - (r - height) * (r - height));
    Body& body = make(p, {{11.0 - met + 1e-5, 10.0}, {1.0, 0.0}});
    drive(body, 0.15);
    run(2.0);
    return body.pose().position.x > 11.01;
  };
  const double most = r * (1.0 - 1.0 / std::sqrt(1.0 + p.grip * p.grip));  // in m: 5.9 mm
  EXPECT_TRUE(climbs(0.003));
  EXPECT_TRUE(climbs(0.96 * most));
  EXPECT_FALSE(climbs(1.04 * most));
}

TEST_F(GroundTest, WhatIsHigherThanAWheelIsAWall) {
  BodyParams p = free_body();
  map_.course.hills = {hill({12.0, 10.0}, 2.0, 2.0, {0.04, 0.04})};
  Body& body = make(p, {{10.5, 10.0}, {1.0, 0.0}});
  drive(body, 1.0);
  run(3.0);
  EXPECT_LT(body.pose().position.x, 11.0);
  EXPECT_GT(body.pose().position.x, 10.9);
  EXPECT_EQ(body.collisions(), 1);
  drive(body, -1.0);
  run(1.0);
  EXPECT_LT(body.pose().position.x, 10.8);
}

TEST_F(GroundTest, FallsOffAnEdge) {
  map_.course.hills = {hill({10.0, 10.0}, 1.0, 0.4, {0.1, 0.1})};
  Body& body = make(free_body());
  drive(body, 0.5);
  run(3.0);
  EXPECT_EQ(body.toppled(), Toppled::off_an_edge);
}

TEST_F(GroundTest, ABumpTakesWhatMeetingItsSlopesCosts) {
  BodyParams p = free_body();
  p.load_share = 1.0;
  map_.course.hills = {hill({12.0, 10.0}, 0.06, 2.0, {0.0, 0.01, 0.0})};
  Body& body = make(p, {{11.0, 10.0}, {1.0, 0.0}});
  drive(body, 0.6);
  run(1.0);
  ASSERT_LT(body.pose().position.x, 11.9);
  drive(body, 0.0);
  const double speed = body.speed();
  double lean = 0.0;
  for (int i = 0; i < 1500; ++i) {
    world_->step();
    lean = std::max(lean, std::fabs(body.lean().low.x));
  }
  EXPECT_GT(body.pose().position.x, 12.2);
  const double cosine = 1.0 / std::sqrt(1.0 + 1.0 / 9.0), r = p.wheel[left].radius_m;
  // The robot loses speed at the foot of the bump, and where it lands after the bump. The wheels keep
  // rotating.
  const double own = p.mass_kg / inertia_mass(p);
  const double on_it = speed * (1.0 - own * (1.0 - cosine));
  const double landed = std::sqrt(1.0 - 2.0 * kG * r * (1.0 - cosine) / (on_it * on_it));
  const double expected = on_it * (1.0 - own * (1.0 - std::max(landed, cosine)));
  EXPECT_NEAR(body.speed(), expected, 0.005 * expected);
  EXPECT_NEAR(lean, 0.01 / 0.05, 0.02);
}

TEST_F(GroundTest, AcrossASlopeItsHeavyEndTurnsDownhill) {
  BodyParams p = free_body();
  p.load_share = 0.7;
  Body& body = on_slope(0.2, p, {0.0, 1.0});  // uphill is on the right, and the caster is at the rear
  run(0.5);
  EXPECT_LT(body.turn_rate(), 0.0);
}

TEST_F(GroundTest, ASeesawTipsOnceTheRobotIsPastItsPivot) {
  const BodyParams p = default_body_params();
  map_.course.hills = {seesaw({12.0, 10.0}, 0.6, 0.05, 0.6)};
  Body& body = make(p, {{11.5, 10.0}, {1.0, 0.0}});
  drive(body, 0.45);
  double tipped_at = 0.0, level_at = 0.0;
  for (int i = 0; i < 8000 && body.pose().position.x < 12.8; ++i) {
    world_->step();
    const double sine = world_->ground()->save().seesaws[0].sine;
    if (tipped_at == 0.0 && sine < 0.9 * 0.05 / 0.3) tipped_at = body.pose().position.x;
    if (level_at == 0.0 && sine <= -0.05 / 0.3) level_at = body.pose().position.x;
  }
  const double centre = tipped_at + (1.0 - p.load_share) * p.caster_m;
  EXPECT_GT(centre, 12.0);
  EXPECT_LT(centre, 12.08);
  EXPECT_GT(level_at, tipped_at);
  EXPECT_LT(level_at, 12.3);
  EXPECT_GE(body.pose().position.x, 12.8);
  EXPECT_EQ(body.toppled(), Toppled::no);
}

TEST_F(GroundTest, ASnapshotHoldsSeesaws) {
  map_.course.hills = {seesaw({12.0, 10.0}, 0.6, 0.05, 0.6)};
  Body& body = make(default_body_params(), {{11.99, 10.0}, {1.0, 0.0}});
  drive(body, 0.45);
  const World::State saved = world_->save();
  run(0.7);
  const double sine = world_->ground()->save().seesaws[0].sine;
  const Pose pose = body.pose();
  world_->restore(saved);
  EXPECT_NE(world_->ground()->save().seesaws[0].sine, sine);
  run(0.7);
  EXPECT_EQ(world_->ground()->save().seesaws[0].sine, sine);
  EXPECT_EQ(body.pose().position, pose.position);
}

TEST_F(GroundTest, NeverGainsMoreEnergyThanItDrawsAndFalls) {
  map_.course.hills = {hill({12.0, 10.0}, 2.0, 4.0, {0.0, 0.3, 0.3, 0.1, 0.0})};
  Body& body = make(default_body_params(), {{10.5, 10.0}, {1.0, 0.0}});
  const double weight = body.params().mass_kg * kG;
  const auto energy = [&] {
    const double caster = body.raised({body.params().caster_m, 0.0}), share = body.params().load_share;
    return body.kinetic_energy() + weight * (share * body.raised({}) + (1.0 - share) * caster) -
           body.energy();
  };
  world_->step();
  double least = energy();
  unsigned random = 5;
  for (int i = 0; i < 20000; ++i) {
    if (i % 400 == 0) {
      random = random * 1664525u + 1013904223u;
      body.command(left, {0.3 + static_cast<int>(random >> 8 & 255) / 400.0, 0.0});
      body.command(right, {0.3 + static_cast<int>(random >> 17 & 255) / 400.0, 0.0});
    }
    world_->step();
    if (body.toppled() != Toppled::no) break;
    // The model uses positions of a tick's end, but forces of its beginning. This causes an error of 1e-4 J,
    // while climbing the hill takes 1.5 J.
    ASSERT_LE(energy(), least + 2e-3) << i;
    least = std::min(least, energy());
  }
}

// Pins a sum over the positions and slopes of a run over hills and a seesaw. If the sum changes, the change
// must be announced.
TEST_F(GroundTest, TheBitsOfARunOverHillsArePinned) {
  map_.course.hills = {seesaw({10.8, 10.0}, 0.6, 0.05, 0.6), hill({11.4, 10.0}, 0.3, 1.0, {0.003, 0.003}),
                       hill({12.3, 10.0}, 1.0, 2.0, {0.0, 0.08, 0.08, 0.0}, {0.96, 0.28})};
  BodyParams p = default_body_params();
  p.centre_height_m = 0.02;
  Body& body = make(p, {{10.3, 10.0}, {1.0, 0.0}});
  double sum = 0.0;
  for (int i = 0; i < 8000; ++i) {
    drive(body, i % 900 < 700 ? 0.8 : 0.5);
    world_->step();
    sum += body.pose().position.x * (1 + i % 7) + body.lean().low.x;
  }
  EXPECT_GT(body.pose().position.x, 12.0);
  EXPECT_EQ(sum, 395756.95616502652);
}

}  // namespace robosim::world::ground_test
