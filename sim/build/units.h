// The units of one build: what is compiled of a sketch and its libraries, where it is found, and what it is
// called.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/build/compile.h"
#include "sim/build/libraries.h"
#include "sim/build/source.h"
#include "sim/build/toolchain.h"

namespace robosim::build {

/// A unit of the sketch, still without a source.
Unit sketch_unit(const Sketch& sketch);
Unit library_unit(const Toolchain& toolchain, const Library& library, const std::string& source);
/// What messages call the unit.
std::string name_of(const Sketch& sketch, const Unit& unit);
std::vector<std::filesystem::path> include_folders(const Unit& unit, const std::vector<Library>& libraries);
/// What debug information calls the folders.
Core::Names names_of_folders(const Sketch& sketch, const std::vector<Library>& libraries,
                             const Toolchain& toolchain, const std::filesystem::path& work);

}  // namespace robosim::build
