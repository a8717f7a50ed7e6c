// A robot: parts, wired to a board's pins, on a body in the world.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hal/board/robot_port.h"
#include "sim/base/profile.h"
#include "sim/base/snapshot_registry.h"
#include "sim/base/vec.h"
#include "sim/robot/fault.h"
#include "sim/world/body.h"

namespace robosim::world {
class World;
}  // namespace robosim::world

namespace robosim::robot {

using robosim::Profile;

/// A robot file, read and checked (description.h).
struct Description;

/// Reads a robot file or a stock robot by name. Throws InputError.
Description load_description(const std::string& robot_name);

/// A level for display. It has no noise, and does not consume a sample of it.
struct Reading {
  std::string_view part;  ///< "S1" … for elements of an array, else the part's name; the robot keeps it
  double value;           ///< sensor: 0 white .. 1 black; LED, button: 0 or 1
};

/// A pin of the board and the part wired to it, so that a verdict can name it ("pin 2, the button start").
struct WiredPin {
  std::string part;  ///< "start"
  std::string type;  ///< "button", "motor", "reflectance-array" …
  std::string role;  ///< "in1", "pwm"; may be empty
  Pin pin = kNoPin;
};

/// A message of a script to a part: bits or a key's number to a remote control's receiver, text by Bluetooth.
struct Message {
  std::string text;
  SimTime held = 0;  ///< the duration for which a remote control's key is held
};

/// The output of a part: a line received by Bluetooth, the text of a display.
struct PartText {
  std::string part;
  std::string text;
};

class Robot {
 public:
  /// Makes a robot. `number` distinguishes robots in one world; all noise derives from (seed, number, part
  /// name). The description, the world and the board must outlive the robot. The body's parameters are
  /// body_params() of describe.h.
  Robot(const Description&, world::World&, std::size_t body, RobotPort&, std::uint64_t seed, Profile,
        std::uint32_t number = 0);
  ~Robot();
  Robot(const Robot&) = delete;
  Robot& operator=(const Robot&) = delete;

  /// Takes step (1) of a tick: parts schedule their edges from the state at `t`.
  void begin_tick(SimTime t);
  /// Takes step (3): motor commands become the time average of their pins over the tick that ends at `t`.
  /// Returns whether one has changed.
  bool end_tick(SimTime t);
  /// Returns whether both steps would do nothing in further ticks. Nothing may touch the body, firmware must
  /// not access the board, and no script may act. Then only begin_idle_tick() is needed.
  bool idles() const;
  void begin_idle_tick(SimTime t);

  /// Returns whether any reflectance sensor's footprint touches the line, without noise.
  bool sees_line() const;
  /// Returns the lateral position of those sensors whose footprints touch the line, to the left of the body's
  /// middle: their mean, weighted by the share of each on the line, m. 0 if there is none.
  double line_side() const;
  /// Returns whether it has any reflectance sensor.
  bool has_line_sensors() const;
  /// Returns the midpoint of the reflectance sensors in the body's frame, m, where the cross-track error is
  /// measured. (0, 0) without any.
  Vec2 sensor_midpoint() const;
  /// Returns the distance from its axle's centre within which it may notice another robot, m: 0 without
  /// distance sensors. It is infinite with a radio. It is infinite with a fan, too, since that changes its
  /// grip, and so its possible speed.
  double sight() const;
  /// Returns whether it has parts that report text.
  bool has_text_outputs() const { return has_text_outputs_; }
  /// Collects the text that its parts report at `t`, the end of a tick.
  void poll_text(SimTime t, std::vector<PartText>& told);
  /// Returns whether the last tick's commands drive a motor.
  bool driven() const { return command_[0].drive != 0.0 || command_[1].drive != 0.0; }

  /// Switches the board's supply off or on: parts that share it lose their state.
  void power(bool on, SimTime t);

  /// Returns the voltage of a healthy battery ([motors] supply, as drawn for this robot).
  double battery() const;
  /// Holds the battery at this voltage: it affects the motors, and the parts that measure it. Without a value
  /// the healthy voltage returns; one of [battery] sags and discharges by itself.
  void set_battery(std::optional<double> volts);
  /// Returns the voltage of a [battery] under its present load; nothing if there is none, or a script sets
  /// its volts.
  std::optional<double> fed_volts() const;
  /// Returns whether it has a [battery].
  bool has_battery() const { return has_battery_; }
  /// Returns the present battery voltage.
  double volts() const;
  /// Returns the charge of a [battery], 0..1, or below 0 when it collapses; nothing if there is none.
  std::optional<double> charge() const;

  /// Saves all state that changes during a run, except its body and its board.
  SnapshotRegistry::Snapshot save() const;
  /// Restores a result of this robot's save().
  void restore(const SnapshotRegistry::Snapshot& saved);

  // Scripts. Each throws InputError naming the parts, or fault kinds, that exist.
  /// Press and release a button from `t` on, which is not before the current tick.
  void press(const std::string& part, SimTime t);
  void release(const std::string& part, SimTime t);
  /// Sends a message to a receiver; `t` as in press().
  void send(const std::string& part, const Message& message, SimTime t);
  /// Covers a sensor, or all of an array, so that it sees black.
  void cover(const std::string& part, bool covered);
  /// Breaks a sensor, motor, button or encoder, until the next fault of the same part ("ok" repairs it).
  /// Kinds and arguments are in docs/reference/robots.md.
  void fault(const std::string& part, const std::string& kind, const std::vector<std::string>& arguments);
  /// Do so in two steps: the words are read before the run, and the fault comes later.
  PartFault read_fault(const std::string& part, const std::string& kind,
                       const std::vector<std::string>& arguments) const;
  void fault(const PartFault& fault);

  /// Returns the names that fault() accepts.
  std::vector<std::string> breakable() const;

  // Check whether the calls above would be accepted: they throw the same InputError, and change nothing.
  void check_press(const std::string& part) const;
  void check_send(const std::string& part, const Message& message) const;
  /// Checks that a part of this name exists that may report text.
  void check_tells(const std::string& part) const;
  void check_cover(const std::string& part) const;

  /// Returns the levels of all sensors, then of everything else that is visible, in the order of the robot
  /// file.
  std::vector<Reading> readings() const {
    std::vector<Reading> all;
    read(all);
    return all;
  }
  /// Appends them.
  void read(std::vector<Reading>& readings) const;

  /// Returns every wired pin, in the order of the robot file.
  std::vector<WiredPin> wiring() const;
  /// Return the last tick's motor commands, -1..1, for display.
  double left_command() const { return command_[0].drive; }
  double right_command() const { return command_[1].drive; }

 private:
  struct Impl;
  bool take_commands(SimTime t);

  std::unique_ptr<Impl> impl_;
  const world::WheelCommand* command_ = nullptr;  // of the last tick, by world::Side
  bool has_battery_ = false, has_text_outputs_ = false;
};

}  // namespace robosim::robot
