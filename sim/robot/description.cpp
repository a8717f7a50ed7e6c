#include "sim/robot/description.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "sim/base/config_text.h"
#include "sim/base/did_you_mean.h"
#include "sim/base/file.h"
#include "sim/base/file_kind.h"
#include "sim/base/robot_name.h"
#include "sim/robot/netlist.h"
#include "sim/robot/part_reader.h"
#include "sim/robot/parts/mount.h"
#include "sim/robot/parts/shift_register.h"
#include "sim/robot/robot.h"
#include "sim/robot/robot_source.h"

namespace robosim::robot {
namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMostParts = 64;
constexpr double kTrackAsWheels = 0.57735026918962576;  // 1 / sqrt(3): sim/world/body_skid.cpp
constexpr double kMostSteered = 30.0 * kDegree;         // linkages of hobby cars reach 25 to 35 degrees
constexpr double kRpm = 2.0 * std::numbers::pi / 60.0;

std::vector<std::string> board_names() {
  std::vector<std::string> names;
  for (int i = 0; board_at(i); ++i) names.emplace_back(board_at(i)->name);
  return names;
}

const BoardSpec& read_board(TableReader& reader) {
  const ConfigValue& value = reader.require("board");
  const BoardSpec* board = find_board(as_string(value, "board").c_str());
  if (board) return *board;
  throw InputError(value.place, fmt::format("board: {}", expected_one_of(value.string, board_names())));
}

// Returns whether every corner lies to the left of every side. It is not enough to test that each corner
// turns left, because a star-shaped outline also passes that test.
bool convex(const std::vector<Vec2>& corners) {
  const std::size_t n = corners.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 2; k < n; ++k)
      if (cross(corners[(i + 1) % n] - corners[i], corners[(i + k) % n] - corners[i]) <= 0.0) return false;
  return true;
}

void read_outline(TableReader& reader, Chassis& chassis) {
  const ConfigValue& value = reader.require("outline");
  if (value.kind == ConfigValue::Kind::table) {
    TableReader circle(value, "outline");
    chassis.circle_radius = as_quantity(circle.require("radius"), "radius", Dimension::length, 0.01, 0.5);
    if (const ConfigValue* at = circle.find("at")) chassis.circle_centre = as_point(*at, "at");
    circle.finish();
    return;
  }
  if (value.kind != ConfigValue::Kind::array || value.items.size() < 3 || value.items.size() > 32)
    throw InputError(
        value.place,
        "outline: expected { radius = \"90 mm\" }, or 3 to 32 corners such as [[\"80 mm\", \"50 mm\"], ...]");
  std::vector<Vec2>& corners = chassis.polygon;
  for (const ConfigValue& corner : value.items) corners.push_back(as_point(corner, "outline"));
  const std::size_t n = corners.size();
  double area = 0.0;
  for (std::size_t i = 0; i < n; ++i) area += cross(corners[i], corners[(i + 1) % n]);
  if (area < 0.0) std::reverse(corners.begin(), corners.end());
  if (!convex(corners) || std::abs(area) < 2e-4)
    throw InputError(
        value.place,
        "outline: expected a convex outline larger than 1 cm2, with its corners in order around the robot");
}

Steering read_steering(const ConfigValue& table, TableReader& chassis) {
  for (const char* key : {"wheelbase", "tracks", "caster"})
    if (const ConfigValue* const other = chassis.find(key))
      throw InputError(
          other->place,
          fmt::format("{} requires a robot without steered wheels; this robot has the key steering", key));
  TableReader reader(table, "steering");
  Steering steering;
  const ConfigValue& servo = reader.require("servo");
  steering.servo = as_string(servo, "servo");
  steering.place = servo.place;
  reader.require("base");
  steering.base = read_parameter(reader, "base", Dimension::length, {}, 0.02, 0.5);
  steering.limit =
      read_parameter(reader, "limit", Dimension::angle, {kMostSteered, 0.0}, kDegree, 75.0 * kDegree);
  steering.ratio = read_parameter(reader, "ratio", Dimension::ratio, {1.0, 0.0}, 0.05, 5.0);
  steering.ackermann = reader.integer("wheels", 1, 1, 2) == 2;
  reader.finish();
  return steering;
}

