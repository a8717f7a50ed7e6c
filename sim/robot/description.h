// Reads and checks a robot file (robot.toml), and represents its content. docs/reference/robots.md lists
// every key with unit, range and default.
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

/// `steering` of [chassis]: front wheels that a servo steers (sim/world/body_steer.cpp).
struct Steering {
  std::string servo;       ///< name of the servo
  Place place;             ///< place of the key in the file
  Parameter base;          ///< m, from the driven axle to the steered wheels; 0 = no steered wheels
  Parameter limit;         ///< rad, largest angle of the steered wheel, or of the inner of two
  Parameter ratio;         ///< rad of the wheels per rad of the servo
  bool ackermann = false;  ///< two steered wheels, `track` apart; else one

  bool exists() const { return base.value > 0.0; }
};

/// [chassis]: the rigid body.
struct Chassis {
  Parameter mass;        ///< kg, of the whole robot
  Parameter inertia;     ///< kg m2, about the vertical axis through the axle's centre; 0 = the inertia of a
                         ///< uniform plate with the outline's shape
  Parameter load_share;  ///< 0..1, share of the weight on the driven wheels
  Parameter track;       ///< m, between the two wheels' contact points
  Parameter wheel;       ///< m, a wheel's diameter; sampled for each wheel
  Parameter wheel_inertia;  ///< kg m2 of a wheel with its tyre
  Parameter grip;           ///< coefficient of friction between tyre and floor
  Parameter rolling;        ///< rolling resistance of tyres and caster, as a share of the weight on them
  Parameter wall_friction;  ///< coefficient of friction between outline and wall
  Parameter caster;         ///< m ahead of the axle; negative = behind it; 0 = the default place
  Parameter caster_radius;  ///< m
  Parameter height;         ///< m, of the centre of mass; 0 = loads do not shift
  Parameter wheelbase;      ///< m between the axles; tracks count as four wheels; 0 = two wheels and a caster
  Parameter downforce;      ///< kg, mass whose weight equals a fan's downforce
  Steering steering;
  Vec2 circle_centre;         ///< m, centre of a circular outline
  double circle_radius = 0;   ///< m; 0 = the outline is `polygon`
  std::vector<Vec2> polygon;  ///< m, counter-clockwise, convex
};

/// [motors]: both motors with their gears. sim/world/body.h has the formulas for these parameters.
struct Motors {
  Parameter voltage;          ///< V, the voltage for which the next four values hold
  Parameter no_load;          ///< rad/s at the wheel, sampled for each motor
  Parameter no_load_current;  ///< A, to overcome friction in motor and gear; sampled for each motor
  Parameter stall_torque;     ///< N m at the wheel, sampled for each motor
  Parameter stall_current;    ///< A, sampled for each motor
  Parameter static_friction;  ///< ratio of static to kinetic friction, at least 1; sampled for each motor
  Parameter gear;             ///< motor turns per turn of the wheel
  Parameter rotor_inertia;    ///< kg m2 of the motor's rotor
  Parameter inductance;       ///< H of the winding, sampled for each motor; 0 = negligible
  Parameter supply;           ///< V of the battery
};

/// The effect of one combination of a driver's inputs on the motor.
enum class Bridge : unsigned char { open, shorted, forward, reverse };

/// A motor driver chip. Its effects are action[en][in1][in2].
struct DriverChip {
  const char* name;   ///< name in robot files
  double drop;        ///< V lost in the bridge at small currents
  double resistance;  ///< ohm of the bridge, in series with the motor
  double diode;       ///< V lost in a freewheeling diode
  bool both_ways;     ///< the switches conduct both ways, as MOSFETs do
  Bridge action[2][2][2];
};

/// [driver]: the motor driver's chip, its electrical values, and its standby pin.
struct Driver {
  const DriverChip* chip = nullptr;
  Parameter drop;        ///< V
  Parameter resistance;  ///< ohm
  Parameter diode;       ///< V
  Pin standby = kNoPin;  ///< high = working; kNoPin = tied to the supply
};

/// One wire between a part and the board.
struct Wire {
  std::string role;  ///< the part's name for the wire: "en", "pin"; in an array, the element's name
  Pin pin = kNoPin;
  Place place;             ///< place of the key in the file
  bool shared = false;     ///< wire of a bus, which other parts may share
  bool may_float = false;  ///< at times, the part gives its pin no level; the pin then needs a pull-up
};

