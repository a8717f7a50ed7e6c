// Creates the units of one build, which are the source files of a sketch and its libraries.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/build/compile.h"
#include "sim/build/libraries.h"
#include "sim/build/source.h"
#include "sim/build/toolchain.h"

namespace robosim::build {

/// Returns a unit of the sketch whose `source` is still empty.
Unit sketch_unit(const Sketch& sketch);
Unit library_unit(const Toolchain& toolchain, const Library& library, const std::string& source);
/// Returns the name of the unit in messages.
std::string name_of(const Sketch& sketch, const Unit& unit);
std::vector<std::filesystem::path> include_folders(const Unit& unit, const std::vector<Library>& libraries);
/// Returns the names of the folders in debug information.
Core::Names names_of_folders(const Sketch& sketch, const std::vector<Library>& libraries,
                             const Toolchain& toolchain, const std::filesystem::path& work);

}  // namespace robosim::build
