// A robot file (robot.toml), read and checked. docs/reference/robots.md lists every key with unit, range and
// default.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "hal/board/board_spec.h"
#include "sim/base/error.h"
#include "sim/base/parameter.h"
#include "sim/base/vec.h"
#include "sim/robot/battery.h"
#include "sim/robot/electronics.h"
#include "sim/robot/netlist.h"
#include "sim/world/body.h"

namespace robosim::robot {

class Part;
class PartContext;

/// The wheel that a motor turns or an encoder counts.
using world::Side;

/// steering of [chassis]: front wheels that a servo steers. sim/world/body_steer.cpp.
struct Steering {
  std::string servo;       ///< its name
  Place place;             ///< where the file says so
  Parameter base;          ///< m, from the driven axle to the steered wheels; 0 = none are steered
  Parameter limit;         ///< rad, of the steered wheel; of two, of the inner one
  Parameter ratio;         ///< rad of the wheels for each rad of the servo
  bool ackermann = false;  ///< two steered wheels, `track` apart; else one

  bool exists() const { return base.value > 0.0; }
};

/// [chassis]: the rigid body.
struct Chassis {
  Parameter mass;        ///< kg, of the whole robot
  Parameter inertia;     ///< kg m2, about the vertical axis through the axle's centre; 0 = that of a uniform
                         ///< plate of the outline's shape
  Parameter load_share;  ///< 0..1 of the weight on the driven wheels
  Parameter track;       ///< m, between the two wheels' contact points
  Parameter wheel;       ///< m, a wheel's diameter; drawn for each wheel
  Parameter wheel_inertia;  ///< kg m2 of a wheel with its tyre
  Parameter grip;           ///< coefficient of friction between tyre and floor
  Parameter rolling;        ///< force / weight of tyres and caster
  Parameter wall_friction;  ///< coefficient of friction between outline and wall
  Parameter caster;         ///< m ahead of the axle; negative = behind it; 0 = the usual place
  Parameter caster_radius;  ///< m
  Parameter height;         ///< m, of the mass's centre; 0 = loads do not shift
  Parameter wheelbase;      ///< m, of four wheels, or of tracks as wheels; 0 = two wheels and a caster
  Parameter downforce;      ///< kg whose weight a fan presses it down with
  Steering steering;
  Vec2 circle_centre;         ///< m; the outline, if it is a circle
  double circle_radius = 0;   ///< m; 0 = the outline is `polygon`
  std::vector<Vec2> polygon;  ///< m, counter-clockwise, convex
};

/// [motors]: both motors with their gears. sim/world/body.h has the formulas for these parameters.
struct Motors {
  Parameter voltage;          ///< V, at which the following four hold
  Parameter no_load;          ///< rad/s at the wheel, drawn for each motor
  Parameter no_load_current;  ///< A: friction in motor and gear; drawn for each motor
  Parameter stall_torque;     ///< N m at the wheel, drawn for each motor
  Parameter stall_current;    ///< A, drawn for each motor
  Parameter static_friction;  ///< friction at rest / friction while turning, at least 1; drawn for each motor
  Parameter gear;             ///< motor turns for each turn of the wheel
  Parameter rotor_inertia;    ///< kg m2 of the motor's rotor
  Parameter inductance;       ///< H of the winding, drawn for each motor; 0 = it does not matter
  Parameter supply;           ///< V of the battery
};

/// The effect of one combination of a driver's inputs on the motor.
enum class Bridge : unsigned char { open, shorted, forward, reverse };

/// A motor driver chip, as data. `action[en][in1][in2]`.
struct DriverChip {
  const char* name;   ///< as robot files write it
  double drop;        ///< V lost in the bridge at small currents
  double resistance;  ///< ohm of the bridge, in series with the motor
  double diode;       ///< V lost in a diode that carries on the winding's current
  bool both_ways;     ///< its switches conduct both ways, as MOSFETs do
  Bridge action[2][2][2];
};

/// [driver]
struct Driver {
  const DriverChip* chip = nullptr;
  Parameter drop;        ///< V
  Parameter resistance;  ///< ohm
  Parameter diode;       ///< V
  Pin standby = kNoPin;  ///< high = working; kNoPin = tied to the supply
};

/// One wire between a part and the board.
struct Wire {
  std::string role;  ///< what the part calls it: "en", "pin"; of an array the element's name
  Pin pin = kNoPin;
  Place place;          ///< where the file says so
  bool shared = false;  ///< of a bus: others may be on it too
};

/// The place of a sensor that looks at the floor, for people and pages.
struct SensorPlace {
  std::string name;
  Vec2 at;                 ///< m, in the body's frame
  double footprint = 0.0;  ///< m: side of the square of floor that it sees
};

/// A reading that is a number with a unit, for people and pages. Other readings are levels, or on and off.
struct Gauge {
  std::string name;
  const char* unit;  ///< "deg", "cm", "V", "A", "Hz"; "" of a bare number
};

struct MountSpec;

/// The wheel of a motor that drives both wheels through a differential.
constexpr int kBothWheels = 2;

/// One [[part]], as its type's reader returns it. Immutable; all robots of the description share it.
class PartSpec {
 public:
  std::string name;
  std::string type;
  Place place;
  std::vector<Wire> wires;

