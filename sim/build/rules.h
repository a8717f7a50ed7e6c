// What the file of a project adds to Arduino's rules (sim/project/project.h).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace robosim::build {

struct ProjectRules {
  /// Everything in this folder is the sketch, at any depth, with any number of .ino files; empty = as Arduino
  /// has it.
  std::filesystem::path sources;
  std::vector<std::filesystem::path> includes;  ///< folders that all but the core see
  std::vector<std::string> flags;               ///< -D and -U, for everything
};

}  // namespace robosim::build