Chassis read_chassis(const ConfigValue& table) {
  TableReader reader(table, "[chassis]");
  for (const char* key : {"mass", "track", "wheel"}) reader.require(key);
  Chassis chassis;
  chassis.mass = read_parameter(reader, "mass", Dimension::mass, {}, 0.02, 5.0);
  chassis.inertia = read_parameter(reader, "inertia", Dimension::inertia, {}, 1e-6, 0.5);
  chassis.load_share = read_parameter(reader, "load_share", Dimension::ratio, {0.8, 0.0}, 0.05, 1.0);
  chassis.track = read_parameter(reader, "track", Dimension::length, {}, 0.02, 0.5);
  chassis.wheel = read_parameter(reader, "wheel", Dimension::length, {}, 0.01, 0.3);
  chassis.wheel_inertia =
      read_parameter(reader, "wheel_inertia", Dimension::inertia, {1e-6, 0.0}, 1e-9, 1e-2);
  chassis.grip = read_parameter(reader, "grip", Dimension::ratio, {0.8, 0.0}, 0.05, 3.0);
  chassis.rolling = read_parameter(reader, "rolling", Dimension::ratio, {0.02, 0.0}, 0.0, 0.5);
  chassis.wall_friction = read_parameter(reader, "wall_friction", Dimension::ratio, {0.3, 0.0}, 0.0, 2.0);
  chassis.caster = read_parameter(reader, "caster", Dimension::length, {}, -0.3, 0.3);
  if (const ConfigValue* const caster = reader.find("caster");
      caster && std::abs(chassis.caster.value) < 0.005)
    throw InputError(caster->place,
                     "caster: expected at least 5 mm ahead of the axle, or at most -5 mm, behind the axle");
  chassis.caster_radius =
      read_parameter(reader, "caster_radius", Dimension::length, {0.008, 0.0}, 0.001, 0.1);
  chassis.height = read_parameter(reader, "height", Dimension::length, {}, 0.0, 0.3);
  chassis.wheelbase = read_parameter(reader, "wheelbase", Dimension::length, {}, 0.02, 0.5);
  if (const ConfigValue* const tracks = reader.find("tracks")) {
    if (reader.find("wheelbase"))
      throw InputError(
          tracks->place,
          "expected either tracks (the length of the tracks) or wheelbase (the distance between axles), got "
          "both");
    chassis.wheelbase =
        read_parameter(reader, "tracks", Dimension::length, {}, 0.03, 0.6).scaled(kTrackAsWheels);
  }
  chassis.downforce = read_parameter(reader, "downforce", Dimension::mass, {}, 0.0, 5.0);
  if (const ConfigValue* const steering = reader.find("steering")) {
    chassis.steering = read_steering(*steering, reader);
    // The steered wheels carry at least 5 % of the weight, the driven wheels at most 95 %.
    read_parameter(reader, "load_share", Dimension::ratio, {0.8, 0.0}, 0.05, 0.95);
  }
  read_outline(reader, chassis);
  reader.finish();
  return chassis;
}

Motors read_motors(const ConfigValue& table) {
  TableReader reader(table, "[motors]");
  for (const char* key : {"voltage", "no_load", "stall_torque", "supply"}) reader.require(key);
  const ConfigValue& stall_current = reader.require("stall_current");
  Motors motors;
  motors.voltage = read_parameter(reader, "voltage", Dimension::voltage, {}, 1.0, 30.0);
  motors.no_load = read_parameter(reader, "no_load", Dimension::rotation_rate, {}, 5 * kRpm, 6000 * kRpm);
  motors.no_load_current =
      read_parameter(reader, "no_load_current", Dimension::current, {0.0, 0.0}, 0.0, 5.0);
  motors.stall_torque = read_parameter(reader, "stall_torque", Dimension::torque, {}, 1e-4, 10.0);
  motors.stall_current = read_parameter(reader, "stall_current", Dimension::current, {}, 0.02, 50.0);
  motors.static_friction = read_parameter(reader, "static_friction", Dimension::ratio, {1.5, 0.0}, 1.0, 10.0);
  motors.gear = read_parameter(reader, "gear", Dimension::ratio, {1.0, 0.0}, 0.1, 2000.0);
  motors.rotor_inertia = read_parameter(reader, "rotor_inertia", Dimension::inertia, {1e-8, 0.0}, 0.0, 1e-3);
  motors.inductance = read_parameter(reader, "inductance", Dimension::inductance, {0.0, 0.0}, 0.0, 0.1);
  motors.supply = read_parameter(reader, "supply", Dimension::voltage, {}, 1.0, 30.0);
  reader.finish();
  const double most_friction = motors.no_load_current.value + motors.no_load_current.spread;
  if (most_friction * 1.25 > motors.stall_current.value - motors.stall_current.spread)
    throw InputError(stall_current.place, "stall_current: expected at least 1.25 times no_load_current");
  return motors;
}

Budget read_budget(const ConfigValue& table, const BoardSpec& board) {
  TableReader reader(table, "[budget]");
  Budget budget;
  budget.flash_bytes = reader.integer("flash", 0, 1, board.flash_bytes);
  budget.ram_bytes = reader.integer("ram", 0, 1, board.ram_bytes);
  budget.stack_bytes = reader.integer("stack", 0, 1, board.ram_bytes);
  if (const ConfigValue* loop = reader.find("loop"))
    budget.loop_s = as_quantity(*loop, "loop", Dimension::time, 1e-6, 100.0);
  reader.finish();
  return budget;
}