  virtual ~PartSpec() = default;
  /// Makes the part of one robot.
  virtual std::unique_ptr<Part> make(PartContext&) const = 0;
  /// Returns the floor sensors that the part brings.
  virtual std::vector<SensorPlace> sensors() const { return {}; }
  /// Returns those of its readings that are numbers.
  virtual std::vector<Gauge> gauges() const { return {}; }
  /// Returns how the part is mounted, if it may sit on a servo; else null.
  virtual const MountSpec* mounted() const { return nullptr; }
  /// The wheel it sits on, if it is a motor: left or right, or kBothWheels; else -1.
  virtual int driven_wheel() const { return -1; }
};

/// [budget]: limits of firmware on the board's chip. `robosim build` fails if a sketch takes more flash or
/// RAM. A run on a chip ends as over_budget if it takes more stack or time.
struct Budget {
  std::int64_t flash_bytes = 0;  ///< 0 = all there is
  std::int64_t ram_bytes = 0;    ///< variables, without the stack; 0 = all there is
  std::int64_t stack_bytes = 0;  ///< the most in use while it runs; 0 = all there is
  double loop_s = 0.0;           ///< the longest pass of loop(); 0 = any
};

/// A file from which a robot was read.
struct SourceText {
  std::filesystem::path file;
  std::string text;
};

struct Description {
  std::string name;  ///< the file's stem, with another board's name behind an @
  std::filesystem::path file;
  std::string sha256;  ///< of the file's bytes, followed by those of its bases and by "@" and another board
  const BoardSpec* board = nullptr;
  Budget budget;
  Chassis chassis;
  Motors motors;
  Driver driver;
  Electronics electronics;
  Battery battery;
  std::vector<Register> registers;  ///< of shift registers and PWM drivers, as netlist.h numbers them
  std::vector<std::shared_ptr<const PartSpec>> parts;  ///< in the file's order, the base's first
  std::vector<SourceText> texts;                       ///< the file, and those of its bases
};

/// Finds a robot's file by what users type: a path if it contains '/' or '.', else the stock robot of that
/// name. Throws InputError naming the stock robots.
std::filesystem::path find_robot(const std::string& name_or_path);

/// Returns the names of the stock robots, sorted.
std::vector<std::string> stock_robots();

/// Reads a robot file, or a stock robot by name, optionally with another board (sim/base/robot_name.h).
/// Throws InputError with file and line.
Description load_description(const std::string& robot_name);

/// Returns a robot's file merged with those that it is based on, as one file without a base and without
/// defaults. Lines from other files have a comment with their place. Throws InputError.
std::string full_text(const std::string& robot_name);

/// Parses a robot from text; `file` is for messages, and `base` is next to it. The board `instead`, if given,
/// replaces the file's own: pins keep their names (5, A0), the voltages of sensors their share of the supply.
/// A budget is for the file's own board, and does not apply then.
Description parse_description(std::string_view text, const std::filesystem::path& file,
                              const BoardSpec* instead = nullptr);

/// Returns a wire's name as robot files write it: "5", "A0", "REG1.Q4".
std::string pin_text(const Description&, Pin);

/// Returns the driver chips that exist.
const std::vector<DriverChip>& driver_chips();

}  // namespace robosim::robot
