// A robot: parts, wired to a board's pins, on a body in the world.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hal/board/robot_port.h"
#include "sim/base/kept.h"
#include "sim/base/profile.h"
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
  SimTime held = 0;  ///< for which a remote control's key is held
};

/// The output of a part: a line received by Bluetooth, the text of a display.
struct Told {
  std::string part;
  std::string text;
};

class Robot {
 public:
  /// `number` distinguishes robots in one world; all noise derives from (seed, number, part name). The
  /// description, the world and the board must outlive the robot. The body's parameters are body_params() of
  /// describe.h.
  Robot(const Description&, world::World&, std::size_t body, RobotPort&, std::uint64_t seed, Profile,
        std::uint32_t number = 0);
  ~Robot();
  Robot(const Robot&) = delete;
  Robot& operator=(const Robot&) = delete;

  /// Step (1) of a tick: parts schedule their edges from the state at `t`.
  void begin_tick(SimTime t);
  /// Step (3): motor commands become the time average of their pins over the tick that ends at `t`. Whether
  /// one has changed.
  bool end_tick(SimTime t);
  /// Whether both steps would do nothing in the ticks to come, as long as nothing touches the body, firmware
  /// leaves the board alone, and no script does anything: then begin_idle_tick() is all there is to do.
  bool idles() const;
  void begin_idle_tick(SimTime t);

  /// Whether any reflectance sensor's footprint touches the line, without noise.
  bool sees_line() const;
  /// Where in the body's frame, to the left of its middle, those sensors are whose footprints touch the line:
  /// their mean, by how much of each is on it, m. 0 where none is.
  double line_side() const;
  /// Whether it has any reflectance sensor.
  bool has_line_sensors() const;
  /// Midpoint of the reflectance sensors in the body's frame, m. The cross-track error is measured here. (0,
  /// 0) without any.
  Vec2 sensor_midpoint() const;
  /// m from its axle's centre, within which it may notice another robot: 0 without distance sensors. Infinite
  /// with a radio; and with a fan, which changes its grip, and so how fast it may be somewhere else.
  double sight() const;
  /// Whether it has parts that tell something.
  bool has_tellers() const { return has_tellers_; }
  /// What its parts have to tell at `t`, the end of a tick.
  void tell(SimTime t, std::vector<Told>& told);
  /// Whether the last tick's commands drive a motor.
  bool driven() const { return command_[0].drive != 0.0 || command_[1].drive != 0.0; }

  /// The board's supply is switched off, or on again: parts that share it lose their state.
  void power(bool on, SimTime t);

  /// V, of a healthy battery ([motors] supply, as drawn for this robot).
  double battery() const;
  /// Holds the battery's voltage there from now on: it affects the motors, and the parts that measure it.
  /// Nothing: it gives the healthy one's again; one of [battery] sags and empties by itself.
  void set_battery(std::optional<double> volts);
  /// V, of a [battery] as it is loaded now; nothing where the robot has none, or a script says its volts.
  std::optional<double> fed_volts() const;
  /// Whether it has a [battery].
  bool has_battery() const { return has_battery_; }
  /// V, that the battery gives now.
  double volts() const;
  /// Of a [battery], 0..1, or below 0 where it collapses; nothing where the robot has none.
  std::optional<double> charge() const;

  /// All that changes during a run, but for its body and its board.
  Kept::Copy save() const;
  /// What this robot's save() gave.
  void restore(const Kept::Copy& saved);

  // Scripts. Each throws InputError naming the parts, or fault kinds, that exist.
  /// Holds a button down from `t` on, or lets go of it; `t` is not before the current tick.
  void press(const std::string& part, SimTime t);
  void release(const std::string& part, SimTime t);
  /// Something is sent to a receiver; `t` as in press().
  void send(const std::string& part, const Message& message, SimTime t);
  /// A finger on a sensor, or on all of an array: it sees black.
  void cover(const std::string& part, bool covered);
  /// Breaks a sensor, motor, button or encoder, until the next fault of the same part ("ok" repairs it).
  /// Kinds and arguments are in docs/robots.md.
  void fault(const std::string& part, const std::string& kind, const std::vector<std::string>& arguments);
  /// The same in two steps: the words are read before the run, and the fault comes later.
  PartFault read_fault(const std::string& part, const std::string& kind,
                       const std::vector<std::string>& arguments) const;
  void fault(const PartFault& fault);

  /// The names that fault() takes.
  std::vector<std::string> breakable() const;

  // Whether the calls above would be accepted: they throw the same InputError, and change nothing.
  void check_press(const std::string& part) const;
  void check_send(const std::string& part, const Message& message) const;
  /// That there is a part of this name that may tell something.
  void check_tells(const std::string& part) const;
  void check_cover(const std::string& part) const;

  /// Sensors first, then what else there is to see, each in the order of the robot file.
  std::vector<Reading> readings() const {
    std::vector<Reading> all;
    read(all);
    return all;
  }
  /// Adds them.
  void read(std::vector<Reading>& readings) const;

  /// Every wired pin, in the order of the robot file.
  std::vector<WiredPin> wiring() const;
  /// The last tick's motor commands, -1..1, for display.
  double left_command() const { return command_[0].drive; }
  double right_command() const { return command_[1].drive; }

 private:
  struct Inside;
  bool take_commands(SimTime t);

  std::unique_ptr<Inside> in_;
  const world::WheelCommand* command_ = nullptr;  // of the last tick, by world::Side
  bool has_battery_ = false, has_tellers_ = false;
};

}  // namespace robosim::robot
