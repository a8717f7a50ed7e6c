// Defines the settings in a project file that extend Arduino's rules (sim/build/project/project.h).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace robosim::build {

struct ProjectRules {
  /// The folder whose files form the sketch: all files in the folder, at any depth, with any number of .ino
  /// files. Empty = Arduino's rules.
  std::filesystem::path sources;
  std::vector<std::filesystem::path> includes;  ///< folders for all units except the core
  std::vector<std::string> flags;               ///< -D and -U options for all units
};

}  // namespace robosim::build
