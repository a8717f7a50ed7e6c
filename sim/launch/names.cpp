#include "sim/launch/names.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <sstream>
#include <system_error>
#include <utility>

#include "sim/base/did_you_mean.h"
#include "sim/base/elf/avr_device.h"
#include "sim/base/elf/elf_file.h"
#include "sim/base/elf/elf_target.h"
#include "sim/base/error.h"
#include "sim/base/file.h"
#include "sim/base/file_scope.h"
#include "sim/base/robot_name.h"
#include "sim/build/project.h"
#include "sim/build/source.h"
#include "sim/launch/client/runner.h"

namespace robosim::launch {
namespace fs = std::filesystem;

namespace {

bool is_one_of(const std::string& name, const std::vector<std::string>& names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Throws InputError if no build of Robosim has the target.
void check_exists(const std::string& target) {
  const std::vector<std::string> all{"host", "avr", "stm32"};
  if (!is_one_of(target, all)) throw InputError("--target: " + unknown_name("target", target, all));
}

bool has_sketch(const fs::path& folder) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (build::is_ino(entry.path())) return true;
  }
  return false;
}

bool is_there(const fs::path& path) {
  std::error_code error;
  return fs::exists(path, error);
}

void check_path(const std::string& what, const std::string& path) {
  check_in_scope(path);
  std::error_code error;
  if (fs::exists(path, error)) return;
  throw InputError({path, 0, 0}, "no such file (a " + what + " with / or . in its name is a path)");
}

/// Returns the first bytes of a regular file. Returns nothing for any other file, because a read from a pipe
/// would block.
std::string beginning_of(const fs::path& path) try {
  const Descriptor file = open_to_read(path);
  char buffer[4096];
  const ssize_t size = ::read(file.get(), buffer, sizeof buffer);
  return {buffer, static_cast<std::size_t>(std::max<ssize_t>(size, 0))};
} catch (const InputError&) {
  return "";
}

/// Returns the end of the message for an unknown map or robot. The text mentions the user's file of that
/// name, if it exists.
std::string file_hint(const std::string& name, const std::string& ending) {
  if (is_there(name + ending))
    return fmt::format("; to use the file in this folder, give {}{}", name, ending);
  return " (a name with / or . is a path)";
}

/// Returns whether a .map file is the memory map of a linker, not a map of a floor. Recognises the first
/// lines of GNU ld's map files.
bool is_linkers(const fs::path& map) {
  std::istringstream file(beginning_of(map));
  std::string first;
  while (first.empty() && std::getline(file, first)) {
  }
  for (const char* heading : {"Archive member included", "As-needed library included", "Discarded input",
                              "Allocating common symbols", "There are no discarded", "Memory Configuration"})
    if (first.starts_with(heading)) return true;
  return false;
}

}  // namespace

bool is_path(const std::string& name) { return name.find_first_of("/.") != std::string::npos; }

std::string path_from(const fs::path& folder, const std::string& word) {
  if (folder.empty() || fs::path(word).is_absolute()) return word;
  const std::string path = (folder / word).lexically_normal().string();
  return is_path(path) ? path : "./" + path;
}

