// Lists the choices: the sketches, robots and maps of the served folder, and Robosim's own. A request names
// one of these; it is never a path.
#pragma once

#include <string>
#include <vector>

#include "sim/base/file_scope.h"

namespace robosim::serve {

struct Choices {
  /// Names as for `robosim run` in the folder: "./Sketch" for its own, "PidFollower" for Robosim's. Its own
  /// come first.
  std::vector<std::string> sketches, robots, maps;
};

/// Reads the folder again, three levels deep. Skips hidden files, and those outside of it to which a symbolic
/// link leads. At most 500 of each.
Choices choices_in(const HeldFolder& folder);
/// Returns whether it is firmware for a chip, built by another tool.
bool is_image(const std::string& name);

}  // namespace robosim::serve
