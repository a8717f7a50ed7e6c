// Reads a robot file and merges it with its bases into one tree. The derived file overrides its base key by
// key in [chassis], [motors], [driver], [budget] and [electronics]. It overrides parts by name.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "sim/base/config.h"
#include "sim/robot/description.h"

namespace robosim::robot {

struct RobotSource {
  ConfigValue tree;
  std::vector<SourceText> texts;  ///< texts of the file, then of its bases
  /// For each base file, the place of the key `base` that names it.
  std::map<std::string, Place> based_on;
};

/// Returns all texts, concatenated.
std::string bytes_of(const RobotSource& source);

/// Returns "uno5.toml:12"; for a place in a base "uno5.toml:12, which my.toml:1 extends".
std::string place_text(const RobotSource& source, const Place& place);

/// Reads a robot with its bases. Throws InputError for text that is not TOML, a missing base, an unknown part
/// in `remove`, or more than 8 bases.
RobotSource read_source(std::string_view text, const std::filesystem::path& file);

/// Returns the string value of a key in a table; empty if the table has no string with this key.
std::string text_of(const ConfigValue& table, const char* key);

}  // namespace robosim::robot