Driver read_driver(const ConfigValue& table, const Terminals& terminals, std::vector<Wire>& wires) {
  TableReader reader(table, "[driver]");
  std::vector<std::string> names;
  for (const DriverChip& chip : driver_chips()) names.emplace_back(chip.name);
  reader.require("chip");
  const std::string name = reader.choice("chip", "", names);
  Driver driver;
  for (const DriverChip& chip : driver_chips())
    if (chip.name == name) driver.chip = &chip;
  driver.drop = read_parameter(reader, "drop", Dimension::voltage, {driver.chip->drop, 0.0}, 0.0, 10.0);
  driver.resistance =
      read_parameter(reader, "resistance", Dimension::resistance, {driver.chip->resistance, 0.0}, 0.0, 100.0);
  driver.diode = read_parameter(reader, "diode", Dimension::voltage, {driver.chip->diode, 0.0}, 0.0, 10.0);
  if (const ConfigValue* standby = reader.find("standby")) {
    driver.standby = as_pin(*standby, "standby", terminals, PinUse::driven);
    wires.push_back({"standby", driver.standby, standby->place});
  }
  reader.finish();
  return driver;
}

// Collects all registers before any part is read, because a part may refer to a register further down.
std::vector<Register> registers_of(const ConfigValue* parts) {
  std::vector<Register> registers;
  if (!parts) return registers;
  for (const ConfigValue& part : parts->items) {
    const std::string type = text_of(part, "type"), name = text_of(part, "name");
    if (type == "shift-register") registers.push_back({name});
    for (int first = 0; type == "pca9685" && first < 2 * kRegisterOutputs; first += kRegisterOutputs)
      registers.push_back({name, first});
    if (registers.size() > kMostRegisters)
      throw InputError(part.place,
                       fmt::format("too many shift registers: expected at most {}; a pca9685 counts as two",
                                   kMostRegisters));
  }
  return registers;
}

std::shared_ptr<const PartSpec> read_part(const ConfigValue& table, const Terminals& terminals,
                                          const Description& robot) {
  PartReader reader(table, terminals, robot.driver);
  std::vector<std::string> names;
  for (const PartType& type : part_types()) {
    if (reader.type() == type.name) return type.read(reader);
    names.emplace_back(type.name);
  }
  throw InputError(table.find("type")->place, fmt::format("type: {}", expected_one_of(reader.type(), names)));
}

// Rejects two parts on one pin (except on a shared bus), two parts of the same name, and two motors on one
// wheel.
void check_together(const Description& robot, const std::vector<Wire>& driver_wires,
                    const RobotSource& source) {
  struct User {
    const Wire* wire;
    std::string part;
  };
  std::vector<User> users;
  const auto take = [&](const Wire& wire, const std::string& part) {
    for (const User& user : users)
      if (user.wire->pin == wire.pin && !(user.wire->shared && wire.shared))
        throw InputError(
            wire.place, fmt::format("pin {} is already used by {} of {} ({}): expected one part for each pin",
                                    pin_text(robot, wire.pin), user.wire->role, user.part,
                                    place_text(source, user.wire->place)));
    users.push_back({&wire, part});
  };
  for (const Wire& wire : driver_wires) take(wire, "[driver]");
  std::vector<std::string> names;
  const PartSpec* motor[2] = {nullptr, nullptr};
  bool both = false;
  for (const auto& part : robot.parts) {
    for (const Wire& wire : part->wires) take(wire, part->name);
    std::vector<std::string> own{part->name};
    for (const SensorPlace& sensor : part->sensors())
      if (sensor.name != part->name) own.push_back(sensor.name);
    for (const std::string& name : own) {
      if (std::find(names.begin(), names.end(), name) != names.end())
        throw InputError(
            part->place,
            fmt::format("duplicate name {}: expected a different name for every part and sensor", name));
      names.push_back(name);
    }
    const int wheel = part->driven_wheel();
    if (wheel < 0) continue;
    if (wheel == kBothWheels && !robot.chassis.steering.exists())
      throw InputError(
          part->place,
          fmt::format("motor {} drives both wheels through a differential, which requires steered "
                      "wheels: the key steering of [chassis]",
                      part->name));
    if (both || (wheel == kBothWheels && (motor[world::left] || motor[world::right]))) {
      const PartSpec* other = motor[world::left] ? motor[world::left] : motor[world::right];
      throw InputError(part->place,
                       fmt::format("motors {} and {} drive the same wheel; a motor with wheel = \"both\" "
                                   "excludes other motors",
                                   other->name, part->name));
    }
    if (wheel == kBothWheels) {
      both = true;
      motor[world::left] = motor[world::right] = part.get();
      continue;
    }
    if (motor[wheel])
      throw InputError(part->place,
                       fmt::format("motors {} and {} drive the same wheel; give one of them wheel = \"{}\"",
                                   motor[wheel]->name, part->name, wheel == world::left ? "right" : "left"));
    motor[wheel] = part.get();
  }
}

