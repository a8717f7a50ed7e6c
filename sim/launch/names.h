// Resolves names that users type to files.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "sim/build/sketch.h"
#include "sim/project/project.h"

namespace robosim::launch {

/// Returns whether a name is a path: it contains '/' or '.'.
bool is_path(const std::string& name);
/// Returns a path relative to `folder`. It remains a path, "./Mine", even if no folder is left in it.
std::string path_from(const std::filesystem::path& folder, const std::string& word);

/// Returns the names of the files with that ending in a folder, without the ending, sorted; none if there is
/// no such folder.
std::vector<std::string> names_in(const std::filesystem::path& folder, const std::string& ending);

std::filesystem::path stock_robot_folder();
std::filesystem::path stock_map_folder();

/// An automatic choice, and the sentence that reports it (empty if the user made it).
struct Choice {
  std::string name;  ///< for messages and `inputs`: not a path of this machine, unless the user typed it
  std::filesystem::path path;  ///< the file to open; for a robot a runner's name: also with @BOARD
  std::string announcement;
  const BoardSpec* board = nullptr;  ///< for a robot: its project's board; null = the robot's own
  std::string board_said;            ///< the source of that board: "platformio.ini's uno"
};

/// A sketch to run, and its folder. Without a name: the current folder. Throws InputError.
struct SketchChoice {
  std::string name;
  std::filesystem::path path;
  std::filesystem::path folder;
  std::string elf_target;    ///< for a finished .elf or .hex, its target; else empty: it must be built
  project::Project project;  ///< the settings of platformio.ini or sketch.yaml
};
/// `environment`: of platformio.ini, or the profile of sketch.yaml; empty = their choice. A folder that
/// arduino-cli has built in is the image in it. `untrusted`: no link in the folder leads out of it, which is
/// checked before any file is read.
SketchChoice choose_sketch(const std::string& name, const std::string& environment = {},
                           bool untrusted = false);
/// Returns the name that users are shown, without slashes at its end: the sketch's name, or that of its
/// folder if it is `.` or `..`.
std::string title_of(const SketchChoice& sketch);
std::string title_of(const std::string& name, const std::filesystem::path& folder);

/// Returns the named map; else the only .map in the sketch's folder; else `oval`. Throws InputError.
Choice choose_map(const std::string& name, const std::filesystem::path& sketch_folder);

/// Returns the build request for a sketch, by its project; the user's `libraries` come first.
build::Request request_of(const SketchChoice& sketch, const BoardSpec& board, const std::string& target,
                          const std::vector<std::string>& libraries);

/// Returns sentences on its project: the settings that were chosen, and libraries that it names but that are
/// missing, or have another version.
std::vector<std::string> remarks_on_project(const SketchChoice& sketch,
                                            const std::vector<std::string>& libraries);

/// Returns the named robot (sim/base/robot_name.h); else robot.toml in the sketch's folder; else a stock
/// robot with `board`; else uno5, or bluepill5 for the target stm32. Throws InputError.
Choice choose_robot(const std::string& name, const std::filesystem::path& sketch_folder,
                    const std::string& target = "host", const BoardSpec* board = nullptr);

/// Returns the robot for a sketch: on the board of its project, unless `name` has another one after an @.
/// Throws InputError for a board that Robosim does not have.
Choice choose_robot(const std::string& name, const SketchChoice& sketch, const std::string& target);

/// Returns the named target; else that of a finished .elf; else `host`. Throws InputError for an unknown one,
/// or one that a finished .elf is not for.
std::string choose_target(const std::string& name, const SketchChoice& sketch);

/// Throws InputError for an unknown target, ToolMissing for one that this version cannot run yet.
void check_target(const std::string& target);
/// Checks a target that sketches are compiled for. Throws as check_target() does.
void check_build_target(const std::string& target);

/// Runs `check`, and adds the flag's name to its InputError.
void name_flag(const std::string& flag, const std::function<void()>& check);

}  // namespace robosim::launch
