// The settings of a project's file that extend Arduino's rules (sim/project/project.h).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace robosim::build {

struct ProjectRules {
  /// Everything in this folder is the sketch, at any depth, with any number of .ino files; empty = Arduino's
  /// rules.
  std::filesystem::path sources;
  std::vector<std::filesystem::path> includes;  ///< folders for all except the core
  std::vector<std::string> flags;               ///< -D and -U, for everything
};

}  // namespace robosim::build
