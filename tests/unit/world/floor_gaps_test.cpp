// Tests gaps between floor boards. Compares the depth to which a wheel sinks, and the loss of energy, with
// the closed forms of floor_gaps.h.
#include "sim/world/floor_gaps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "maps.h"
#include "sim/world/world.h"

namespace robosim::world::floor_gaps_test {

constexpr double kFall = 9.80665;  // in m/s^2

map::Joint joint(double x, double gap, Vec2 heading = {1.0, 0.0}) {
  map::Joint joint;
  joint.middle = {{x, 10.0}, heading};
  joint.half_length = 0.5 * gap;
  joint.half_width = 2.0;
  return joint;
}

class JointsTest : public testing::Test {
 protected:
  JointsTest() {
    for (WheelParams& wheel : params_.wheel) wheel.no_load_current = 0.0;
    params_.rolling_resistance = params_.driver_drop_volts = params_.driver_ohms = 0.0;
    params_.grip = 3.0;
  }
  Body& make(const Pose& pose) {
    world_ = std::make_unique<World>(map_);
    return world_->body(world_->add_body(params_, pose));
  }
  void drive(Body& body, double share) {
    const double brake = share > 0.0 ? 1.0 - share : 0.0;
    body.command(left, {share, brake});
    body.command(right, {share, brake});
  }
  void run(int ticks) {
    for (int i = 0; i < ticks; ++i) world_->step();
  }
  /// Returns the share of the kinetic energy that a robot loses at `gaps` gaps, which are 100 mm apart. The
  /// robot coasts, initially at `speed`.
  double lost(double gap, double speed, int gaps) {
    const double share = speed / top_speed();
    for (int i = 0; i < gaps; ++i) map_.course.joints.push_back(joint(12.0 + 0.1 * i, gap));
    Body& body = make({{5.0, 10.0}, {1.0, 0.0}});
    drive(body, share);
    for (int i = 0; i < 60000 && body.pose().position.x < 11.5; ++i) run(1);
    drive(body, 0.0);
    const double before = body.speed();
    EXPECT_NEAR(before, speed, 0.01 * speed);
    for (int i = 0; i < 60000 && body.pose().position.x < 12.2 + 0.1 * gaps; ++i) run(1);
    return 1.0 - body.speed() * body.speed() / (before * before);
  }
  double top_speed() {
    map_.course.joints.clear();
    Body& body = make({{2.0, 10.0}, {1.0, 0.0}});
    drive(body, 1.0);
    run(3000);
    return body.speed();
  }
  /// Returns the result of lost() according to the closed form. At an impact, rotating masses keep their
  /// speed, and then return a part of this speed to the robot.
  double expected(double gap, double speed, int gaps) const {
    const WheelParams& w = params_.wheel[left];
    const double turns = 2.0 * (w.wheel_inertia_kgm2 + w.rotor_inertia_kgm2 * w.gear_ratio * w.gear_ratio) /
                         (w.radius_m * w.radius_m);
    const double m = params_.mass_kg;
    double v = speed;
    for (int i = 0; i < gaps; ++i)
      for (const auto& [share, r] : {std::pair{params_.load_share, w.radius_m},
                                     std::pair{1.0 - params_.load_share, params_.caster_radius_m}}) {
        // The wheel falls into the gap, hits the far edge, and climbs out.
        const double limit = std::sqrt(kFall * r), sine = 0.5 * gap / r, fast = std::max(v / limit, 1.0);
        const double fallen = 2.0 * kFall * r * (1.0 - std::sqrt(1.0 - sine * sine)) * 4.0 /
                              ((1.0 + fast) * (1.0 + fast)) * share * m / (m + turns);
        v = std::sqrt(v * v + fallen);
        const double met = std::sin(2.0 * std::asin(sine)) * std::min(v, limit);
        v = (m * std::sqrt(v * v - share * met * met) + turns * v) / (m + turns);
        v = std::sqrt(v * v - fallen);
      }
    return 1.0 - v * v / (speed * speed);
  }

