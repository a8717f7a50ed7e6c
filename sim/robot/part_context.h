// The context for making a robot's parts: their view of the world, and the individual values of this robot.
#pragma once

#include <cstddef>
#include <string_view>

#include "hal/board/robot_port.h"
#include "sim/base/noise.h"
#include "sim/base/parameter.h"
#include "sim/base/snapshot_registry.h"
#include "sim/robot/electronics.h"
#include "sim/robot/netlist.h"
#include "sim/robot/robot.h"
#include "sim/world/body.h"
#include "sim/world/floor.h"
#include "sim/world/world.h"

namespace robosim::robot {

/// Samples the parameters and the noise of one robot from (seed, number, part name). In the profile `ideal`,
/// every parameter has the file's value, and there is no noise.
class ParameterSampler {
 public:
  ParameterSampler(std::uint64_t seed, Profile profile, std::uint32_t number)
      : seed_(seed), number_(number), profile_(profile) {}

  Profile profile() const { return profile_; }
  bool ideal() const { return profile_ == Profile::ideal; }
  /// Returns this robot's value of the parameter `key` of `part` ("" = the robot itself).
  double draw(const Parameter& number, std::string_view part, std::string_view key) const {
    return ideal() ? number.value : number.drawn(profile_, NoiseStream(seed_, number_, part, key));
  }
  NoiseStream noise(std::string_view part, std::string_view purpose) const {
    return {seed_, number_, part, purpose};
  }

 private:
  std::uint64_t seed_;
  std::uint32_t number_;
  Profile profile_;
};

/// The state of the world in the current tick, for the robot's parts.
struct View {
  const world::Floor* floor = nullptr;
  const world::Body* body = nullptr;
  SimTime tick_start = 0;
  double battery = 1.0;  ///< battery voltage, relative to Robot::battery()
  Supply supply;         ///< the supply of the board
  const world::World* world = nullptr;
  std::size_t body_number = 0;  ///< number of `body` in `world`
  world::RadioChannel* radio = nullptr;

  /// Returns the pose at `t`, a time inside the current tick. The function is always inlined, so that the
  /// result stays in registers.
  [[gnu::always_inline]] Pose pose_at(SimTime t) const {
    const bool stands = body->speed() == 0.0 && body->side_speed() == 0.0 && body->turn_rate() == 0.0;
    return stands ? body->standing_pose() : body->pose_after(static_cast<double>(t - tick_start) * 1e-9);
  }
};

/// Everything that a part needs when it is made. Outlives the part.
class PartContext {
 public:
  PartContext(const Description& description_, RobotPort& board_, Netlist& netlist_, const View& view_,
              const ParameterSampler& sampler_, SnapshotRegistry& snapshots_, AnalogInputs* analog = nullptr)
      : description(description_),
        board(board_),
        netlist(netlist_),
        view(view_),
        sampler(sampler_),
        snapshots(snapshots_),
        analog_(analog) {}

  /// Connects a source that an ADC converts, like RobotPort::connect().
  void connect_analog(Pin pin, PinSource& source) {
    if (analog_)
      analog_->connect(pin, source);
    else
      board.connect(pin, source);
  }

  const Description& description;
  RobotPort& board;
  Netlist& netlist;  ///< shows a part how the firmware drives wires
  const View& view;
  const ParameterSampler& sampler;
  SnapshotRegistry& snapshots;  ///< a part adds its State, which is everything that changes during a run

 private:
  AnalogInputs* const analog_;  // null = the ADC adds no noise
};

}  // namespace robosim::robot
