// Finds the files for the names that users type.
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
/// Prefixes a relative path with `folder`. Returns an absolute path unchanged. The result is always a path
/// for is_path(), such as "./Mine".
std::string path_from(const std::filesystem::path& folder, const std::string& word);

/// Returns the names of a folder's files with this ending, sorted and without the ending. Returns nothing if
/// the folder does not exist.
std::vector<std::string> names_in(const std::filesystem::path& folder, const std::string& ending);

std::filesystem::path stock_robot_folder();
std::filesystem::path stock_map_folder();

/// A choice by the user, or an automatic choice. `announcement` is a sentence about an automatic choice. It
/// is empty if the user has chosen.
struct Choice {
  std::string name;  ///< for messages and RunInputs; a path of this machine only if the user typed it
  std::filesystem::path path;  ///< file to open; for a robot, the name for the runner, perhaps with @BOARD
  std::string announcement;
  bool is_doubtful = false;          ///< several files fit, so users must see the announcement
  const BoardSpec* board = nullptr;  ///< for a robot, the board of the project; null = the robot's own board
  std::string board_said;            ///< reports that board's source: "platformio.ini names the board uno"
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
/// platformio.ini, or a profile of sketch.yaml; empty = the file's default. If `untrusted`, first checks that
/// no link leads out of the folder. Throws InputError.
SketchChoice choose_sketch(const std::string& name, const std::string& environment = {},
                           bool untrusted = false);
/// Returns the sketch's name for messages, without slashes at its end. For `.` or `..`, returns the name of
/// the folder.
std::string title_of(const SketchChoice& sketch);
std::string title_of(const std::string& name, const std::filesystem::path& folder);

/// Returns the named map. Without a name, returns the only .map in the sketch's folder. If there is not
/// exactly one, returns `oval`. Throws InputError.
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
/// folder, or else a stock robot: bluepill5 for the target stm32, otherwise the robot with `board` or uno5.
/// Throws InputError.
Choice choose_robot(const std::string& name, const std::filesystem::path& sketch_folder,
                    const std::string& target = "host", const BoardSpec* board = nullptr);

/// Returns the robot for a sketch, with the board that the sketch's project specifies. A board after an @ in
/// `name` takes precedence. Throws InputError for a board that Robosim does not have.
Choice choose_robot(const std::string& name, const SketchChoice& sketch, const std::string& target);

/// Returns the named target. Without a name, returns the target of a finished .elf, or else `host`. Throws
/// InputError for an unknown target, or if a finished .elf is for another target.
std::string choose_target(const std::string& name, const SketchChoice& sketch);

/// Throws InputError for an unknown target, and ToolMissing for a target that this version cannot run yet.
void check_target(const std::string& target);
/// Checks that this version can compile sketches for a target. Throws the exceptions of check_target().
void check_build_target(const std::string& target);

/// Runs `check`, and adds the name of the flag to its InputError.
void name_flag(const std::string& flag, const std::function<void()>& check);

}  // namespace robosim::launch
