// The files of the folder that a page may write: sketches, finished images, robots and maps, by name. Nothing
// else is written, nowhere else, and nothing over what is there unless that is said.
#pragma once

#include <string>

#include "sim/serve/folder.h"

namespace robosim::serve {

/// What a page wants to keep.
struct Offered {
  /// "Mine.ino", "Mine.hex", "robot.toml" or "hall.map", or a map of Choices: "./floors/hall.map"
  std::string name;
  std::string text;      ///< of an image its bytes
  bool replace = false;  ///< what is there
};
/// Reads the JSON of a request. Throws InputError.
Offered read_offered(const std::string& json);

/// Nothing is written: there is one already.
struct IsThere {
  std::string sentence;
};

/// Keeps it; a sketch Mine.ino is in a folder Mine. Gives its place in the folder, "./Mine/Mine.ino". Throws
/// InputError for other names, for what is no text, and for a map that is none.
std::string keep(const HeldFolder& folder, const Offered& offered);

/// The text of a map of Choices. Throws InputError.
std::string map_text(const HeldFolder& folder, const std::string& name);

/// The floor of a map's text, as JSON (docs/reference/recordings.md). Throws InputError with the map reader's
/// sentence.
std::string floor_of(const Offered& map);

}  // namespace robosim::serve
