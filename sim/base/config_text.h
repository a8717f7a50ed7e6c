// Writes TOML from a parsed tree, which may combine several files.
#pragma once

#include <string>

#include "sim/base/config.h"

namespace robosim {

/// Returns text from which parse_toml() reads an equal tree: single keys first, then tables, then arrays of
/// tables. Each line that is not from `file` gets a comment with its origin: "# uno5.toml:12".
std::string to_toml(const ConfigValue& tree, const std::string& file);

}  // namespace robosim