/// The place of a sensor that looks at the floor, for display.
struct SensorPlace {
  std::string name;
  Vec2 at;                 ///< m, in the body's frame
  double footprint = 0.0;  ///< m, side of the square of floor that affects the sensor
};

/// A displayed reading that is a number with a unit. Other readings are levels or switch states.
struct Gauge {
  std::string name;
  const char* unit;  ///< "deg", "cm", "V", "A", "Hz"; "" = none
};

struct MountSpec;

/// The result of driven_wheel() for a motor that drives both wheels through a differential.
constexpr int kBothWheels = 2;

/// One [[part]], as read from the file. The object is immutable, and all robots of a description share it.
class PartSpec {
 public:
  std::string name;
  std::string type;
  Place place;
  std::vector<Wire> wires;

  virtual ~PartSpec() = default;
  /// Creates this part for one robot.
  virtual std::unique_ptr<Part> make(PartContext&) const = 0;
  /// Returns the part's floor sensors.
  virtual std::vector<SensorPlace> sensors() const { return {}; }
  /// Returns the part's readings that are numbers.
  virtual std::vector<Gauge> gauges() const { return {}; }
  /// Returns the part's mount, if the part can be mounted on a servo; else null.
  virtual const MountSpec* mounted() const { return nullptr; }
  /// Returns the wheel that a motor drives: left, right or kBothWheels. Returns -1 for other parts.
  virtual int driven_wheel() const { return -1; }
};

/// [budget]: limits of firmware on the board's chip. `robosim build` fails if a sketch exceeds the flash or
/// RAM. A run on an emulated chip ends with the verdict over_budget if the sketch exceeds the stack or time.
struct Budget {
  std::int64_t flash_bytes = 0;  ///< 0 = the chip's limit
  std::int64_t ram_bytes = 0;    ///< variables, without the stack; 0 = the chip's limit
  std::int64_t stack_bytes = 0;  ///< maximum during a run; 0 = the chip's limit
  double loop_s = 0.0;           ///< s, for one pass of loop(); 0 = no limit
};

/// A file from which a robot was read.
struct SourceText {
  std::filesystem::path file;
  std::string text;
};

struct Description {
  std::string name;  ///< the file's stem; if the board is replaced, followed by @ and the board's name
  std::filesystem::path file;
  std::string sha256;  ///< hash of the file, its bases and, for a replaced board, "@" and the board's name
  const BoardSpec* board = nullptr;
  Budget budget;
  Chassis chassis;
  Motors motors;
  Driver driver;
  Electronics electronics;
  Battery battery;
  std::vector<Register> registers;  ///< of shift registers and PWM drivers, numbered as in netlist.h
  std::vector<std::shared_ptr<const PartSpec>> parts;  ///< in the file's order, after the parts of the base
  std::vector<SourceText> texts;                       ///< the file and its bases
};

/// Finds a robot's file by a path, which contains '/' or '.', or by the name of a stock robot. For an unknown
/// name, throws InputError with a list of the stock robots.
std::filesystem::path find_robot(const std::string& name_or_path);

/// Returns the names of the stock robots, sorted.
std::vector<std::string> stock_robots();

/// Reads a robot file, or a stock robot by name, optionally with another board (sim/base/robot_name.h).
/// Throws InputError with file and line.
Description load_description(const std::string& robot_name);

/// Returns a robot's file merged with its bases, as one file without a base and without defaults. Each line
/// from a base ends with a comment that names the base and the line. Throws InputError.
std::string full_text(const std::string& robot_name);

/// Parses a robot from text. `file` is for messages, and locates the file's `base`. The board `instead`, if
/// not null, replaces the file's own board. Pins then keep their names (5, A0), and sensors' voltages keep
/// their share of the supply. The file's budget is dropped.
Description parse_description(std::string_view text, const std::filesystem::path& file,
                              const BoardSpec* instead = nullptr);

/// Returns a wire's name in robot files: "5", "A0", "REG1.Q4".
std::string pin_text(const Description&, Pin);

/// Returns all driver chips.
const std::vector<DriverChip>& driver_chips();

}  // namespace robosim::robot
