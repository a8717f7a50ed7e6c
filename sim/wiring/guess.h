// From what is known of a sketch's pins to the parts of a robot that would fit.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "sim/wiring/clues.h"

namespace robosim::wiring {

/// A part of the draft.
struct PartDraft {
  std::string name;
  std::string type;
  std::vector<std::pair<std::string, std::string>> keys;  ///< as TOML writes them, in their order
  std::string why;                                        ///< what the guess rests on: "ENA, IN1, IN2"
  std::vector<std::string> doubts;                        ///< sentences for the person
};

/// What neither names nor a run without the part can tell. All of it can be tried out.
struct Ways {
  bool black_low = false;    ///< sensors read low over black
  bool other_order = false;  ///< the first sensor is the rightmost
  bool other_sides = false;  ///< the motors are the other way round
  bool close = false;        ///< two sensors are both on the line, not to the sides of it
};

/// Which of the Ways make a difference for this sketch.
struct Open {
  bool black = false;
  bool order = false;
  bool sides = false;
  bool distance = false;  ///< between two sensors
};

struct RobotDraft {
  std::string base;  ///< a stock robot, of which chassis and motors are taken
  std::string board;
  std::string driver;   ///< a chip
  std::string standby;  ///< its pin, as TOML; empty = none
  std::vector<PartDraft> parts;
  std::vector<std::string> questions;  ///< about pins that no part was found for
  Open open;
};

RobotDraft guess(const BoardSpec& board, const SketchNames& names, const PinHistory& history,
                 const Ways& ways);

// The guess, a kind of part after the other; each takes the pins that it has found parts for.

/// What a library is given: servos, distance sensors, displays, serial modules, encoders.
void guess_by_libraries(Clues& clues, RobotDraft& draft);
/// Motors on the shields that have libraries of their own, and devices on the two-wire bus.
void guess_shields(Clues& clues, const Ways& ways, RobotDraft& draft);
void guess_motors(Clues& clues, const Ways& ways, RobotDraft& draft);
void guess_sensors(Clues& clues, const Ways& ways, RobotDraft& draft);
/// Buttons, encoders, LEDs, buzzers; and a question about each pin that is left.
void guess_the_rest(Clues& clues, RobotDraft& draft);

/// A name for a part from the sketch's: letters, digits, `_` and `-`, and no other part's.
std::string part_name(const RobotDraft& draft, const std::string& wanted);

}  // namespace robosim::wiring
