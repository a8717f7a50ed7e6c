// Lists the choices: the sketches, robots and maps of the served folder, and those that come with Robosim. A
// request names one of these choices, never a path.
#pragma once

#include <string>
#include <vector>

#include "sim/base/file_scope.h"

namespace robosim::serve {

struct Choices {
  /// Names for `robosim run` in the folder: first the folder's own, such as "./Sketch", then those that come
  /// with Robosim, such as "PidFollower".
  std::vector<std::string> sketches, robots, maps;
};

/// Reads the folder on each call, three levels deep. Skips hidden files, and does not follow symbolic links
/// out of the folder. Returns at most 500 names of each kind.
Choices choices_in(const HeldFolder& folder);
/// Returns whether a file with this name is firmware for a chip, built by another tool (.hex or .elf).
bool is_image(const std::string& name);

}  // namespace robosim::serve
