// What other tools' files say of a project: Arduino's sketch.yaml, PlatformIO's platformio.ini, and what
// arduino-cli and PlatformIO write beside what they build (docs/reference/sketches.md).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "hal/board/board_spec.h"
#include "sim/base/error.h"

namespace robosim::project {

/// A library that a project wants, by library.properties's name.
struct WantedLibrary {
  std::string name;
  std::string version;  ///< empty = any
};

struct Project {
  std::filesystem::path file;  ///< empty: there is none
  std::string environment;     ///< which of its environments, or profiles: "uno"; empty = it has none
  const BoardSpec* board = nullptr;
  const BoardSpec* stand_in = nullptr;  ///< where there is no such board: one with the same chip
  std::string board_name;               ///< as the file writes it; empty = it names none
  Place board_place;
  bool platformio = false;
  std::filesystem::path sources;                ///< the folder of PlatformIO's sources
  std::vector<std::filesystem::path> includes;  ///< folders for the sketch's headers
  std::vector<std::filesystem::path> libraries;
  std::vector<WantedLibrary> wanted;
  std::vector<std::string> flags;    ///< -D and -U, for everything that is compiled
  std::vector<std::string> remarks;  ///< sentences for the user: what was chosen, what is not taken
};

/// The project of a sketch's folder. `environment`: of platformio.ini, or a profile of sketch.yaml; empty =
/// that which the file says, else the first whose board is known, else the first. Throws InputError for files
/// that cannot be read, and an environment that there is none of.
Project read_project(const std::filesystem::path& folder, const std::string& environment = {});

/// The same of a finished image: the board that arduino-cli or PlatformIO have built it for.
Project project_of_image(const std::filesystem::path& image);

/// The folder of the sketch that an image was built from by one of them, if it is still there; else empty.
std::filesystem::path sketch_of_image(const std::filesystem::path& image);

/// Of an image whose board Robosim does not have: finds one with the chip that it was built for
/// ("atmega328p") and the clock that an FQBN may name, and remarks it. Nothing where there is none.
void find_stand_in(Project& project, const std::string& chip);

/// Throws InputError for a board that Robosim does not have, and that has no stand-in.
void check_board(const Project& project);

/// The sketchbooks that the preferences of Arduino's IDE and arduino-cli's configuration name.
std::vector<std::filesystem::path> sketchbooks();

}  // namespace robosim::project
