// A robot file with the robots that it is based on, as one tree: what the derived file says goes before what
// its base says, key by key in [chassis], [motors], [driver] and [budget], part by part by their names.
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
  std::vector<SourceText> texts;  ///< the file's own, then those of its bases
  /// Of each base where it is named: by "base" of the file that is based on it.
  std::map<std::string, Place> based_on;
};

/// All texts, one behind the other.
std::string bytes_of(const RobotSource& source);

/// "uno5.toml:12", and of a place in a base "uno5.toml:12, which my.toml:1 extends".
std::string place_text(const RobotSource& source, const Place& place);

/// Throws InputError: no TOML; a base that is not there, or more than 8 of them; a part to remove that there
/// is not.
RobotSource read_source(std::string_view text, const std::filesystem::path& file);

/// The text that a key of a table has; empty if it has none.
std::string text_of(const ConfigValue& table, const char* key);

}  // namespace robosim::robot
