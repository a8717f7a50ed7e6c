// Saves the files that a page may write in the served folder: sketches, finished images, robots and maps.
// Writes nothing else, and replaces a file only on request.
#pragma once

#include <string>

#include "sim/view/serve/folder.h"

namespace robosim::serve {

/// A file that a page wants to save.
struct Offered {
  /// "Mine.ino", "Mine.hex", "robot.toml" or "hall.map"; or a map in Choices::maps: "./floors/hall.map"
  std::string name;
  std::string text;      ///< content; the bytes of an image
  bool replace = false;  ///< replaces an existing file
};
/// Parses the JSON of a request. Throws InputError.
Offered read_offered(const std::string& json);

/// Thrown before writing if the file already exists and Offered::replace is false.
struct IsThere {
  std::string sentence;
};

/// Saves the file. A sketch Mine.ino goes to a folder Mine. Returns the file's path in the served folder,
/// such as "./Mine/Mine.ino". Throws InputError for other names, for invalid text, and for an invalid map.
std::string keep(const HeldFolder& folder, const Offered& offered);

/// Returns the text of the map `name` in Choices::maps (folder.h). Throws InputError.
std::string map_text(const HeldFolder& folder, const std::string& name);

/// Returns the floor of a map's text, as JSON (docs/reference/recordings.md). Throws InputError with the map
/// reader's sentence.
std::string floor_of(const Offered& map);

}  // namespace robosim::serve
