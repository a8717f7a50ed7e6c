// Simulates many robots on one floor, without firmware. Each robot moves as if it were alone. The caller
// commands the motors and reads the line sensors. Typical uses are parameter studies, searches, and
// reinforcement learning.
//
//   map::Map map = map::read_map("oval.map");
//   world::World world(map);
//   batch::Robots robots(world);
//   for (std::uint64_t seed = 1; seed <= 1000; ++seed) robots.add(robot, seed, Profile::typical_2, start);
//   std::vector<double> volts(robots.size());
//   while (robots.now() < kSecond) {
//     robots.read(2, robots.now(), volts);          // the third sensor of each robot, now
//     robots.tell(17, world::left, {0.6, 0.4});     // a command, as a motor driver derives it from its pins
//     robots.step();
//   }
//
// A robot of a batch behaves like a robot::Robot with the same description, seed and number. With equal
// commands, both have the same poses and sensor voltages, including noise, bit for bit (tests/unit/batch). A
// batch takes less time, because its robots have no pins, and no parts except motors and line sensors. The
// arithmetic is done for a block of robots at once (bodies.h). Each robot's pose is computed once for all
// sensors that are read at the same time.
//
// Robots of a batch neither detect nor touch each other.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hal/board/sim_time.h"
#include "sim/base/noise.h"
#include "sim/base/profile.h"
#include "sim/robot/description.h"
#include "sim/world/batch/bodies.h"
#include "sim/world/floor_probe.h"

namespace robosim::batch {

/// One sensor of each robot of a block. For the values, see robot::ElementFigures and robot::AnalogInputs.
struct SensorBlock {
  Lanes at_x, at_y;  // m
  Lanes light, shift, noise, dark_noise;
  Lanes white, span, supply, adc_noise;  // V
  Lanes share;                           // supply / nominal supply
  Lanes lag;                             // ns
  world::FloorProbe probe[kLanes];
  NoiseStream stream[kLanes], adc[kLanes];
  std::uint64_t pin[kLanes] = {};
  std::uint64_t samples = 0;
  bool is_converted_noisily = false;
};

/// The poses of a block's robots when a sensor reads.
struct SensorPoses {
  Lanes x, y, heading_x, heading_y;
};

class Robots {
 public:
  /// Uses the world's floor, walls and obstacles, which may be changed between ticks. `world` must outlive
  /// this object. Throws std::invalid_argument if the map has hills, surfaces, gaps between boards, or lamps.
  explicit Robots(const world::World& world);

  /// Adds a robot and returns its number in the batch, from 0. `individual` is the number that a robot::Robot
  /// would have. The robot has the motors of its description, and reflectance sensors with `read = "analog"`
  /// whose emitters are on. Other parts are skipped.
  ///
  /// Throws InputError for parts that a batch does not support, because they change how the robot drives or
  /// reads: a [battery], steered wheels, a fan, other reflectance sensors, and an emitter on a pin. Also
  /// throws InputError if the robot has more or fewer sensors than the first robot.
  std::size_t add(const robot::Description&, std::uint64_t seed, Profile, const Pose& start,
                  std::uint32_t individual = 0);
  std::size_t size() const { return bodies_.size(); }
  std::size_t sensors() const { return sensors_; }

  /// Sets a motor's command, from the tick that begins now until the next call. The function
  /// robot::bridge_command() computes commands from a motor driver's pins.
  void tell(std::size_t robot, world::Side, const world::WheelCommand&);
  /// Reads one sensor of each robot, and writes the voltages (V) to `volts`. `sensor` is the index of the
  /// sensor in the order of the robot file, from 0. `t` is a time within the tick that begins now. Each call
  /// consumes one noise sample per robot.
  void read(std::size_t sensor, SimTime t, std::span<double> volts);
  /// Simulates one tick of all robots.
  void step();
  /// Returns the beginning of the tick that step() simulates next.
  SimTime now() const { return now_; }

  const Bodies& bodies() const { return bodies_; }

 private:
  struct Told {
    std::size_t robot;
    world::Side side;
    world::WheelCommand command;
  };

  void add_sensors(const robot::Description&, std::uint64_t seed, Profile, std::uint32_t individual);
  void find_poses(std::size_t sensor, SimTime t);

  const world::Floor& floor_;
  Bodies bodies_;
  std::size_t sensors_ = 0;
  std::vector<std::vector<SensorBlock>> sensor_blocks_;  // for each sensor, block by block
  std::vector<SensorPoses> poses_;
  SimTime posed_at_ = -1;   // the time of poses_
  std::vector<Told> told_;  // commands in this tick
  std::vector<world::WheelCommand> commands_[2];
  std::vector<bool> lags_;  // for each sensor: whether the sensor lags on any robot
  SimTime now_ = 0;
};

}  // namespace robosim::batch
