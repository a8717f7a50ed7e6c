// A robot: parts, wired to a board's pins, on a body in the world.
#pragma once

#include <cmath>
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

/// A level for display, without noise. Reading it does not consume a noise sample.
struct Reading {
  std::string_view part;  ///< "S1" … for elements of an array, else the part's name; owned by the robot
  double value;           ///< floor sensor: 0 white .. 1 black; LED: 0..1; button: 0 or 1; Gauge: in its unit
};

/// A pin of the board and the part wired to it, so that a verdict can name the part ("pin 2, the button
/// start").
struct WiredPin {
  std::string part;  ///< "start"
  std::string type;  ///< "button", "motor", "reflectance-array" …
  std::string role;  ///< "in1", "pwm"; may be empty
  Pin pin = kNoPin;
  bool may_float = false;  ///< at times, the part gives its pin no level; the pin then needs a pull-up
  int wheel = -1;          ///< world::Side of the wheel that the part drives; -1 = none or both
  bool steers = false;     ///< the part is the servo that steers the front wheels
};

/// A smaller share of full power does not drive a motor: a chip's PWM outputs 1/256 even at OCR0A = 0.
inline constexpr double kSmallestPulse = 1.0 / 128.0;

/// A message of a script to a part. A remote control's receiver gets bits or a key's number; Bluetooth gets
/// text.
struct Message {
  std::string text;
  SimTime held = 0;  ///< the duration for which a remote control's key is held
};

/// The output of a part: a line that the sketch sent by Bluetooth, the text of a display.
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

  /// Performs step 1 of a tick (sim/run/simulation.h): parts schedule their edges from the state at `t`.
  void begin_tick(SimTime t);
  /// Performs step 3 of a tick: averages the motor commands over the tick that ends at `t`. Returns whether a
  /// command has changed.
  bool end_tick(SimTime t);
  /// Returns whether begin_tick() and end_tick() would do nothing in further ticks. The caller may then call
  /// begin_idle_tick() instead. The idle state ends when anything touches the body, firmware accesses the
  /// board, or a script acts.
  bool idles() const;
  void begin_idle_tick(SimTime t);

  /// Returns whether any reflectance sensor's footprint touches the line, without noise.
  bool sees_line() const;
  /// Returns whether a line passes between the outermost two reflectance sensors, for example if two sensors
  /// straddle the line. `off_m` is the distance in m from sensor_midpoint() to the nearest line.
  bool straddles_line(double off_m) const;
  /// Returns the mean lateral position of the sensors that touch the line, m to the left of the body's
  /// middle. The weight of a sensor is the share of its footprint on the line. Returns 0 if no footprint
  /// touches the line.
  double line_side() const;
  /// Returns whether the robot has any reflectance sensor.
  bool has_line_sensors() const;
  /// Returns the midpoint of the reflectance sensors in the body's frame, m, where the cross-track error is
  /// measured. Returns (0, 0) without such sensors.
  Vec2 sensor_midpoint() const;
  /// Returns the distance from the axle's centre within which the robot may detect another robot, m; 0
  /// without distance sensors. The distance is infinite with a radio. It is also infinite with a fan, which
  /// changes the robot's grip, and therefore its possible speed.
  double sight() const;
  /// Returns whether the robot has parts that report text.
  bool has_text_outputs() const { return has_text_outputs_; }
  /// Collects the text that the parts report at `t`, the end of a tick.
  void poll_text(SimTime t, std::vector<PartText>& told);
  /// Returns whether the last tick's commands drive a motor. A command of up to kSmallestPulse does not
  /// count. If less than 1/64 starts a wheel from rest, the limit for this wheel is half of the power that
  /// starts it.
  bool driven() const {
    return std::abs(command_[0].drive) > driven_from_[0] || std::abs(command_[1].drive) > driven_from_[1];
  }

  /// Switches the board's supply off or on. Parts on this supply lose their state.
  void power(bool on, SimTime t);

  /// Returns the voltage of a healthy battery ([motors] supply, as sampled for this robot).
  double battery() const;
  /// Holds the battery's voltage constant. The voltage affects the motors and the parts that measure it. A
  /// nullopt restores the healthy voltage; a [battery] then sags and discharges by its own model.
  void set_battery(std::optional<double> volts);
  /// Returns the voltage of a [battery] under its present load; nullopt without a [battery], or if a script
  /// sets the voltage.
  std::optional<double> fed_volts() const;
  /// Returns whether the robot has a [battery].
  bool has_battery() const { return has_battery_; }
  /// Returns the present battery voltage.
  double volts() const;
  /// Returns the charge of a [battery], 0..1, or below 0 when its voltage collapses; nullopt without a
  /// [battery].
  std::optional<double> charge() const;

  /// Saves all state that changes during a run, except the state of the body and of the board.
  SnapshotRegistry::Snapshot save() const;
  /// Restores a result of this robot's save().
  void restore(const SnapshotRegistry::Snapshot& saved);

  // Functions for scripts. Each throws InputError with a list of the existing parts or fault kinds.
  /// Press or release a button from `t` on; `t` must not be before the current tick.
  void press(const std::string& part, SimTime t);
  void release(const std::string& part, SimTime t);
  /// Sends a message to a receiver at `t`, which must not be before the current tick.
  void send(const std::string& part, const Message& message, SimTime t);
  /// Covers or uncovers a sensor, or all sensors of an array. A covered sensor detects black.
  void cover(const std::string& part, bool covered);
  /// Breaks a part until its next fault; the fault "ok" repairs the part. Kinds and arguments are in
  /// docs/reference/robots.md.
  void fault(const std::string& part, const std::string& kind, const std::vector<std::string>& arguments);
  /// Break a part in two steps: read_fault() before the run, and fault() when the fault occurs.
  PartFault read_fault(const std::string& part, const std::string& kind,
                       const std::vector<std::string>& arguments) const;
  void fault(const PartFault& fault);

  /// Returns the names that fault() accepts.
  std::vector<std::string> breakable() const;

  // The next functions check the arguments of the functions above. They throw the same InputError, and change
  // nothing.
  void check_press(const std::string& part) const;
  void check_send(const std::string& part, const Message& message) const;
  /// Checks that a part of this name exists and may report text.
  void check_tells(const std::string& part) const;
  void check_cover(const std::string& part) const;

  /// Returns the levels of all sensors, then of all other visible parts, in the order of the robot file.
  std::vector<Reading> readings() const {
    std::vector<Reading> all;
    read(all);
    return all;
  }
  /// Appends the readings to `readings`.
  void read(std::vector<Reading>& readings) const;

  /// Returns wiring_of() this robot's description.
  std::vector<WiredPin> wiring() const;
  /// Return the last tick's motor commands, -1..1, for display.
  double left_command() const { return command_[0].drive; }
  double right_command() const { return command_[1].drive; }
  /// Returns the largest absolute value of a wheel's command so far, 0..1.
  double strongest_command(world::Side side) const;

 private:
  struct Impl;
  bool take_commands(SimTime t);

  std::unique_ptr<Impl> impl_;
  const world::WheelCommand* command_ = nullptr;  // commands of the last tick, by world::Side
  double driven_from_[2] = {0.0, 0.0};            // limits of driven(), by world::Side
  bool has_battery_ = false, has_text_outputs_ = false;
};

/// Returns every wired pin, in the order of the robot file.
std::vector<WiredPin> wiring_of(const Description& robot);

}  // namespace robosim::robot