  map::Map map_ = empty_map(200, 200);
  BodyParams params_ = default_body_params();
  std::unique_ptr<World> world_;
};

TEST_F(JointsTest, SinkAWheelByTheClosedForm) {
  for (const double gap : {0.001, 0.003, 0.005, 0.006})
    for (const double r : {0.010, 0.016, 0.035}) {
      map::Course course;
      course.joints = {joint(10.0, gap)};
      const FloorGaps joints(course);
      const FloorGaps::Roller wheel{r, {1.0, 0.0}, 0.1};
      EXPECT_NEAR(joints.sunk({10.0, 10.0}, wheel).depth, r - std::sqrt(r * r - 0.25 * gap * gap), 1e-12);
      EXPECT_NEAR(joints.sunk({10.0, 10.0}, {r, {}, 0.1}).depth, r - std::sqrt(r * r - 0.25 * gap * gap),
                  1e-12);
      EXPECT_EQ(joints.sunk({10.0 + 0.501 * gap, 10.0}, wheel).depth, 0.0);
      EXPECT_EQ(joints.sunk({10.0, 12.1}, wheel).depth, 0.0) << "past the gap's end";
      // Towards the middle of the gap, the wheel sinks along a circle around the gap's edge.
      const double away = 0.3 * gap, slope = away / std::sqrt(r * r - away * away);
      EXPECT_NEAR(joints.sunk({10.0 - 0.2 * gap, 10.0}, wheel).rise.x, -slope, 1e-12);
      EXPECT_NEAR(joints.sunk({10.0 + 0.2 * gap, 10.0}, wheel).rise.x, slope, 1e-12);
      const double v = 3.0 * std::sqrt(kFall * r);
      EXPECT_NEAR(joints.sunk({10.0, 10.0}, {r, {1.0, 0.0}, v}).depth,
                  0.25 * joints.sunk({10.0, 10.0}, wheel).depth, 1e-12)
          << "a fast wheel flies over the gap";
    }
}

TEST_F(JointsTest, ABallSinksDeeperTheObliquerAWheelTheLess) {
  map::Course course;
  course.joints = {joint(10.0, 0.005)};
  const FloorGaps joints(course);
  const auto depth = [&](double degrees) {
    const double a = degrees * 0.017453292519943295;
    return joints.sunk({10.0, 10.0}, {0.016, {std::cos(a), std::sin(a)}, 0.1}).depth;
  };
  const double a = 0.0025 - 0.003 * 0.5, reach = 0.016 * std::sqrt(0.75);
  EXPECT_NEAR(depth(30.0), 0.016 * (1.0 - std::sqrt(1.0 - a * a / (reach * reach))), 1e-12);
  EXPECT_EQ(depth(60.0), 0.0) << "the wheel's tread is wider than the gap";
  EXPECT_EQ(depth(90.0), 0.0);
  EXPECT_NEAR(joints.sunk({10.0, 10.0}, {0.002, {}, 0.1}).depth, 0.002 * (1.0 - std::sqrt(1.0 - 0.98 * 0.98)),
              1e-12)
      << "the ball falls through";
}

TEST_F(JointsTest, CostWhatTheImpactOnTheFarEdgeDoes) {
  for (const double gap : {0.002, 0.004, 0.006})
    for (const double speed : {0.15, 0.3, 0.6}) {
      const double by_form = expected(gap, speed, 3);
      EXPECT_NEAR(lost(gap, speed, 3), by_form, 0.02 * by_form) << gap << ' ' << speed;
    }
}

TEST_F(JointsTest, HoldAWheelThatHasNotThePowerToClimbOut) {
  map_.course.joints = {joint(10.0, 0.005)};
  // Both wheels are in the middle of the gap. The motors' force is `share` times the load on the wheels.
  const auto leaves = [&](double share) {
    Body& body = make({{10.0, 10.0}, {1.0, 0.0}});
    const WheelParams& w = params_.wheel[left];
    drive(body, share * params_.mass_kg * kFall * params_.load_share * w.radius_m /
                    (2.0 * w.stall_torque * params_.supply_volts / w.nominal_volts));
    run(3000);
    return body.pose().position.x > 10.01;
  };
  const double r = params_.wheel[left].radius_m, slope = 0.0025 / std::sqrt(r * r - 0.0025 * 0.0025);
  EXPECT_FALSE(leaves(0.95 * slope));
  EXPECT_TRUE(leaves(1.05 * slope));
}

TEST_F(JointsTest, LowerTheChassisAndLeaveOtherRobotsAlone) {
  map_.course.joints = {joint(10.0, 0.006)};
  Body& body = make({{10.0, 10.0}, {1.0, 0.0}});
  run(1);
  const double r = params_.wheel[left].radius_m, h = r - std::sqrt(r * r - 0.003 * 0.003);
  EXPECT_NEAR(body.raised({0.0, 0.0}), -h, 1e-6);
  EXPECT_NEAR(body.raised({params_.caster_m, 0.0}), 0.0, 1e-6);
  map_.course.joints.clear();
  EXPECT_EQ(World(map_).ground(), nullptr);
}

TEST_F(JointsTest, AreDarkForASensorThatLooksIn) {
  map_.course.joints = {joint(10.0, 0.003)};
  const World world(map_);
  EXPECT_NEAR(world.floor().darkness({10.0, 10.0}, 0.006), 0.5, 1e-9);
  EXPECT_NEAR(world.floor().darkness({10.0, 10.0}, 0.002), 1.0, 1e-9);
  EXPECT_EQ(world.floor().darkness({10.01, 10.0}, 0.006), 0.0);
}

}  // namespace robosim::world::floor_gaps_test
