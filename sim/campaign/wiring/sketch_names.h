// Searches a sketch's source for pins: their names, and the libraries that use them. The source is not
// compiled. The results are therefore hints, and only a run shows the sketch's behaviour.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "hal/board/board_spec.h"
#include "sim/build/source.h"
#include "sim/campaign/wiring/line_level.h"
#include "sim/campaign/wiring/pin_blocks.h"

namespace robosim::wiring {

/// A place in the sketch.
struct Spot {
  std::string file;
  int line = 0;
};

/// A constant, or an array of constants, that is used as a pin: `const int ENA = 5;`, `#define S1 A0`.
struct Named {
  std::string name;
  std::vector<Pin> pins;  ///< in the order of the array
  bool is_array = false;
  bool sure = true;  ///< the name is passed to a pin function; otherwise its value may be any number
  Spot spot;
};

/// Pins passed to a library, or to a class of the sketch: `NewPing sonar(12, 11, 200);`, `pan.attach(9);`.
struct Given {
  std::string type;                    ///< "NewPing", "Servo"; for a function, its name: "attachInterrupt"
  std::string name;                    ///< the object's name: "sonar"; may be empty
  std::vector<Pin> pins;               ///< pins of all arguments, arrays expanded; kNoPin if not a pin
  std::vector<std::string> arguments;  ///< all arguments, as in the source
  Spot spot;
  std::vector<std::vector<Pin>> each = {};  ///< pins of each argument; empty if it is not a pin
};

struct SketchNames {
  bool reads_levels = false;  ///< the source calls digitalRead(), pulseIn() or attachInterrupt()
  bool reads_ports = false;   ///< the source names input registers, such as PINC
  std::vector<Named> named;
  std::vector<Given> given;
  /// Pins of interrupts on FALLING that only set a flag.
  std::vector<Pin> flag_interrupts = {};
  /// Characters with which the sketch compares its serial input.
  std::vector<char> serial_keys = {};
  std::string serial_object = {};  ///< object that provides the serial input: "Serial"; empty = none
  std::vector<PinBlock> blocks = {};
  std::optional<StatedLevel> level = {};  ///< level of a line sensor over black
  /// Words of the comments next to the declaration of a pin, or next to its pinMode().
  std::map<Pin, std::vector<std::string>> remarks = {};
};

SketchNames read_names(const build::Sketch& sketch, const BoardSpec& board);
/// Returns whether a name means a count or a limit, in the languages of published sketches.
bool is_quantity(const std::string& name);
/// A board with an AVR chip, and a question about it.
struct GuessedBoard {
  const BoardSpec* board = nullptr;
  std::string doubt;  ///< empty if a comment of the sketch names the board
};

/// Returns a board that has all pins of the sketch's calls, such as digitalRead(A6). Prefers the board that a
/// comment names, then the first such AVR board. If that board has no PWM on the pins of analogWrite(), a
/// larger board may replace it. If no board has all pins, returns the first AVR board.
GuessedBoard board_for(const build::Sketch& sketch);
/// Reads one file's text, for tests.
SketchNames names_in_text(const std::string& text, const std::string& file, const BoardSpec& board);

}  // namespace robosim::wiring
