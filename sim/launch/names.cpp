#include "sim/launch/names.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "sim/base/error.h"
#include "sim/base/file.h"
#include "sim/base/robot_name.h"
#include "sim/build/sketch.h"
#include "sim/client/runner.h"

namespace robosim::launch {
namespace fs = std::filesystem;

namespace {

/// How many letters are wrong, missing or too many; two that are swapped count once, and capitals do not
/// matter.
std::size_t distance(const std::string& a, const std::string& b) {
  const auto small = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; };
  const std::size_t columns = b.size() + 1;
  std::vector<std::size_t> table((a.size() + 1) * columns);
  const auto at = [&](std::size_t i, std::size_t j) -> std::size_t& { return table[i * columns + j]; };
  for (std::size_t i = 0; i <= a.size(); ++i) {
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        at(i, j) = i + j;
        continue;
      }
      const bool differ = small(a[i - 1]) != small(b[j - 1]);
      at(i, j) = std::min({at(i - 1, j - 1) + differ, at(i - 1, j) + 1, at(i, j - 1) + 1});
      if (i > 1 && j > 1 && small(a[i - 1]) == small(b[j - 2]) && small(a[i - 2]) == small(b[j - 1])) {
        at(i, j) = std::min(at(i, j), at(i - 2, j - 2) + 1);
      }
    }
  }
  return at(a.size(), b.size());
}

std::string all_of(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
  }
  return text;
}

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
  // Byte 18 of an ELF file's header names the machine: 40 = ARM, 83 = AVR.
  const std::string content = read_file(file);
  const bool elf = content.size() > 52 && content.starts_with(
                                              "\x7F"
                                              "ELF\x01\x01");
  const int machine = elf ? static_cast<unsigned char>(content[18]) : 0;
  if (machine == 83) return "avr";
  if (machine == 40) return "stm32";
  throw InputError({file.string(), 0, 0},
                   "is no program for a chip that Robosim knows (an AVR or an ARM microcontroller)");
}

bool is_path(const std::string& name) { return name.find_first_of("/.") != std::string::npos; }

std::optional<std::string> nearest(const std::string& word, const std::vector<std::string>& candidates) {
  std::optional<std::string> best;
  std::size_t least = std::max<std::size_t>(word.size() / 3, 1) + 1;
  for (const std::string& candidate : candidates) {
    const std::size_t d = distance(word, candidate);
    if (d < least) {
      least = d;
      best = candidate;
    }
  }
  return best;
}

std::string guess_and_list(const std::string& name, const std::vector<std::string>& candidates) {
  const auto guess = nearest(name, candidates);
  return fmt::format("{}{} {}", guess ? "did you mean " + *guess + "? There " : "there ",
                     candidates.size() == 1 ? "is" : "are", candidates.empty() ? "none" : all_of(candidates));
}

std::string unknown_name(const std::string& what, const std::string& name,
                         const std::vector<std::string>& candidates) {
  return fmt::format("there is no {} “{}”; {}", what, name, guess_and_list(name, candidates));
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
  return {robot, robot,
          "the robot is " + robot + "; choose another with --robot, or put a robot.toml beside the sketch"};
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

}  // namespace robosim::launch
