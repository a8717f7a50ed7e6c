// Finds the comments that describe pins: `const int m1 = 5;  // left motor`.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "sim/campaign/wiring/sketch_names.h"
#include "sim/campaign/wiring/source_blocks.h"

namespace robosim::wiring {

/// Returns the words of the comments next to the declaration of a pin, or next to its pinMode(). Without such
/// a comment, returns the words of a short comment above a group of declarations. Such groups only count if
/// both sides have one.
std::map<Pin, std::vector<std::string>> remarks_of(const SketchNames& names,
                                                   const std::vector<SourceText>& sources);

}  // namespace robosim::wiring
