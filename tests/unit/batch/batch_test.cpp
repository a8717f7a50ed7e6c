// Compares a batch of robots with single robots. Equal commands must give bit-identical runs.
#include "sim/robot/batch/robots.h"

#include <gtest/gtest.h>

#include <cstring>
#include <random>

#include "sim/base/error.h"
#include "sim/robot/describe.h"
#include "sim/robot/parts/motor_driver.h"
#include "sim/robot/robot.h"
#include "tests/unit/robot/fake_board.h"

namespace robosim::batch {
namespace batch_test {

using world::left;
using world::right;

class Chance {
 public:
  explicit Chance(unsigned seed) : engine_(seed) {}
  double within(double low, double high) { return low + (high - low) * (engine_() / 4294967295.0); }
  unsigned below(unsigned n) { return static_cast<unsigned>(engine_() % n); }
  bool once_in(unsigned n) { return below(n) == 0; }

 private:
  std::mt19937 engine_;
};

bool same(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

// Returns the stock robot uno5 with random parameters.
robot::Description some_uno5(Chance& chance) {
  robot::Description robot = robot::load_description("uno5");
  const auto vary = [&](Parameter& number) { number = number.scaled(chance.within(0.7, 1.4)); };
  for (Parameter* number : {&robot.chassis.mass, &robot.chassis.track, &robot.chassis.wheel,
                            &robot.chassis.grip, &robot.chassis.rolling, &robot.motors.no_load,
                            &robot.motors.stall_torque, &robot.motors.supply, &robot.motors.rotor_inertia})
    vary(*number);
  if (chance.once_in(4)) robot.chassis.grip = {0.15, 0.0};  // the robot skids and slips
  if (chance.once_in(6)) robot.chassis.height = {0.03, 0.0};
  if (chance.once_in(6)) robot.motors.inductance = {1.5e-3, 0.0};
  if (chance.once_in(3)) robot.electronics = {{1.0, 0.0}, chance.once_in(2)};
  if (chance.once_in(3)) robot.chassis.polygon.clear(), robot.chassis.circle_radius = 0.06;
  return robot;
}

// A robot::Robot that is alone in a world.
struct Single {
  Single(const robot::Description& robot_, const map::Map& map, std::uint64_t seed, Profile profile,
         const Pose& start, std::uint32_t number)
      : description(robot_),
        world(map),
        body(world.body(world.add_body(robot::body_params(robot_, seed, profile, number), start))),
        board(*robot_.board),
        robot(robot_, world, 0, board, seed, profile, number) {
    world.vary_floor(NoiseStream(7, 0, "floor", "test"), profile == Profile::ideal ? 0.0 : 0.05);
  }

  // Drives one wheel with the duty cycle `share`, from -1 (backward) to 1. A `share` of 2 brakes the wheel.
  // Returns the command that the motor driver gives to the wheel.
  world::WheelCommand drive(world::Side side, double share, SimTime t) {
    const Pin en = side == left ? 5 : 6;
    const Pin in1 = side == left ? 7 : 9, in2 = side == left ? 8 : 10;
    const bool brakes = share > 1.0;
    board.output(in1, brakes || share > 0.0, t);
    board.output(in2, brakes || share < 0.0, t);
    if (brakes)
      board.output(en, true, t);
    else
      board.pwm(en, std::fabs(share), t);
    const robot::BridgeInputs inputs{
        brakes ? 1.0 : std::fabs(share), brakes || share > 0.0 ? 1.0 : 0.0, brakes || share < 0.0 ? 1.0 : 0.0,
        false, description.motors.inductance.value > 0.0 ? robot::period_of(board.drive(en)) : 0.0};
    return robot::bridge_command(*description.driver.chip, inputs);
  }

  const robot::Description& description;
  world::World world;
  world::Body& body;
  robot::FakeBoard board;
  robot::Robot robot;
};

void expect_same(const world::Body& a, const world::Body& b) {
  EXPECT_TRUE(same(a.pose().position.x, b.pose().position.x));
  EXPECT_TRUE(same(a.pose().position.y, b.pose().position.y));
  EXPECT_TRUE(same(a.pose().heading.x, b.pose().heading.x));
  EXPECT_TRUE(same(a.pose().heading.y, b.pose().heading.y));
  EXPECT_EQ(a.speed(), b.speed());
  EXPECT_EQ(a.side_speed(), b.side_speed());
  EXPECT_EQ(a.turn_rate(), b.turn_rate());
  for (const world::Side side : {left, right}) {
    EXPECT_EQ(a.wheel_angle(side), b.wheel_angle(side));
    EXPECT_EQ(a.wheel_rate(side), b.wheel_rate(side));
  }
  EXPECT_EQ(a.distance(), b.distance());
  EXPECT_EQ(a.wheel_travel(), b.wheel_travel());
  EXPECT_EQ(a.energy(), b.energy());
  EXPECT_EQ(a.energy_back(), b.energy_back());
  EXPECT_EQ(a.slips(), b.slips());
  EXPECT_EQ(a.collisions(), b.collisions());
  EXPECT_EQ(a.in_contact(), b.in_contact());
}

struct Counts {
  int slips = 0, skids = 0, contacts = 0, rests = 0;
};

// Runs `robots` robots with random parameters and commands on a map, for a second. Runs them as a batch and
// one by one. Expects equal sensor voltages, and every 50 ticks an equal state of each robot.
void compare(const std::string& name, unsigned seed, std::size_t robots, Counts& counts) {
  SCOPED_TRACE(name + ", seed " + std::to_string(seed));
  Chance chance(seed);
  const Profile profile = chance.once_in(3)   ? Profile::ideal
                          : chance.once_in(2) ? Profile::typical
                                              : Profile::typical_2;
  const map::Map map = map::read_map(map::find_map(name));
  world::World world(map);
  world.vary_floor(NoiseStream(7, 0, "floor", "test"), profile == Profile::ideal ? 0.0 : 0.05);
  std::vector<robot::Description> descriptions;
  for (std::size_t i = 0; i < robots; ++i) descriptions.push_back(some_uno5(chance));
  Robots batch(world);
  std::vector<std::unique_ptr<Single>> singles;
  for (std::size_t i = 0; i < robots; ++i) {
    const double angle = chance.within(0.0, 6.28);
    const Pose start{
        {chance.within(0.1, map.width * map.cell_m - 0.1), chance.within(0.1, map.height * map.cell_m - 0.1)},
        {std::cos(angle), std::sin(angle)}};
    const auto number = static_cast<std::uint32_t>(i);
    ASSERT_EQ(batch.add(descriptions[i], seed, profile, start, number), i);
    singles.push_back(std::make_unique<Single>(descriptions[i], map, seed, profile, start, number));
  }
  std::vector<double> volts(robots);
  for (int tick = 0; tick < 1000; ++tick) {
    const SimTime now = batch.now();
    for (std::size_t i = 0; i < robots; ++i) {
      Single& single = *singles[i];
      single.robot.begin_tick(now);
      for (const world::Side side : {left, right}) {
        if (tick > 0 && !chance.once_in(150)) continue;
        const double share = chance.once_in(8) ? 0.0 : chance.once_in(8) ? 2.0 : chance.within(-1.0, 1.0);
        batch.tell(i, side, single.drive(side, share, now));
      }
    }
    for (unsigned looks = chance.once_in(3) ? 5 : 0; looks > 0; --looks) {
      const unsigned sensor = chance.below(5);
      const SimTime at = now + chance.below(2) * chance.below(1000000);
      batch.read(sensor, at, volts);
      for (std::size_t i = 0; i < robots; ++i) {
        const double single = singles[i]->board.read_volts(static_cast<Pin>(14 + sensor), at);
        ASSERT_TRUE(same(volts[i], single))
            << "robot " << i << ", tick " << tick << ": " << volts[i] << " V, alone " << single << " V";
      }
    }
    batch.step();
    for (std::size_t i = 0; i < robots; ++i) {
      Single& single = *singles[i];
      single.robot.end_tick(now + kTick);
      single.world.step();
      counts.slips += single.body.slips();
      counts.skids += single.body.side_speed() != 0.0;
      counts.contacts += single.body.in_contact();
      counts.rests += single.body.is_still();
      if (tick % 50 == static_cast<int>(i)) expect_same(batch.bodies().body(i), single.body);
    }
    if (::testing::Test::HasFailure()) FAIL() << "in tick " << tick;
  }
}

TEST(Batch, DoesToTheLastBitWhatSingleRobotsDo) {
  Counts counts;
  unsigned seed = 1;
  for (const char* map : {"oval", "tight", "figure8", "city", "d", "dashed"}) {
    compare(map, seed, 9, counts);
    compare(map, seed + 1, 3, counts);
    seed += 2;
    if (HasFailure()) return;
  }
  EXPECT_GT(counts.slips, 1000);
  EXPECT_GT(counts.skids, 100);
  EXPECT_GT(counts.contacts, 100);
  EXPECT_GT(counts.rests, 100);
}

std::string refused(robot::Description robot, const std::string& map_name = "oval") {
  const map::Map map = map::read_map(map::find_map(map_name));
  const world::World world(map);
  Robots batch(world);
  try {
    batch.add(robot::load_description("uno5"), 1, Profile::ideal, {{1.2, 0.6}, {1.0, 0.0}});
    batch.add(robot, 1, Profile::ideal, {{1.2, 0.6}, {1.0, 0.0}});
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Batch, SaysWhatItCannotHold) {
  const auto with = [](const std::string& more) {
    return robot::parse_description("base = \"uno5\"\nboard = \"mega\"\n" + more, "mine.toml");
  };
  EXPECT_EQ(refused(with("")), "");
  EXPECT_EQ(refused(with("[battery]\nkind = \"nimh\"\ncells = 6\ncapacity_mAh = 2000\n")),
            "mine.toml: [battery] is not supported in a batch of robots");
  EXPECT_EQ(refused(with("[[part]]\nname = \"D\"\ntype = \"reflectance\"\nread = \"digital\"\npin = 22\nat = "
                         "[\"10 mm\", \"0 mm\"]\n")),
            "mine.toml: D, a sensor whose \"read\" is not \"analog\", is not supported in a batch of robots");
  EXPECT_EQ(refused(with("[[part]]\nname = \"E\"\ntype = \"reflectance\"\npin = \"A9\"\nat = [\"10 mm\", \"0 "
                         "mm\"]\n")),
            "mine.toml: has 6 reflectance sensors, and the first robot of its batch has 5");
}

TEST(Batch, NeedsAPlaneFloor) {
  const map::Map map = map::parse_map(
      "+++\n[[surface]]\nat = [\"0 mm\", \"0 mm\"]\nsize = [\"50 mm\", \"50 mm\"]\ngrip = "
      "0.5\n+++\n___\n___\n",
      "hills.map");
  const world::World world(map);
  EXPECT_THROW(Bodies{world}, std::invalid_argument);
}

}  // namespace batch_test
}  // namespace robosim::batch
