// A robot file merged with its bases, as one tree. The derived file overrides its base key by key in
// [chassis], [motors], [driver], [budget] and [electronics]. It overrides parts by name.
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
  /// The place that names each base: the key `base` of the derived file.
  std::map<std::string, Place> based_on;
};

/// Returns all texts, concatenated.
std::string bytes_of(const RobotSource& source);

/// Returns "uno5.toml:12"; for a place in a base "uno5.toml:12, which my.toml:1 extends".
std::string place_text(const RobotSource& source, const Place& place);

/// Reads a robot with its bases. Throws InputError for text that is not TOML, a missing base, an unknown part
/// in `remove`, or more than 8 bases.
RobotSource read_source(std::string_view text, const std::filesystem::path& file);

/// Returns the text of a key in a table; empty if the table has no such text.
std::string text_of(const ConfigValue& table, const char* key);

}  // namespace robosim::robot
