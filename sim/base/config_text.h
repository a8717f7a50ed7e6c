// TOML again, of a tree that was read from it and may have been put together from several files.
#pragma once

#include <string>

#include "sim/base/config.h"

namespace robosim {

/// What parse_toml() reads as the same tree: single keys first, then tables, then arrays of tables. Behind
/// each line that is not from `file` a comment says where it is from: "# uno5.toml:12".
std::string to_toml(const ConfigValue& tree, const std::string& file);

}  // namespace robosim
