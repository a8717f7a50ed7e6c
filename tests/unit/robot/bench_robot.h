// Provides a robot on a straight line for tests of parts. The tests act as the board's firmware.
#pragma once

#include <string>

#include "sim/robot/describe.h"
#include "sim/robot/description.h"
#include "sim/robot/robot.h"
#include "sim/world/world.h"
#include "tests/unit/robot/fake_board.h"

namespace robosim::robot {

inline constexpr Pin kA0 = 14, kA1 = 15;  ///< pins of the robot's Nano

/// A small robot file without parts, to which tests append their parts.
inline const std::string kBareRobot = R"(
board = "nano"
[chassis]
outline = { radius = "60 mm" }
mass = "300 g"
track = "100 mm"
wheel = "32 mm"
[motors]
voltage = "6 V"
no_load = "625 rpm"
stall_torque = "15 oz in"
stall_current = "1.6 A"
supply = "6 V"
[driver]
chip = "tb6612"
)";

/// A robot on a map with one line, which runs east through the point line(). The line is 20 mm wide, unless
/// the map's front matter sets another width.
class BenchRobot {
 public:
  explicit BenchRobot(const std::string& parts, Profile profile = Profile::ideal, std::uint64_t seed = 1)
      : BenchRobot(parse_description(kBareRobot + parts, "bench.toml"), profile, seed) {}
  explicit BenchRobot(Description d, Profile profile = Profile::ideal, std::uint64_t seed = 1,
                      const std::string& front_matter = "")
      : description(std::move(d)),
        map(map::parse_map(front_matter + "___________\n___________\n_111111111_\n___________\n___________\n",
                           "bench.map")),
        world(map),
        number(world.add_body(body_params(description, seed, profile), {line(), {1.0, 0.0}})),
        board(*description.board),
        robot(description, world, number, board, seed, profile) {
    robot.begin_tick(0);
  }

  /// Returns a point in the middle of the line.
  Vec2 line() const { return map.centre({4, 2}); }
  world::Body& body() { return world.body(number); }
  /// Ends the current tick, and begins the next one.
  void tick() {
    robot.end_tick(now + kTick);
    world.step();
    now += kTick;
    robot.begin_tick(now);
  }
  void ticks(int count) {
    for (int i = 0; i < count; ++i) tick();
  }
  double volts(Pin pin) { return board.read_volts(pin, now); }
  bool level(Pin pin) { return board.read_level(pin, now); }

  Description description;
  map::Map map;
  world::World world;
  std::size_t number;
  FakeBoard board;
  Robot robot;
  SimTime now = 0;
};

/// Returns the text of a reflectance sensor "eye" on A0, at the axle's centre. The text ends with `keys`.
inline std::string reflectance_sensor(const std::string& keys) {
  return "[[part]]\nname = \"eye\"\ntype = \"reflectance\"\npin = \"A0\"\nat = [\"0 mm\", \"0 mm\"]\n"
         "footprint = \"6 mm\"\n" +
         keys;
}

/// Places the robot parallel to the line. The axle's centre is `metres` from the line's middle.
inline void place_beside_line(BenchRobot& bench, double metres) {
  bench.body().place({bench.line() + Vec2{0.0, metres}, {1.0, 0.0}});
}

}  // namespace robosim::robot
