// Reads other tools' files about a project: Arduino's sketch.yaml, PlatformIO's platformio.ini, and the files
// that arduino-cli and PlatformIO write next to their results (docs/reference/sketches.md).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "hal/board/board_spec.h"
#include "sim/base/error.h"

namespace robosim::project {

/// A library that a project requires, by its name in library.properties.
struct WantedLibrary {
  std::string name;
  std::string version;  ///< empty = any
};

struct Project {
  std::filesystem::path file;  ///< empty = no file
  std::string environment;     ///< the selected environment or profile: "uno"; empty = none
  const BoardSpec* board = nullptr;
  const BoardSpec* stand_in = nullptr;  ///< if Robosim lacks the board: another board with the same chip
  std::string board_name;               ///< as in the file; empty = none
  Place board_place;
  bool platformio = false;
  std::filesystem::path sources;                ///< source folder of a PlatformIO project
  std::vector<std::filesystem::path> includes;  ///< folders for the sketch's headers
  std::vector<std::filesystem::path> libraries;
  std::vector<WantedLibrary> wanted;
  std::vector<std::string> flags;    ///< -D and -U, for everything that is compiled
  std::vector<std::string> remarks;  ///< sentences for the user: automatic choices, and ignored settings
};

/// Reads the project of a sketch's folder. `environment` names an environment of platformio.ini, or a profile
/// of sketch.yaml. If `environment` is empty, uses the file's default. Without a default, uses the first
/// environment with a known board, or else the first environment. Throws InputError for files that cannot be
/// read, and for an unknown environment.
Project read_project(const std::filesystem::path& folder, const std::string& environment = {});

/// Returns the project file of a finished image, and the board for which arduino-cli or PlatformIO built it.
Project project_of_image(const std::filesystem::path& image);

/// Returns the folder of the sketch from which arduino-cli or PlatformIO has built an image. The path is
/// empty if the folder no longer exists.
std::filesystem::path sketch_of_image(const std::filesystem::path& image);

/// Finds a board for an image whose board Robosim does not have. The found board has the same chip
/// ("atmega328p"), and the clock that the FQBN specifies, if any. Adds a remark. Does nothing if there is no
/// such board.
void find_stand_in(Project& project, const std::string& chip);

/// Throws InputError for a board that Robosim does not have and cannot substitute.
void check_board(const Project& project);

/// Returns the sketchbooks in the preferences of Arduino's IDE and in arduino-cli's configuration.
std::vector<std::filesystem::path> sketchbooks();

}  // namespace robosim::project
