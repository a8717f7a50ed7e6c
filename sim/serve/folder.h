// What there is to choose from: the sketches, robots and maps of the folder that is served, and ours. A
// request names one of these; it never is a path.
#pragma once

#include <string>
#include <vector>

#include "sim/base/file_scope.h"

namespace robosim::serve {

struct Choices {
  /// As `robosim run` takes them in the folder: "./Sketch" for its own, "PidFollower" for ours. Its own come
  /// first.
  std::vector<std::string> sketches, robots, maps;
};

/// Looks at the folder anew, three levels deep. Hidden ones are left out, and what a symbolic link leads out
/// of it to. At most 500 of each.
Choices choices_in(const HeldFolder& folder);
/// Whether it is firmware for a chip, that something else has built.
bool is_image(const std::string& name);

}  // namespace robosim::serve
