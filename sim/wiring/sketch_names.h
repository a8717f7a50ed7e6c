// Reads a sketch's source for its pins: their names, and the libraries that get them. The source is not
// compiled: these are hints, and a run shows the sketch's behaviour.
#pragma once

#include <string>
#include <vector>

#include "hal/board/board_spec.h"
#include "sim/build/source.h"

namespace robosim::wiring {

/// A place in the sketch.
struct Spot {
  std::string file;
  int line = 0;
};

/// A constant, or an array of them, that is used as a pin: `const int ENA = 5;`, `#define S1 A0`.
struct Named {
  std::string name;
  std::vector<Pin> pins;  ///< of an array in its order
  bool is_array = false;
  bool sure = true;  ///< an argument of a function of pins; else it is only passed on, and may be any number
  Spot spot;
};

/// Pins passed to a library, or to a class of the sketch: `NewPing sonar(12, 11, 200);`, `pan.attach(9);`.
struct Given {
  std::string type;                    ///< "NewPing", "Servo"; for a function its name: "attachInterrupt"
  std::string name;                    ///< of the object: "sonar"; may be empty
  std::vector<Pin> pins;               ///< of each argument; all of an array; kNoPin if it cannot be one
  std::vector<std::string> arguments;  ///< all, as in the source
  Spot spot;
  std::vector<std::vector<Pin>> each = {};  ///< pins of each argument; empty if it cannot be one
};

struct SketchNames {
  std::vector<Named> named;
  std::vector<Given> given;
};

SketchNames read_names(const build::Sketch& sketch, const BoardSpec& board);
/// Reads one file's text, for tests.
SketchNames names_in_text(const std::string& text, const std::string& file, const BoardSpec& board);

}  // namespace robosim::wiring
