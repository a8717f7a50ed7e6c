#include "sim/launch/names.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>
#include <utility>

#include "sim/base/error.h"
#include "sim/base/file.h"
#include "sim/base/robot_name.h"
#include "sim/base/spelling.h"
#include "sim/build/sketch.h"
#include "sim/client/runner.h"
#include "sim/elf/elf_file.h"

namespace robosim::launch {
namespace fs = std::filesystem;

namespace {

bool is_one_of(const std::string& name, const std::vector<std::string>& names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// A target of this or a later version.
void check_exists(const std::string& target) {
  const std::vector<std::string> all{"host", "avr", "stm32"};
  if (!is_one_of(target, all)) throw InputError("--target: " + unknown_name("target", target, all));
}

bool has_sketch(const fs::path& folder) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (entry.path().extension() == ".ino") return true;
  }
  return false;
}

void check_path(const std::string& what, const std::string& path) {
  std::error_code error;
  if (fs::exists(path, error)) return;
  throw InputError({path, 0, 0}, "there is no such file (a " + what + " with / or . in its name is a path)");
}

}  // namespace

std::string target_of_elf(const fs::path& file) {
  std::string content = read_file(file);
  if (ElfFile::is_one(content)) {
    const ElfFile elf(std::move(content), file.string());
    if (elf.machine() == ElfFile::Machine::avr) return "avr";
    if (elf.machine() == ElfFile::Machine::arm && elf.bits() == 32) return "stm32";
  }
  throw InputError({file.string(), 0, 0},
                   "is no program for a chip that Robosim knows (an AVR or an ARM microcontroller)");
}

bool is_path(const std::string& name) { return name.find_first_of("/.") != std::string::npos; }

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

SketchChoice choose_sketch(const std::string& name) {
  SketchChoice choice{name.empty() ? "." : name, {}, {}};
  if (name.empty()) {
    if (!has_sketch(".")) {
      throw InputError(
          "the current folder holds no sketch (a file that ends with .ino); name one, as in “robosim run "
          "PidFollower” (there are " +
          all_of(build::stock_sketches()) + ") or “robosim run my/Sketch”");
    }
    choice.path = fs::current_path();
  } else if (is_path(name)) {
    check_path("sketch", name);
    choice.path = name;
    if (fs::path(name).extension() == ".elf") choice.elf_target = target_of_elf(name);
    if (fs::path(name).extension() == ".hex") choice.elf_target = "avr";
  } else {
    const auto stock = build::stock_sketches();
    if (std::find(stock.begin(), stock.end(), name) == stock.end()) {
      std::error_code error;
      const std::string hint = fs::exists(name, error)
                                   ? fmt::format("; for the one in this folder write ./{}", name)
                                   : " (a name with / or . is a path)";
      throw InputError(unknown_name("sketch of ours", name, stock) + hint);
    }
    choice.path = build::find_sketch(name);
  }
  std::error_code error;
  choice.folder = fs::is_directory(choice.path, error) ? choice.path : choice.path.parent_path();
  if (choice.folder.empty()) choice.folder = ".";
  return choice;
}

Choice choose_map(const std::string& name, const fs::path& sketch_folder) {
  if (is_path(name)) {
    check_path("map", name);
    return {name, name, ""};
  }
  const auto stock = names_in(stock_map_folder(), ".map");
  if (!name.empty()) {
    if (std::find(stock.begin(), stock.end(), name) == stock.end()) {
      throw InputError(unknown_name("map", name, stock) + " (a name with / or . is a path)");
    }
    return {name, stock_map_folder() / (name + ".map"), ""};
  }
  const auto beside = names_in(sketch_folder, ".map");
  if (beside.size() == 1) {
    const std::string file = beside[0] + ".map";
    return {file, sketch_folder / file, fmt::format("the map is {}, the only one beside the sketch", file)};
  }
  const std::string why =
      beside.empty() ? "" : fmt::format(" ({} maps are beside the sketch)", beside.size());
  return {"oval", stock_map_folder() / "oval.map", "the map is oval" + why + "; choose another with --map"};
}

Choice choose_robot(const std::string& name, const fs::path& sketch_folder, const std::string& target) {
  const std::string robot_alone = parse_robot_name(name).robot;
  if (is_path(robot_alone)) {
    check_path("robot", robot_alone);
    return {name, name, ""};
  }
  if (!name.empty()) {
    const auto stock = names_in(stock_robot_folder(), ".toml");
    if (std::find(stock.begin(), stock.end(), robot_alone) == stock.end()) {
      throw InputError(unknown_name("robot", robot_alone, stock) + " (a name with / or . is a path)");
    }
    return {name, name, ""};
  }
  std::error_code error;
  if (fs::exists(sketch_folder / "robot.toml", error)) {
    return {"robot.toml", sketch_folder / "robot.toml", "the robot is robot.toml beside the sketch"};
  }
  const std::string robot = target == "stm32" ? "bluepill5" : "uno5";
  return {
      robot, robot,
      "the robot is " + robot +
          "; choose another with --robot, or put a robot.toml beside the sketch (robosim wire drafts one)"};
}

std::string choose_target(const std::string& name, const SketchChoice& sketch) {
  const bool is_elf = !sketch.elf_target.empty();
  const std::string target = !name.empty() ? name : is_elf ? sketch.elf_target : "host";
  check_target(target);
  if (is_elf && target != sketch.elf_target) {
    throw InputError({sketch.name, 0, 0}, fmt::format("is for the target {}, and --target asks for {}",
                                                      sketch.elf_target, target));
  }
  return target;
}

void check_target(const std::string& target) {
  const auto& available = client::available_targets();
  if (is_one_of(target, available)) return;
  check_exists(target);
  throw ToolMissing(
      fmt::format("this build of Robosim cannot run the target {}; it has {}", target, all_of(available)));
}

void check_build_target(const std::string& target) {
  const auto available = build::targets();
  if (is_one_of(target, available)) return;
  check_exists(target);
  throw ToolMissing(fmt::format("this build of Robosim does not build for the target {}; it has {}", target,
                                all_of(available)));
}

void name_flag(const std::string& flag, const std::function<void()>& check) try {
  check();
} catch (const InputError& error) {
  throw InputError(error.place(), flag + ": " + error.message());
}

}  // namespace robosim::launch