std::vector<std::string> names_in(const fs::path& folder, const std::string& ending) {
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (entry.path().extension() == ending) names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

fs::path stock_robot_folder() {
  const fs::path installed = data_folder() / "robots";
  std::error_code error;
  return fs::is_directory(installed, error) ? installed : data_folder() / "sim/robot/stock";
}

fs::path stock_map_folder() { return data_folder() / "maps"; }

namespace {

/// Returns the image in a folder that contains exactly one image and nothing to build; otherwise empty.
fs::path image_in(const fs::path& folder) {
  if (has_sketch(folder)) return {};
  std::vector<fs::path> images;
  for (const std::string& name : names_in(folder, ".elf")) images.push_back(folder / (name + ".elf"));
  return images.size() == 1 ? images[0] : fs::path();
}

bool is_project(const fs::path& folder) { return is_there(folder / "platformio.ini"); }

void take_image(SketchChoice& choice) {
  choice.elf_target = "avr";
  choice.project = project::project_of_image(choice.path);
  if (choice.path.extension() == ".hex") return;
  std::string content = read_file(choice.path);
  choice.elf_target = target_of_elf(content, choice.path.string());
  if (choice.elf_target == "avr")
    project::find_stand_in(choice.project, avr_device(ElfFile(std::move(content), choice.path.string())));
}

}  // namespace

SketchChoice choose_sketch(const std::string& name, const std::string& environment, bool untrusted) {
  SketchChoice choice{name.empty() ? "." : name, {}, {}, {}, {}};
  const auto check_links = [&](const fs::path& folder) {
    if (untrusted) build::check_links(folder.empty() ? "." : folder);
  };
  if (name.empty()) {
    check_links(".");
    const fs::path image = is_project(".") ? fs::path() : image_in(".");
    if (!image.empty()) return choose_sketch(image.string(), {}, untrusted);
    if (!has_sketch(".") && !is_project(".")) {
      throw InputError(
          "the current folder has no sketch (a file that ends in .ino); name one, as in “robosim run "
          "PidFollower” (there are " +
          all_of(build::stock_sketches()) + ") or “robosim run my/Sketch”");
    }
    choice.path = fs::current_path();
  } else if (build::is_sketch_path(name)) {
    check_path("sketch", name);
    choice.path = name;
    std::error_code none;
    check_links(fs::is_directory(choice.path, none) ? choice.path : choice.path.parent_path());
    if (const fs::path image = is_project(name) ? fs::path() : image_in(name); !image.empty())
      choice.path = image;
    if (const fs::path ending = choice.path.extension(); ending == ".elf" || ending == ".hex")
      take_image(choice);
  } else {
    choice.path = build::find_sketch(name);
  }
  std::error_code error;
  choice.folder = fs::is_directory(choice.path, error) ? choice.path : choice.path.parent_path();
  if (choice.folder.empty()) choice.folder = ".";
  if (choice.elf_target.empty())
    choice.project =
        project::read_project(choice.folder == fs::current_path() ? "." : choice.folder, environment);
  else if (const fs::path sketch = project::sketch_of_image(choice.path);
           !sketch.empty() && !is_there(choice.folder / "robot.toml"))
    choice.folder = sketch;
  return choice;
}

std::string title_of(const std::string& name, const fs::path& folder) {
  if (name.find_first_not_of("./") != std::string::npos)
    return name.substr(0, name.find_last_not_of('/') + 1);
  std::error_code error;
  const std::string title = fs::canonical(folder, error).filename();
  return title.empty() ? name : title;
}

std::string title_of(const SketchChoice& sketch) { return title_of(sketch.name, sketch.folder); }

build::Request request_of(const SketchChoice& sketch, const BoardSpec& board, const std::string& target,
                          const std::vector<std::string>& libraries) {
  const project::Project& project = sketch.project;
  build::Request request{sketch.path, board, target};
  request.libraries.assign(libraries.begin(), libraries.end());
  request.libraries.insert(request.libraries.end(), project.libraries.begin(), project.libraries.end());
  request.rules = {project.sources, project.includes, project.flags};
  return request;
}

Choice choose_map(const std::string& name, const fs::path& sketch_folder) {
  if (is_path(name)) {
    check_path("map", name);
    return {name, name, ""};
  }
  if (!name.empty()) {
    const fs::path file = stock_map_folder() / (name + ".map");
    if (!is_there(file)) {
      throw InputError(unknown_name("map", name, names_in(stock_map_folder(), ".map")) +
                       file_hint(name, ".map"));
    }
    return {name, file, ""};
  }
  auto beside = names_in(sketch_folder, ".map");
  std::erase_if(beside, [&](const std::string& map) { return is_linkers(sketch_folder / (map + ".map")); });
  if (beside.size() == 1) {
    const std::string file = beside[0] + ".map";
    return {file, sketch_folder / file, fmt::format("the map is {}, the only one next to the sketch", file)};
  }
  const std::string why =
      beside.empty() ? "" : fmt::format(" ({} maps are next to the sketch)", beside.size());
  Choice oval{"oval", stock_map_folder() / "oval.map",
              "the map is oval" + why + "; choose another with --map"};
  oval.is_doubtful = !beside.empty();
  return oval;
}

namespace {

/// Returns the stock robot that has this board in its name, such as "mega5"; otherwise uno5.
std::string stock_robot_for(const BoardSpec* board) {
  std::string found = "uno5";
  if (!board) return found;
  const std::string begin = board->name;
  for (const std::string& name : names_in(stock_robot_folder(), ".toml"))
    if (name.rfind(begin, 0) == 0 && name.find_first_not_of("0123456789", begin.size()) == name.npos)
      found = name;
  return found;
}

}  // namespace

Choice choose_robot(const std::string& name, const SketchChoice& sketch, const std::string& target) {
  const bool named = !parse_robot_name(name).board.empty();
  if (!named) project::check_board(sketch.project);
  const BoardSpec* const board = named ? nullptr : sketch.project.board;
  const BoardSpec* const other = named ? nullptr : sketch.project.stand_in;
  Choice choice = choose_robot(name, sketch.folder, target, other ? other : board);
  choice.board = board;
  // A replacement board applies only to an automatically chosen stock robot. Any other robot has its own
  // board.
  const bool is_ours = name.empty() && !is_path(choice.path.string());
  if (other && is_ours) {
    choice.board = other;
    choice.board_said = fmt::format("the {} replaces the board", other->name);
  }
  if (board)
    choice.board_said = fmt::format("{} names the board {}", sketch.project.file.filename().string(),
                                    sketch.project.board_name);
  return choice;
}

Choice choose_robot(const std::string& name, const fs::path& sketch_folder, const std::string& target,
                    const BoardSpec* board) {
  const std::string robot_alone = parse_robot_name(name).robot;
  if (is_path(robot_alone)) {
    check_path("robot", robot_alone);
    return {name, name, ""};
  }
  if (!name.empty()) {
    if (!is_there(stock_robot_folder() / (robot_alone + ".toml"))) {
      throw InputError(unknown_name("robot", robot_alone, names_in(stock_robot_folder(), ".toml")) +
                       file_hint(robot_alone, ".toml"));
    }
    return {name, name, ""};
  }
  std::error_code error;
  if (fs::exists(sketch_folder / "robot.toml", error)) {
    return {"robot.toml", sketch_folder / "robot.toml", "the robot is robot.toml next to the sketch"};
  }
  const std::string robot = target == "stm32" ? "bluepill5" : stock_robot_for(board);
  return {
      robot, robot,
      "the robot is " + robot +
          "; choose another with --robot, or put a robot.toml next to the sketch (robosim wire drafts one)"};
}

std::string choose_target(const std::string& name, const SketchChoice& sketch) {
  const bool is_elf = !sketch.elf_target.empty();
  const std::string target = !name.empty() ? name : is_elf ? sketch.elf_target : "host";
  check_target(target);
  if (is_elf && target != sketch.elf_target) {
    throw wrong_target(sketch.name, sketch.elf_target, target);
  }
  return target;
}

void check_target(const std::string& target) {
  const auto& available = client::available_targets();
  if (is_one_of(target, available)) return;
  check_exists(target);
  throw ToolMissing(
      fmt::format("this build of Robosim cannot run the target {}: expected {}", target, one_of(available)));
}

void check_build_target(const std::string& target) {
  const auto available = build::targets();
  if (is_one_of(target, available)) return;
  check_exists(target);
  throw ToolMissing(fmt::format("this build of Robosim cannot compile for the target {}: expected {}", target,
                                one_of(available)));
}

void name_flag(const std::string& flag, const std::function<void()>& check) try {
  check();
} catch (const InputError& error) {
  throw InputError(error.place(), flag + ": " + error.message());
}

}  // namespace robosim::launch
