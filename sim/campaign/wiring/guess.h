// Guesses the parts of a robot from the facts about a sketch's pins.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "sim/campaign/wiring/pin_evidence.h"

namespace robosim::wiring {

/// A part of the draft.
struct PartDraft {
  std::string name;
  std::string type;
  std::vector<std::pair<std::string, std::string>> keys;  ///< in their order, as written in TOML
  std::string why;                                        ///< the evidence: "ENA, IN1, IN2"
  std::vector<std::string> doubts;                        ///< questions to the user
  std::vector<std::string> notes = {};                    ///< evidence for the user
};

/// Possible differences from the first guess. The names in the source may leave them open. A run on a robot
/// without its sensors and motors does not reveal them. A caller can try all combinations.
struct Ways {
  bool black_low = false;       ///< sensors read low over black
  bool close = false;           ///< two sensors are both on the line, not on both sides of it
  bool other_order = false;     ///< the first sensor is the rightmost
  bool other_sides = false;     ///< the motors are swapped
  bool left_reversed = false;   ///< the left motor turns the other way
  bool right_reversed = false;  ///< the right motor turns the other way
  bool strong_driver = false;   ///< the driver is a tb6612, which drops less voltage than an l298n
  bool low_battery = false;     ///< the motors' supply has 6 V instead of 7.4 V

  bool operator==(const Ways&) const = default;
};

/// A member of Ways, with its words for the user.
struct Way {
  bool Ways::*is;
  const char* words;
};
/// The remark in a draft about a key whose value trials have decided.
inline constexpr const char* kByTrial = "chosen by trials: with this, the sketch follows the line further";
inline constexpr Way kWays[] = {
    {&Ways::black_low, "black reads LOW"},
    {&Ways::close, "both sensors on the line"},
    {&Ways::other_order, "the first sensor at the right"},
    {&Ways::other_sides, "motors swapped"},
    {&Ways::left_reversed, "left motor reversed"},
    {&Ways::right_reversed, "right motor reversed"},
    {&Ways::strong_driver, "driver tb6612"},
    {&Ways::low_battery, "battery 6 V"},
};

struct RobotDraft {
  std::string base;  ///< a stock robot that provides chassis and motors
  std::string board;
  std::vector<std::string> notes;  ///< sentences about the runs
  std::string board_doubt;         ///< question about the board; empty = none
  std::string driver;              ///< the motor driver's chip
  std::string standby;             ///< standby pin, as TOML; empty = none
  std::string supply;              ///< voltage of the motors' supply, as TOML; empty = that of the base
  std::vector<PartDraft> parts;
  std::vector<std::string> questions;  ///< questions about pins without a part
  Ways ways;                           ///< the ways of this draft
  Ways open;  ///< true = the sketch leaves this way open, and the way affects the robot's behaviour
};

RobotDraft guess(const BoardSpec& board, const SketchNames& names, const PinHistory& history,
                 const Ways& ways);

// The next functions each guess one kind of part, and mark the pins of the found parts as taken.

/// Guesses parts by libraries: servos, distance sensors, displays, serial modules, encoders.
void guess_by_libraries(Evidence& evidence, RobotDraft& draft);
/// Guesses motors on shields that have their own libraries, and devices on the two-wire bus.
void guess_shields(Evidence& evidence, const Ways& ways, RobotDraft& draft);
void guess_motors(Evidence& evidence, const Ways& ways, RobotDraft& draft);
void guess_sensors(Evidence& evidence, const Ways& ways, RobotDraft& draft);
/// Guesses buttons, encoders, LEDs and buzzers. Adds a question about each remaining pin.
void guess_the_rest(Evidence& evidence, RobotDraft& draft);

/// Adds the keys of an encoder. Without a known side, the draft's first encoder is at the left wheel.
void add_wheel_and_periods(const RobotDraft& draft, Side side, PartDraft& encoder);

/// Returns a part's name, made from the letters, digits and `_` of `wanted`. It differs from the names of
/// other parts.
std::string part_name(const RobotDraft& draft, const std::string& wanted);

}  // namespace robosim::wiring
