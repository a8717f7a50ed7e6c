// Writes TOML from a parsed tree, which may combine several files.
#pragma once

#include <string>

#include "sim/base/config.h"

namespace robosim {

/// Returns text that parse_toml() reads as the same tree: single keys first, then tables, then arrays of
/// tables. A comment after each line that is not from `file` names its origin: "# uno5.toml:12".
std::string to_toml(const ConfigValue& tree, const std::string& file);

}  // namespace robosim
