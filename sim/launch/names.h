// Names that users type, and the files they refer to.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "sim/build/sketch.h"
#include "sim/project/project.h"

namespace robosim::launch {

/// A name with '/' or '.' is a path.
bool is_path(const std::string& name);
/// A path that begins at `folder`. It stays a path, "./Mine", where no folder is left before it.
std::string path_from(const std::filesystem::path& folder, const std::string& word);

/// Names of the files with that ending in a folder, without the ending, sorted; none if there is no such
/// folder.
std::vector<std::string> names_in(const std::filesystem::path& folder, const std::string& ending);

std::filesystem::path stock_robot_folder();
std::filesystem::path stock_map_folder();

/// A choice that was made for the user, and the sentence that says so (empty if the user made it).
struct Choice {
  std::string name;  ///< for people and for `inputs`: not a path of this machine, unless the user typed it
  std::filesystem::path path;  ///< what to open; for a robot what a runner takes: a name, too, or with @BOARD
  std::string announcement;
  const BoardSpec* board = nullptr;  ///< of a robot: that its project is for; null = the robot's own
  std::string board_said;            ///< where that is said: "platformio.ini's uno"
};

/// What is to run, and the folder it stands in. No name: the current folder. Throws InputError.
struct SketchChoice {
  std::string name;
  std::filesystem::path path;
  std::filesystem::path folder;
  std::string
      elf_target;  ///< of a finished .elf or .hex, the target that it is for; else empty: it must be built
  project::Project project;  ///< what platformio.ini or sketch.yaml say
};
/// `environment`: of platformio.ini, or the profile of sketch.yaml; empty = their choice. A folder that
/// arduino-cli has built in is the image in it.
SketchChoice choose_sketch(const std::string& name, const std::string& environment = {});
/// What people are shown of it: its name, or its folder's where that is `.` or `..`.
std::string title_of(const SketchChoice& sketch);

/// The map named; else the only .map in the sketch's folder; else `oval`. Throws InputError.
Choice choose_map(const std::string& name, const std::filesystem::path& sketch_folder);

/// What is compiled of a sketch, as its project says; `libraries` are the user's, and come first.
build::Request request_of(const SketchChoice& sketch, const BoardSpec& board, const std::string& target,
                          const std::vector<std::string>& libraries);

/// Sentences on its project: what was chosen of it, and which of the libraries that it wants by name are not
/// found, or have another version.
std::vector<std::string> remarks_on_project(const SketchChoice& sketch,
                                            const std::vector<std::string>& libraries);

/// The robot named (sim/base/robot_name.h); else robot.toml in the sketch's folder; else a stock robot with
/// `board`; else uno5, or bluepill5 for the target stm32. Throws InputError.
Choice choose_robot(const std::string& name, const std::filesystem::path& sketch_folder,
                    const std::string& target = "host", const BoardSpec* board = nullptr);

/// The same for a sketch: on the board of its project, unless `name` has another behind an @. Throws
/// InputError for a board that Robosim does not have.
Choice choose_robot(const std::string& name, const SketchChoice& sketch, const std::string& target);

/// The target named; else that of a finished .elf; else `host`. Throws InputError for one that there is none
/// of, or that a finished .elf is not for.
std::string choose_target(const std::string& name, const SketchChoice& sketch);

/// Throws InputError for a target there is none of, ToolMissing for one that this version cannot run yet.
void check_target(const std::string& target);
/// The same for targets that sketches are compiled for.
void check_build_target(const std::string& target);

/// Where `check` throws an InputError, this throws one that also names the flag that it is about.
void name_flag(const std::string& flag, const std::function<void()>& check);

}  // namespace robosim::launch
