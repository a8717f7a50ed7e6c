// Declares the readers of the different kinds of project files. read_project() (project.h) selects a reader.
#pragma once

#include "sim/build/project/project.h"

namespace robosim::project {

/// The maximum size of a project file.
constexpr std::size_t kMostProjectFile_bytes = std::size_t{1} << 20;

Project read_platformio(const std::filesystem::path& folder, const std::string& environment);
Project read_sketch_yaml(const std::filesystem::path& file, const std::string& profile);

/// Throws the error for an unknown environment or profile.
[[noreturn]] void refuse_environment(const std::filesystem::path& file, const std::string& what,
                                     const std::string& name, const std::vector<std::string>& all);

}  // namespace robosim::project
