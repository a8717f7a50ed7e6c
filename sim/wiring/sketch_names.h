// What a sketch's source says of its pins: the names it gives them, and the libraries that it gives them to.
// Read, not compiled: what stands here are hints, and a run says what the sketch does.
#pragma once

#include <string>
#include <vector>

#include "hal/board/board_spec.h"
#include "sim/build/source.h"

namespace robosim::wiring {

/// Where in the sketch.
struct Spot {
  std::string file;
  int line = 0;
};

/// A constant, or an array of them, that is used as a pin: `const int ENA = 5;`, `#define S1 A0`.
struct Named {
  std::string name;
  std::vector<Pin> pins;  ///< of an array in its order
  bool is_array = false;
  bool sure = true;  ///< a function of pins takes it; else it is only handed on, and may be any number
  Spot spot;
};

/// Pins that a library, or a class of the sketch's own, is given: `NewPing sonar(12, 11, 200);`,
/// `pan.attach(9);`.
struct Given {
  std::string type;       ///< "NewPing", "Servo"; of a function its name: "attachInterrupt"
  std::string name;       ///< of the object: "sonar"; may be empty
  std::vector<Pin> pins;  ///< of each argument; all of one that is an array; kNoPin where it cannot be one
  std::vector<std::string> arguments;  ///< all, as they are written
  Spot spot;
  std::vector<std::vector<Pin>> each = {};  ///< pins of each argument; empty where it cannot be one
};

struct SketchNames {
  std::vector<Named> named;
  std::vector<Given> given;
};

SketchNames read_names(const build::Sketch& sketch, const BoardSpec& board);
/// The same of one file's text, for tests.
SketchNames names_in_text(const std::string& text, const std::string& file, const BoardSpec& board);

}  // namespace robosim::wiring
