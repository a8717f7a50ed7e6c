// Resolves names that users type to files.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "sim/build/project/project.h"
#include "sim/build/sketch.h"

namespace robosim::launch {

/// Returns whether a name is a path: it contains '/' or '.'.
bool is_path(const std::string& name);
/// Returns a path relative to `folder`. The result is still a path, "./Mine", even if it contains no folder.
std::string path_from(const std::filesystem::path& folder, const std::string& word);

/// Returns the names of a folder's files with this ending, sorted and without the ending. Returns nothing if
/// the folder does not exist.
std::vector<std::string> names_in(const std::filesystem::path& folder, const std::string& ending);

std::filesystem::path stock_robot_folder();
std::filesystem::path stock_map_folder();

/// A choice by the user, or an automatic choice. `announcement` reports an automatic choice, and is else
/// empty.
struct Choice {
  std::string name;  ///< for messages and `inputs`; a path of this machine only if the user typed it
  std::filesystem::path path;  ///< the file to open; for a robot, the name for a runner, also with @BOARD
  std::string announcement;
  const BoardSpec* board = nullptr;  ///< for a robot, the board of its project; null = the robot's own board
  std::string board_said;            ///< source of that board: "platformio.ini's uno"
};

/// A sketch to run, and its folder.
struct SketchChoice {
  std::string name;
  std::filesystem::path path;
  std::filesystem::path folder;
  std::string elf_target;    ///< target of a finished .elf or .hex; empty = the sketch must be built
  project::Project project;  ///< settings of platformio.ini or sketch.yaml
};
/// Returns the named sketch; without a name, the sketch in the current folder. If a folder has no sketch but
/// exactly one image, for example from arduino-cli, returns the image. `environment` names an environment of
/// platformio.ini, or a profile of sketch.yaml; empty = their default. `untrusted`: before any file is read,
/// checks that no link leads out of the folder. Throws InputError.
SketchChoice choose_sketch(const std::string& name, const std::string& environment = {},
                           bool untrusted = false);
/// Returns the name to show to users, without slashes at its end. For `.` or `..`, this is the name of the
/// folder, and otherwise the sketch's name.
std::string title_of(const SketchChoice& sketch);
std::string title_of(const std::string& name, const std::filesystem::path& folder);

/// Returns the named map. Without a name, returns the only .map in the sketch's folder, or else `oval`.
/// Throws InputError.
Choice choose_map(const std::string& name, const std::filesystem::path& sketch_folder);

/// Returns the build request for a sketch, with the settings of its project. The user's `libraries` come
/// first.
build::Request request_of(const SketchChoice& sketch, const BoardSpec& board, const std::string& target,
                          const std::vector<std::string>& libraries);

/// Returns sentences on the sketch's project. They report the chosen settings, and required libraries that
/// are missing or have another version.
std::vector<std::string> remarks_on_project(const SketchChoice& sketch,
                                            const std::vector<std::string>& libraries);

/// Returns the named robot (sim/base/robot_name.h). Without a name, returns robot.toml in the sketch's
/// folder, or else a stock robot with `board`. If neither exists, returns uno5, or bluepill5 for the target
/// stm32. Throws InputError.
Choice choose_robot(const std::string& name, const std::filesystem::path& sketch_folder,
                    const std::string& target = "host", const BoardSpec* board = nullptr);

/// Returns the robot for a sketch, on the board of its project unless `name` contains another board after an
/// @. Throws InputError for a board that Robosim does not have.
Choice choose_robot(const std::string& name, const SketchChoice& sketch, const std::string& target);

/// Returns the named target. Without a name, returns the target of a finished .elf, or else `host`. Throws
/// InputError for an unknown target, or if a finished .elf is for another target.
std::string choose_target(const std::string& name, const SketchChoice& sketch);

/// Throws InputError for an unknown target, and ToolMissing for a target that this version cannot run yet.
void check_target(const std::string& target);
/// Checks a target for which sketches are compiled. Throws the exceptions of check_target().
void check_build_target(const std::string& target);

/// Runs `check`, and adds the name of the flag to its InputError.
void name_flag(const std::string& flag, const std::function<void()>& check);

}  // namespace robosim::launch
