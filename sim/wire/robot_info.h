// Defines the description of a robot that a runner sends to its client.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim/result/fields.h"

namespace robosim::wire {
using namespace result;  // the values that messages carry

struct RobotInfo {
  static constexpr const char* kKey = "robot";
  struct Board {
    std::string name;   ///< "uno"
    std::string fqbn;   ///< "arduino:avr:uno"
    std::string macro;  ///< "ARDUINO_AVR_UNO"
  };
  /// The bytes of the chip's memory that firmware may use; 0 = all of them.
  struct Budget {
    std::int64_t flash_bytes = 0;
    std::int64_t ram_bytes = 0;
  };
  struct Sensor {
    std::string name;
    double x_mm = 0.0;          ///< forward from the axle's centre
    double y_mm = 0.0;          ///< to the left of the axle's centre
    double footprint_mm = 0.0;  ///< side of its square footprint on the floor; 0 = unknown
  };
  /// A numeric reading. Other readings are levels, or on and off.
  struct Gauge {
    std::string name;
    std::string unit;  ///< "cm"; "" for a plain number
  };
  struct Part {
    std::string name;
    std::string type;  ///< "motor"
    std::vector<std::pair<std::string, std::string>>
        pins;  ///< pairs of a pin's function in the part, and the pin: {"in1", "8"}
  };
  /// Wheels that a servo steers.
  struct Steering {
    std::string servo;        ///< the servo that provides the reading
    double base_mm = 0.0;     ///< distance from the driven axle forward to the steered wheels
    int wheels = 1;           ///< 1 or 2; two wheels are `track` apart
    double middle_deg = 0.0;  ///< the reading for straight ahead
    double ratio = 0.0;       ///< degrees to the left per unit of the reading
    double limit_deg = 0.0;   ///< limit of the steering angle in each direction
  };
  std::string name;
  std::string file;
  std::string sha256;
  Board board;
  Budget budget;
  std::vector<std::array<double, 2>> outline_mm;  ///< corners in the body's frame: forward, left
  double track_mm = 0.0;                          ///< between the wheels' contact points; 0 = unknown
  double wheel_mm = 0.0;                          ///< diameter; 0 = unknown
  std::optional<Steering> steering;
  std::vector<Sensor> sensors;
  std::vector<Gauge> gauges;
  std::vector<Part> parts;
  std::string text;  ///< the robot's file, merged with its base robots; empty unless requested
};

template <class V>
void fields(V& v, Same<V, RobotInfo::Board>& b) {
  v("name", b.name, "name of the board: `\"uno\"`");
  v("fqbn", b.fqbn, "the board's FQBN: `\"arduino:avr:uno\"`");
  v("macro", b.macro, "the board's macro: `\"ARDUINO_AVR_UNO\"`");
}

template <class V>
void fields(V& v, Same<V, RobotInfo::Budget>& b) {
  v("flash_bytes", b.flash_bytes, "bytes of flash memory that firmware may use; 0 = all");
  v("ram_bytes", b.ram_bytes, "bytes of RAM that firmware may use; 0 = all");
}

template <class V>
void fields(V& v, Same<V, RobotInfo::Steering>& s) {
  v("servo", s.servo, "name of the servo's reading");
  v("base", s.base_mm, "distance from the driven axle to the steered wheels", {.unit = "mm"});
  v("wheels", s.wheels, "number of steered wheels: 1, or 2 that are `track` apart");
  v("middle", s.middle_deg, "the reading for straight ahead", {.unit = "deg"});
  v("ratio", s.ratio,
    "degrees to the left for each degree of the reading; for two wheels, of a virtual middle wheel");
  v("limit", s.limit_deg, "limit of these degrees in each direction", {.unit = "deg"});
}

template <class V>
void fields(V& v, Same<V, RobotInfo::Sensor>& s) {
  v("name", s.name, "name, as in `readings` of `started`");
  v("x", s.x_mm, "distance forward of the axle's centre", {.unit = "mm"});
  v("y", s.y_mm, "distance to the left of the axle's centre", {.unit = "mm"});
  v("footprint", s.footprint_mm, "side of the square of floor that the sensor sees",
    {.unit = "mm", .presence = kOptional});
}

template <class V>
void fields(V& v, Same<V, RobotInfo::Gauge>& g) {
  v("name", g.name, "name, as in `readings` of `started`");
  v("unit", g.unit, "unit of the reading: `\"deg\"`, `\"cm\"`, `\"V\"` …; empty for a plain number");
}

template <class V>
void fields(V& v, Same<V, RobotInfo::Part>& p) {
  v("name", p.name, "name of the part in the robot's file");
  v("type", p.type, "type of the part: `\"motor\"`");
  v("pins", PinsByUse{p.pins},
    "for each use of a pin: the pin's number on the board, or the name of a shift register's output: "
    "`\"REG1.Q4\"`");
}

template <class V>
void fields(V& v, Same<V, RobotInfo>& r) {
  v("name", r.name, "name of the robot");
  v("file", r.file, "path of the robot's file");
  v("sha256", r.sha256, "SHA-256 of the file");
  v("board", r.board, "the robot's board");
  v("budget", r.budget, "limits of the chip's resources that firmware may use", {.presence = kOptional});
  v("outline", r.outline_mm, "corners of the outline, each `[forward, left]` of the axle's centre",
    {.unit = "mm"});
  v("track", r.track_mm, "distance between the contact points of the left and right wheel",
    {.unit = "mm", .presence = kOptional});
  v("wheel", r.wheel_mm, "diameter of a wheel", {.unit = "mm", .presence = kOptional});
  v("steering", r.steering, "wheels that a servo steers, with the values of the robot's file, without spread",
    {.presence = kOptional});
  v("sensors", r.sensors, "sensors that look at the floor");
  v("gauges", r.gauges, "readings that are numbers with a unit; other readings are levels, or on and off",
    {.presence = kOptional});
  v("parts", r.parts, "all parts, with their pins");
  v("text", r.text,
    "the robot's file, merged with the files of its base robots; only if the request has `full`",
    {.presence = when(!r.text.empty())});
}

}  // namespace robosim::wire