// Rejects mounts and steering that refer to a missing servo.
void check_mounts(const Description& robot) {
  std::vector<std::string> servos;
  for (const auto& part : robot.parts)
    if (part->type == "servo") servos.push_back(part->name);
  const auto check = [&](const std::string& name, const char* key, const Place& place) {
    if (std::find(servos.begin(), servos.end(), name) != servos.end()) return;
    throw InputError(place, servos.empty()
                                ? fmt::format("{}: unknown servo “{}”: the robot has none", key, name)
                                : fmt::format("{}: unknown servo: {}", key, expected_one_of(name, servos)));
  };
  const Steering& steering = robot.chassis.steering;
  if (steering.exists()) check(steering.servo, "servo", steering.place);
  for (const auto& part : robot.parts) {
    const MountSpec* mount = part->mounted();
    if (!mount || mount->servo.empty()) continue;
    check(mount->servo, "on", mount->servo_place);
  }
}

}  // namespace

namespace {

Description read_description(const RobotSource& source, const fs::path& file, const BoardSpec* instead) {
  TableReader reader(source.tree, "a robot file");
  Description robot;
  robot.name = file.stem().string();
  robot.file = file;
  robot.texts = source.texts;
  const std::string bytes = bytes_of(source);
  robot.sha256 = sha256(bytes);
  reader.find("base");
  reader.find("remove");
  const BoardSpec& own_board = read_board(reader);
  robot.board = &own_board;
  if (const ConfigValue* budget = reader.find("budget")) robot.budget = read_budget(*budget, own_board);
  if (instead && instead != &own_board) {
    robot.board = instead;
    robot.budget = {};
    robot.name = robot_with_board(robot.name, instead->name);
    robot.sha256 = sha256(bytes + "@" + instead->name);
  }
  robot.chassis = read_chassis(reader.require("chassis"));
  robot.motors = read_motors(reader.require("motors"));
  const ConfigValue* parts = reader.find("part");
  if (parts && parts->kind != ConfigValue::Kind::array)
    throw InputError(parts->place, "part: expected a table [[part]] for each part");
  if (parts && parts->items.size() > kMostParts)
    throw InputError(parts->items[kMostParts].place,
                     fmt::format("too many parts: expected at most {}", kMostParts));
  const Terminals terminals{robot.board, &own_board, registers_of(parts)};
  robot.registers = terminals.registers;
  std::vector<Wire> driver_wires;
  robot.driver = read_driver(reader.require("driver"), terminals, driver_wires);
  if (const ConfigValue* table = reader.find("electronics")) robot.electronics = read_electronics(*table);
  if (const ConfigValue* table = reader.find("battery")) robot.battery = read_battery(*table);
  if (parts)
    for (const ConfigValue& part : parts->items) robot.parts.push_back(read_part(part, terminals, robot));
  reader.finish();
  check_together(robot, driver_wires, source);
  check_chains(robot);
  check_mounts(robot);
  return robot;
}

}  // namespace

Description parse_description(std::string_view text, const fs::path& file, const BoardSpec* instead) {
  const RobotSource source = read_source(text, file);
  try {
    return read_description(source, file, instead);
  } catch (const InputError& error) {
    const auto base = source.based_on.find(error.place().file);
    if (base == source.based_on.end()) throw;
    const Place& extends = base->second;
    throw InputError(error.place(), fmt::format("{} ({}:{} extends this file)", error.message(), extends.file,
                                                extends.line));
  }
}

std::string pin_text(const Description& robot, Pin pin) {
  if (!is_output(pin))
    return pin < robot.board->analog_pin_0 ? std::to_string(pin) : robot.board->pins[pin].name;
  return output_name(robot.registers, pin);
}

Description load_description(const std::string& robot_name) {
  const RobotName name = parse_robot_name(robot_name);
  const BoardSpec* board = name.board.empty() ? nullptr : find_board(name.board.c_str());
  if (!board && !name.board.empty())
    throw InputError(
        fmt::format("{}: unknown board: {}", robot_name, expected_one_of(name.board, board_names())));
  const fs::path file = find_robot(name.robot);
  const std::string text = read_file(file);
  return read_as(FileKind::robot, text, file.string(), [&] { return parse_description(text, file, board); });
}

std::string full_text(const std::string& robot_name) {
  const fs::path file = find_robot(parse_robot_name(robot_name).robot);
  return to_toml(read_source(read_file(file), file).tree, file.string());
}

}  // namespace robosim::robot
